#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/common/pose_covariance.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"

// The keyframe protocol: how everything downstream follows the camera, also after its map has been
// corrected. "keyframe" and "camera" are the colour camera's optical frame at the keyframe's and at
// the image's stamp. docs/frames.md tells the whole of it.

namespace semantic_slam {

using KeyframeId = std::int64_t;
constexpr KeyframeId kNoKeyframe = -1;

enum class TrackingStatus : std::uint8_t {
  kInitializing = 0,  // no map yet: too few features with depth so far
  kTracking = 1,      // the pose is valid
  kLost = 2,          // no pose for this image; looking for a known place
};

// "initializing", "tracking" or "lost".
const char* ToString(TrackingStatus status);

// What became of one image. The pose members are meaningful only with kTracking.
struct TrackedImage {
  Stamp stamp;
  TrackingStatus status = TrackingStatus::kInitializing;
  int map_id = 0;
  KeyframeId keyframe_id = kNoKeyframe;  // the image's reference keyframe
  Rigid3d T_keyframe_camera = Rigid3d::Identity();
  Rigid3d T_map_camera = Rigid3d::Identity();   // may jump when the map is corrected
  Rigid3d T_odom_camera = Rigid3d::Identity();  // smooth, drifts
  // Of T_map_camera: how well the points that this image shows tell it. Of the drift since the map
  // began it knows nothing. Large without kTracking, and where a pose was only predicted.
  Matrix6d covariance = UnknownPoseCovariance();
  int inliers = 0;  // map points that support the pose
  bool is_keyframe = false;
};

struct KeyframeNode {
  KeyframeId id = kNoKeyframe;
  Stamp stamp;
  Rigid3d T_map_keyframe = Rigid3d::Identity();
  KeyframeId parent_id = kNoKeyframe;  // kNoKeyframe for the first keyframe of a map
  Rigid3d T_parent_keyframe = Rigid3d::Identity();
  bool culled = false;  // no longer optimised by itself: it moves rigidly with its parent
};

enum class RevisionReason : std::uint8_t {
  kLocalBa = 0,
  kLoop = 1,
  kMerge = 2,
  kLoad = 3,
  kReset = 4,
  kLost = 5,  // a new map begins; the one before may be joined to it later
};

// Whether maps that were lost before the change can never be joined to the present one.
bool ForgetsLostMaps(RevisionReason reason);

// What was in an older map is in this one again.
struct MapMerge {
  int old_map_id = 0;
  int new_map_id = 0;
  Rigid3d T_new_old = Rigid3d::Identity();
};

// The whole graph of one map, by ascending id. Ids are never used again.
struct KeyframeGraph {
  int map_id = 0;
  std::uint64_t revision = 0;  // grows with every change
  RevisionReason reason = RevisionReason::kLocalBa;
  std::optional<MapMerge> merge;  // with kMerge
  std::vector<KeyframeNode> keyframes;
};

}  // namespace semantic_slam
