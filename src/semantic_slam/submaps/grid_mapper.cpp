#include "semantic_slam/submaps/grid_mapper.h"

#include <algorithm>
#include <cmath>

#include "semantic_slam/camera/level_frame.h"

namespace semantic_slam {

const char* ToString(InsertOutcome outcome) {
  switch (outcome) {
    case InsertOutcome::kInserted:
      return "inserted";
    case InsertOutcome::kNotMoved:
      return "not_moved";
    case InsertOutcome::kNotTracked:
      return "not_tracked";
    case InsertOutcome::kOldMap:
      return "old_map";
    case InsertOutcome::kTooFar:
      return "too_far";
  }
  return "";
}

GridMapper::GridMapper(const GridSlamOptions& options)
    : options_(Validated(options.grid_mapper)),
      reach_m_(options.scan.max_range_m + options.submaps.min_distance_m),
      matcher_(options.scan_matcher, options.correlative_matcher, options.ceres_matcher),
      submaps_(options.submaps, options.scan_inserter, options_.max_submaps) {}

InsertOutcome GridMapper::Insert(const PlanarScan& scan, const TrackedImage& image) {
  if (image.status != TrackingStatus::kTracking) return InsertOutcome::kNotTracked;
  if (!BelongsToTheMap(image.map_id)) return InsertOutcome::kOldMap;
  AnchoredScan anchored = Anchored(scan, image);
  const Rigid3d T_map_camera = anchored.T_map_keyframe * image.T_keyframe_camera;
  const bool is_near = T_map_camera.translation().norm() <= options_.max_distance_m;
  if (!is_near || !IsFinite(T_map_camera)) return InsertOutcome::kTooFar;
  if (!HasMoved(T_map_camera)) return InsertOutcome::kNotMoved;
  if (options_.match_scans) {
    anchored.T_map_scan = submaps_.Match(matcher_, scan, anchored.T_map_scan);
  }
  submaps_.Insert(anchored);
  last_T_map_camera_ = T_map_camera;
  stamp_ = std::max(stamp_, scan.stamp);
  ++changes_;
  return InsertOutcome::kInserted;
}

void GridMapper::FollowGraph(const KeyframeGraph& graph) {
  if (!BelongsToTheMap(graph.map_id)) return;
  if (keyframes_.map_id() == graph.map_id && graph.revision < keyframes_.revision()) return;
  keyframes_ = KeyframePoses(graph);
  if (ForgetsLostMaps(graph.reason)) submaps_.ForgetLaidAside();
  bool moved = submaps_.TakeBack(keyframes_);
  for (Submap* submap : submaps_.all()) {
    const auto T_map_keyframe = keyframes_.Find(submap->keyframe());
    if (!T_map_keyframe) continue;
    moved |= submap->Follow(*T_map_keyframe, reach_m_, options_.follow_threshold_m);
  }
  if (moved) ++changes_;
}

OccupancyMap GridMapper::Render() const {
  OccupancyMap map = submaps_.Render();
  map.stamp = stamp_;
  map.map_id = map_id_;
  map.revision = keyframes_.revision();
  return map;
}

void GridMapper::Reset() {
  if (submaps() > 0) ++changes_;
  submaps_.Reset();
  last_T_map_camera_.reset();
  stamp_ = Stamp();
}

// Begins anew if the map is a newer one; false if it is an older one.
bool GridMapper::BelongsToTheMap(int map_id) {
  if (map_id > map_id_) {
    if (submaps() > 0) ++changes_;
    submaps_.LayAside();
    last_T_map_camera_.reset();
    stamp_ = Stamp();
    map_id_ = map_id;
  }
  return map_id == map_id_;
}

// Today's pose of the image's keyframe counts, as submaps follow it too; before the graph lists it,
// what tracking said.
AnchoredScan GridMapper::Anchored(const PlanarScan& scan, const TrackedImage& image) const {
  std::optional<Rigid3d> T_map_keyframe;
  if (keyframes_.map_id() == image.map_id) T_map_keyframe = keyframes_.Find(image.keyframe_id);
  if (!T_map_keyframe) T_map_keyframe = image.T_map_camera * image.T_keyframe_camera.inverse();
  const Rigid3d T_map_level = LevelPose(*T_map_keyframe * image.T_keyframe_camera);
  return {scan, Flattened(T_map_level), image.keyframe_id, *T_map_keyframe,
          T_map_keyframe->inverse() * T_map_level};
}

bool GridMapper::HasMoved(const Rigid3d& T_map_camera) const {
  if (!last_T_map_camera_) return true;
  const Rigid3d motion = last_T_map_camera_->inverse() * T_map_camera;
  return motion.translation().norm() > options_.min_motion_m ||
         RotationAngle(motion.linear()) > options_.min_turn_deg * M_PI / 180.0;
}

}  // namespace semantic_slam
