#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/map/observation_noise.h"
#include "semantic_slam/tracking/feature_motion.h"

namespace semantic_slam {

struct MovingPartsOptions {
  bool enabled = true;
  double link_radius_m = 0.5;     // features that move alike and are no farther apart hang together
  int min_features = 10;          // that hang together, for something to move there
  int min_images = 3;             // in which something is seen to move there
  double min_moving_share = 0.6;  // of a feature's neighbours in the image, that must move too: a
                                  // body hides what is behind it, a wrong depth at an edge does not
  double max_image_share = 0.4;   // that may be left out: more, and it is the camera's motion that
                                  // is doubted, and nothing is left out
  double hold_s = 0.4;  // what moved is left out for so long after it was last seen to move

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("enabled", self.enabled);
    visit("link_radius_m", self.link_radius_m, 0.01, 5.0);
    visit("min_features", self.min_features, 2, 1000);
    visit("min_images", self.min_images, 1, 100);
    visit("min_moving_share", self.min_moving_share, 0.0, 1.0);
    visit("max_image_share", self.max_image_share, 0.0, 1.0);
    visit("hold_s", self.hold_s, 0.0, 60.0);
  }
};

// Finds what moves in a scene by geometry alone: features that are not where a camera in a rigid
// world would see them, near each other and moving alike (after the residual clusters of Scona et
// al., StaticFusion, ICRA 2018, and the correlated points of Dai et al., TPAMI 2022). Not
// thread-safe.
class MovingParts {
 public:
  // Throws ConfigError if an option is out of range. `scales` are the feature pyramid's.
  MovingParts(const MovingPartsOptions& options, const FeatureMotionOptions& motion_options,
              const ObservationNoise& noise, std::vector<float> scales);

  // Per feature of the next image: it is on something that moves. So is what is near that and is
  // not seen to stand still. `T_last_camera` is about how the camera moved since the image before,
  // `known` are features that move for another reason.
  std::vector<bool> Find(std::shared_ptr<const FrameFeatures> features,
                         const Rigid3d& T_last_camera, const std::vector<bool>& known,
                         const CameraModel& camera);

  // The next image has nothing to do with the one before.
  void Reset();

 private:
  using Motions = std::vector<FeatureMotion>;
  // A place on something that moves.
  struct Place {
    Eigen::Vector3d position;
    Eigen::Vector3d velocity_mps;
    Stamp seen;
    bool is_sure;  // something was seen to move there often enough

    Eigen::Vector3d At(Stamp now) const {
      return position + SecondsBetween(seen, now) * velocity_mps;
    }
  };

  std::vector<int> AmongTheirKind(const FrameFeatures& features, const Motions& motions) const;
  std::vector<std::vector<int>> Clusters(std::vector<int> left, const Motions& motions) const;
  void Remember(const std::vector<int>& cluster, const Motions& motions, Stamp now);
  bool WasSeenBefore(const std::vector<int>& cluster, const Motions& motions, Stamp now) const;
  bool IsNearPlace(const Eigen::Vector3d& position, Stamp now) const;

  const MovingPartsOptions options_;
  FeatureMotions motions_;
  std::vector<Place> places_;
};

// Marks of features without depth, which cannot be placed, what most features with depth around
// them in the image are.
void MarkWithoutDepth(const FrameFeatures& features, const CameraModel& camera,
                      std::vector<bool>& marked);

}  // namespace semantic_slam
