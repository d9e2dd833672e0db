#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/place_recognition/place_index.h"
#include "semantic_slam/tracking/frame_in_work.h"
#include "semantic_slam/tracking/keyframe_maker.h"
#include "semantic_slam/tracking/lost_camera.h"
#include "semantic_slam/tracking/motion_model.h"
#include "semantic_slam/tracking/moving_parts.h"
#include "semantic_slam/tracking/pose_fitter.h"
#include "semantic_slam/tracking/readout_estimator.h"
#include "semantic_slam/tracking/relocalizer.h"
#include "semantic_slam/tracking/semantic_mask.h"
#include "semantic_slam/tracking/tracker_options.h"

namespace semantic_slam {

// What tells which features are on things that move, in the groups that configuration files use.
struct MovingThingsOptions {
  FeatureMotionOptions feature_motion;
  MovingPartsOptions moving_parts;
  SemanticMaskOptions semantic_mask;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("feature_motion", self.feature_motion);
    visit_group("moving_parts", self.moving_parts);
    visit_group("semantic_mask", self.semantic_mask);
  }
};

struct TrackerResult {
  TrackedImage image;
  // Set if the image became a keyframe: local mapping's next piece of work.
  std::optional<KeyframeId> new_keyframe;
  // Per feature: whether it shows a map point that supports the pose,
  std::vector<bool> is_inlier;
  // and whether it is left out because what it is on moves.
  std::vector<bool> moves;
  // A keyframe was wanted but local mapping was busy.
  bool keyframe_rejected = false;
};

// Thesis section 3.2.1 and 3.2.2: the pose of each image against the map, and the decision which
// images become keyframes. Holds the map's mutex while it works on the map. For one thread.
//
// An image is matched to the one before by a constant-velocity prediction, then to all points of
// the keyframes around; a camera that is lost is found again by keyframes that look alike, or else
// begins a new map. Features on what moves are left out of poses and map: they show classes that
// are to be left out, or they are not where a camera in a rigid world would see them.
class Tracker {
 public:
  // Throws ConfigError if an option is out of range. `index` tells which keyframes look like an
  // image; it and `map` must outlive the tracker.
  Tracker(const TrackerOptions& options, const ReadoutOptions& readout_options,
          std::shared_ptr<const CameraModel> camera, Map& map, const PlaceIndex& index,
          const MovingThingsOptions& moving_options = {});

  // From the exposure of an image's first row to that of its last [s], as far as it is known.
  double readout_s() const { return fitter_.readout_s(); }

  // The pose of the image that starts the first map, and every map after a Reset(). One that starts
  // after a loss has the pose that was known last, if there was one.
  void SetStart(const Rigid3d& T_map_camera) { T_map_start_ = T_map_camera; }

  // False: the map stays as it is. No image becomes a keyframe, and a camera that is lost stays so
  // until it comes to a known place. True unless set.
  void SetMapping(bool on);

  // What an image shows, tracked or not yet tracked, and which classes of it are to be left out.
  LabelImageFate AddLabels(const LabelImage& image);

  // `keyframe_allowed`: whether local mapping can take a keyframe now.
  TrackerResult Track(std::shared_ptr<const FrameFeatures> features, bool keyframe_allowed);

  // Forgets the last image, not the map: to be called with Map::Clear(). Images to come are of
  // `camera`.
  void Reset(std::shared_ptr<const CameraModel> camera);

  // Forgets the last image; the camera is lost somewhere in the map: to be called with Map::Load().
  // odom goes on from where it was.
  void StartLost();

 private:
  void MeasureTwist(FrameInWork& frame) const;
  void ForgetLast();
  Rigid3d LastPose() const;
  TrackerResult BeginMap(FrameInWork& frame, const Rigid3d& T_map_camera);
  TrackerResult StayLost(FrameInWork& frame);
  TrackerResult FinishTracked(FrameInWork& frame, bool keyframe_allowed);
  KnownView LastView() const;
  bool TrackFromLast(FrameInWork& frame);
  void LeaveOutMasked(const Rigid3d& T_last_camera, FrameInWork& frame) const;
  void LeaveOutMoving(FrameInWork& frame);
  bool Relocalise(FrameInWork& frame);
  bool TrackLocalMap(FrameInWork& frame, int min_inliers);
  void AdvanceOdom(const FrameInWork& frame, bool was_tracking);
  TrackerResult Finish(FrameInWork& frame, TrackingStatus status,
                       std::optional<KeyframeId> new_keyframe);

  const TrackerOptions options_;
  Map& map_;
  PoseFitter fitter_;
  KeyframeMaker keyframes_;
  LostCamera lost_;
  MovingParts moving_;
  SemanticMask mask_;

  Rigid3d T_map_start_ = Rigid3d::Identity();
  TrackingStatus status_ = TrackingStatus::kInitializing;
  FrameInWork last_;
  MotionModel motion_;
  std::optional<Rigid3d> T_odom_camera_;  // empty until an image is tracked
  bool mapping_ = true;
};

}  // namespace semantic_slam
