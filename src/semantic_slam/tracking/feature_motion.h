#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

struct FeatureMotionOptions {
  double window_s = 0.25;         // how far back the image lies that others are compared with
  double min_vote_share = 0.75;   // of features in all parts of the image, that must agree on how
                                  // the camera moves; with less, nothing is said
  double timing_sigma_s = 0.005;  // of exposure, by row and between colour and depth: where things
                                  // seem to be is that unsure while the camera moves
  double deviation_sigmas = 3.0;  // from where it were if it stood still, in standard deviations of
                                  // pixels and depth; with more a feature moves
  double min_speed_mps = 0.2;     // what is slower than that is taken to stand still,
  double max_speed_mps = 3.0;     // what is faster is not looked for

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("window_s", self.window_s, 0.05, 5.0);
    visit("min_vote_share", self.min_vote_share, 0.1, 1.0);
    visit("timing_sigma_s", self.timing_sigma_s, 0.0, 1.0);
    visit("deviation_sigmas", self.deviation_sigmas, 1.0, 100.0);
    visit("min_speed_mps", self.min_speed_mps, 0.0, 10.0);
    visit("max_speed_mps", self.max_speed_mps, self.min_speed_mps, 100.0);
  }
};

// What one feature of the present image does, in a frame that stands still for a while.
struct FeatureMotion {
  enum class Verdict { kUnknown, kStill, kMoves };
  Verdict verdict = Verdict::kUnknown;
  std::optional<Eigen::Vector3d> position;                 // [m]; none without depth
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();  // with kMoves
};

// Compares each image with one of a moment before, apart from the map, and tells which features a
// camera that moves through a rigid world would not see where they are. How the camera moves, a
// vote says in which every part of the image has the same weight: a person is few pixels, but may
// be many features. Not thread-safe.
class FeatureMotions {
 public:
  // Throws ConfigError if an option is out of range. `scales` are the feature pyramid's.
  FeatureMotions(const FeatureMotionOptions& options, const ObservationNoise& noise,
                 std::vector<float> scales);

  // What the features of the next image do. `T_last_camera` is about how the camera moved since the
  // image before.
  std::vector<FeatureMotion> Follow(std::shared_ptr<const FrameFeatures> features,
                                    const Rigid3d& T_last_camera, const CameraModel& camera);

  // Per feature of the image followed last: it is on something that moves, and has no vote on how
  // the camera does.
  void LeaveOut(const std::vector<bool>& moves) { images_.back().moves = moves; }

  // The next image has nothing to do with the one before.
  void Reset() { images_.clear(); }

 private:
  struct Image {
    std::shared_ptr<const FrameFeatures> features;
    Rigid3d T_still_camera = Rigid3d::Identity();
    double turn_radps = 0.0;  // of the camera, and its speed
    double speed_mps = 0.0;
    std::vector<bool> moves;  // per feature
  };
  // A feature of the image before, and where the present one shows it.
  struct Pair {
    int then, now;
  };

  std::vector<Pair> Match(const Image& then, const Image& now, const std::vector<int>& wanted,
                          const std::vector<bool>& is_taken, double speed_mps,
                          const CameraModel& camera) const;
  void JudgeAll(const Image& then, const std::vector<Pair>& near, const Image& now,
                const CameraModel& camera, std::vector<FeatureMotion>& motions) const;
  bool MoveCamera(const Image& then, const std::vector<Pair>& pairs, Image& now,
                  const CameraModel& camera) const;
  FeatureMotion Judge(const Image& then, const Image& now, const Pair& pair,
                      const CameraModel& camera) const;
  double SigmaPx(const Image& image, const Feature& feature, const CameraModel& camera) const;

  const FeatureMotionOptions options_;
  const ObservationNoise noise_;
  const std::vector<float> scales_;
  std::deque<Image> images_;  // of the last window_s
};

}  // namespace semantic_slam
