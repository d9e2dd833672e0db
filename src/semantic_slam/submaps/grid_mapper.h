#pragma once

#include <cstdint>
#include <optional>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/keyframe_poses.h"
#include "semantic_slam/scan/planar_scan.h"
#include "semantic_slam/scan_matching/scan_matcher.h"
#include "semantic_slam/submaps/grid_slam_options.h"
#include "semantic_slam/submaps/occupancy_map.h"
#include "semantic_slam/submaps/submap_collection.h"

namespace semantic_slam {

// What became of a scan.
enum class InsertOutcome : std::uint8_t {
  kInserted,
  kNotMoved,    // the camera has not moved since the last one: nothing new
  kNotTracked,  // its image has no pose
  kOldMap,      // it belongs to a map that has been forgotten
  kTooFar,      // its pose is outside of what may be mapped
};

// "inserted", "not_moved", "not_tracked", "old_map" or "too_far".
const char* ToString(InsertOutcome outcome);

// Draws the floor plan of thesis section 3.4.2 from planar scans at tracking's poses: submaps that
// hang on keyframes, so that the plan moves with every correction of the keyframe graph.
//
// With GridMapperOptions::match_scans a scan is matched to the older active submap, around
// tracking's pose. What that corrects is never carried over to the next scan, and submaps begin at
// tracking's poses: the plan cannot drift away from the keyframes.
//
// Memory: a submap holds 2 bytes a cell of what can be seen on its way, about 0.15 MB with the
// defaults, so all of them are within 30 MB; Render() takes 3 bytes a cell of the whole plan. Not
// thread-safe.
class GridMapper {
 public:
  // Throws ConfigError if an option is out of range.
  explicit GridMapper(const GridSlamOptions& options = {});

  // Enters what was seen at `image`. A newer map_id than before begins an empty plan; the old one
  // is laid aside.
  InsertOutcome Insert(const PlanarScan& scan, const TrackedImage& image);

  // Moves the submaps to where their keyframes are now. A newer map_id begins an empty plan; what
  // was laid aside comes back when the graph lists its keyframes again, and is forgotten after a
  // reset. An older graph than the last is ignored.
  void FollowGraph(const KeyframeGraph& graph);

  // Grows whenever Render() would give another plan.
  std::uint64_t changes() const { return changes_; }

  // The plan as it is now, in the map frame. Without cells as long as nothing is known.
  OccupancyMap Render() const;

  // Forgets everything but which map it is.
  void Reset();

  std::size_t submaps() const { return submaps_.size(); }

 private:
  bool BelongsToTheMap(int map_id);
  AnchoredScan Anchored(const PlanarScan& scan, const TrackedImage& image) const;
  bool HasMoved(const Rigid3d& T_map_camera) const;

  const GridMapperOptions options_;
  const double reach_m_;  // how far from a submap's frame its walls are
  const ScanMatcher matcher_;
  int map_id_ = 0;
  KeyframePoses keyframes_;
  SubmapCollection submaps_;
  std::optional<Rigid3d> last_T_map_camera_;  // of the scan entered last
  Stamp stamp_;                               // of the newest scan
  std::uint64_t changes_ = 0;
};

}  // namespace semantic_slam
