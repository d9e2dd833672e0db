#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"
#include "semantic_slam/place_recognition/place_index.h"
#include "semantic_slam/tracking/motion_model.h"
#include "semantic_slam/tracking/pose_optimizer.h"
#include "semantic_slam/tracking/readout_estimator.h"
#include "semantic_slam/tracking/relocalizer.h"

namespace semantic_slam {

struct TrackerOptions {
  double depth_sigma_at_1m_m = 0.02;  // of the depth sensor; grows with depth squared
  double max_point_depth_m =
      4.0;                       // features farther away become map points only where few are near
  int min_initial_points = 100;  // features with depth that a new map needs
  int min_inliers = 15;          // fewer, and the camera counts as lost
  int min_relocalization_inliers = 30;
  int relocalization_keyframes = 20;  // tried per lost image: half that look like it, half by turns
  double search_radius_px = 15.0;     // about the predicted pixel; doubled at the second try
  int max_local_keyframes = 60;       // whose points are looked for in each image
  int max_keyframe_gap = 30;          // images after which a keyframe is wanted anyhow
  double min_tracked_ratio = 0.6;  // a keyframe is wanted when an image shows less than this share
                                   // of the map points that were seen right after the last keyframe
  double new_map_after_s = 1.0;    // lost in sight of enough features for so long, a new map begins
  int max_dormant_keyframes = 2000;  // of maps that were lost and not found again
  int min_new_points =
      100;  // nearest features per keyframe that become points whatever their depth

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("depth_sigma_at_1m_m", self.depth_sigma_at_1m_m, 1e-4, 1.0);
    visit("max_point_depth_m", self.max_point_depth_m, 0.5, 100.0);
    visit("min_initial_points", self.min_initial_points, 20, 10000);
    visit("min_inliers", self.min_inliers, 6, 1000);
    visit("min_relocalization_inliers", self.min_relocalization_inliers, 6, 1000);
    visit("relocalization_keyframes", self.relocalization_keyframes, 1, 1000);
    visit("search_radius_px", self.search_radius_px, 2.0, 200.0);
    visit("max_local_keyframes", self.max_local_keyframes, 1, 1000);
    visit("max_keyframe_gap", self.max_keyframe_gap, 1, 10000);
    visit("min_tracked_ratio", self.min_tracked_ratio, 0.1, 1.0);
    visit("new_map_after_s", self.new_map_after_s, 0.0, 1e6);
    visit("max_dormant_keyframes", self.max_dormant_keyframes, 0, 100000);
    visit("min_new_points", self.min_new_points, 0, 10000);
  }
};

struct TrackerResult {
  TrackedImage image;
  // Set if the image became a keyframe: local mapping's next piece of work.
  std::optional<KeyframeId> new_keyframe;
  // Per feature: whether it shows a map point that supports the pose.
  std::vector<bool> is_inlier;
  // A keyframe was wanted but local mapping was busy.
  bool keyframe_rejected = false;
};

// Thesis section 3.2.1 and 3.2.2: the pose of each image against the map, and the decision which
// images become keyframes. Holds the map's mutex while it works on the map. For one thread.
//
// An image is matched to the one before by a constant-velocity prediction, then to all points of
// the keyframes around; a camera that is lost is found again by keyframes that look alike, or else
// begins a new map.
class Tracker {
 public:
  // Throws ConfigError if an option is out of range. `index` tells which keyframes look like an
  // image; it and `map` must outlive the tracker.
  Tracker(const TrackerOptions& options, const ReadoutOptions& readout_options,
          std::shared_ptr<const CameraModel> camera, Map& map, const PlaceIndex& index);

  // From the exposure of an image's first row to that of its last [s], as far as it is known.
  double readout_s() const { return readout_.readout_s(); }

  // The pose of the image that starts the first map, and every map after a Reset(). One that starts
  // after a loss has the pose that was known last, if there was one.
  void SetStart(const Rigid3d& T_map_camera) { T_map_start_ = T_map_camera; }

  // False: the map stays as it is. No image becomes a keyframe, and a camera that is lost stays so
  // until it comes to a known place. True unless set.
  void SetMapping(bool on);

  // `keyframe_allowed`: whether local mapping can take a keyframe now.
  TrackerResult Track(std::shared_ptr<const FrameFeatures> features, bool keyframe_allowed);

  // Forgets the last image, not the map: to be called with Map::Clear(). Images to come are of
  // `camera`.
  void Reset(std::shared_ptr<const CameraModel> camera);

  // Forgets the last image; the camera is lost somewhere in the map: to be called with Map::Load().
  // odom goes on from where it was.
  void StartLost();

 private:
  // One image on its way through the stages.
  struct Frame {
    std::shared_ptr<const FrameFeatures> features;
    std::vector<PointId> points;  // per feature; kNoPoint where none is matched
    std::vector<bool> is_inlier;  // per feature: its point supports the pose
    Rigid3d T_map_camera = Rigid3d::Identity();
    CameraTwist twist;
    KeyframeId reference = kNoKeyframe;
    Rigid3d T_reference_camera = Rigid3d::Identity();
    int inliers = 0;
  };

  std::optional<RollingShutter> Shutter(const Frame& frame) const;
  void Rectify(Frame& frame, const CameraTwist& twist) const;
  void MeasureTwist(Frame& frame) const;
  void ForgetLast();
  Rigid3d LastPose() const;
  bool CanBeginMap(const Frame& frame) const;
  bool IsLostForLong(const Frame& frame);
  TrackerResult BeginMap(Frame& frame, const Rigid3d& T_map_camera);
  KnownView LastView() const;
  bool TrackFromLast(Frame& frame) const;
  bool MatchNear(const KnownView& view, const Rigid3d& T_map_predicted, double radius_px,
                 Frame& frame) const;
  bool Relocalise(Frame& frame);
  std::vector<KeyframeId> RelocalizationCandidates(const FrameFeatures& features);
  bool TrackLocalMap(Frame& frame, int min_inliers);
  std::vector<PointId> CollectLocalPoints(Frame& frame) const;
  void MatchLocalPoints(Frame& frame, const std::vector<PointId>& local_points);
  void OptimiseFrame(Frame& frame);
  bool WantsKeyframe(const Frame& frame);
  KeyframeId InsertKeyframe(Frame& frame);
  TrackerResult Finish(Frame& frame, TrackingStatus status, std::optional<KeyframeId> new_keyframe);

  const TrackerOptions options_;
  const ObservationNoise noise_;
  std::shared_ptr<const CameraModel> camera_;
  Map& map_;
  const PlaceIndex& index_;

  Rigid3d T_map_start_ = Rigid3d::Identity();
  TrackingStatus status_ = TrackingStatus::kInitializing;
  Frame last_;
  MotionModel motion_;
  ReadoutEstimator readout_;
  std::optional<Rigid3d> T_odom_camera_;  // empty until an image is tracked
  bool mapping_ = true;
  int images_since_keyframe_ = 0;
  int most_inliers_since_keyframe_ = 0;
  int images_since_relocalization_ = 0;
  std::optional<Stamp> unknown_since_;  // lost, and seeing enough all the time
  std::size_t next_old_keyframe_ = 0;   // whose turn it is among the older ones
};

}  // namespace semantic_slam
