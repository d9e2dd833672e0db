#pragma once

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/tracking/frame_in_work.h"
#include "semantic_slam/tracking/tracker_options.h"

namespace semantic_slam {

// Decides which images become keyframes, and makes them. The caller holds the map's mutex. Not
// thread-safe.
class KeyframeMaker {
 public:
  // `map` must outlive this. Precondition: the options are valid.
  KeyframeMaker(const TrackerOptions& options, Map& map) : options_(options), map_(map) {}

  // Begins to count anew.
  void Reset();

  // To be called with every image.
  void CountImage() { ++images_since_keyframe_; }

  // After Mur-Artal and Tardos, ORB-SLAM2, section III.E: often rather than seldom, because local
  // mapping takes out what turns out to be redundant. To be called once with every tracked image.
  bool WantsKeyframe(const FrameInWork& frame);

  // Makes the frame a keyframe, which is its reference from then on. Its nearest features that show
  // no map point yet become points, except what moves.
  KeyframeId Insert(const CameraModel& camera, FrameInWork& frame);

 private:
  void AddObservations(KeyframeId keyframe, const FrameInWork& frame);
  void AddPoints(KeyframeId keyframe, const CameraModel& camera, FrameInWork& frame);

  const TrackerOptions options_;
  Map& map_;
  int images_since_keyframe_ = 0;
  int most_inliers_since_keyframe_ = 0;
};

}  // namespace semantic_slam
