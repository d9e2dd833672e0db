#pragma once

#include <cstdint>
#include <vector>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/octree/scan_grid.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/octree/tree_updater.h"
#include "semantic_slam/semantic_fusion/label_fusion.h"
#include "semantic_slam/semantic_fusion/voxel_observation.h"

namespace semantic_slam {

struct OctreeInserterOptions {
  double max_hit_range_m = 5.0;    // farther points occupy nothing
  double max_clear_range_m = 5.0;  // beyond, rays free nothing
  double min_z_m = -100.0;         // of the voxels that are touched, in the map
  double max_z_m = 100.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_hit_range_m", self.max_hit_range_m, 0.1, 30.0);
    visit("max_clear_range_m", self.max_clear_range_m, 0.1, 30.0);
    visit("min_z_m", self.min_z_m, -1000.0, 1000.0);
    visit("max_z_m", self.max_z_m, -1000.0, 1000.0);
  }
};

// Throws ConfigError if a range is more than 1000 voxels of that size: what a scan costs grows with
// the cube of it.
void CheckRangeInVoxels(const OctreeInserterOptions& options, double resolution_m);

// Enters what one image shows into a tree: every voxel with points gets one observation, and the
// voxels on the way to it are seen to be free. Deterministic. Not thread-safe.
class OctreeInserter {
 public:
  // Throws ConfigError if an option is out of range, or the z limits leave nothing.
  OctreeInserter(const OctreeInserterOptions& options, const LabelFusion& fusion);

  // `observations` are in the camera's optical frame. Returns one observation for each voxel that
  // has any (one more if some of its points are transient), from which the same insertion can be
  // repeated, also at a corrected pose.
  //
  // The occupancy of every voxel becomes, to the bit, what octomap's insertPointCloud(points,
  // origin, range, lazy, discretize) makes of it if both ranges are equal, nothing is transient and
  // z is not limited: end points are voxel centres, each is one ray, and hits win over rays.
  //
  // Points that are outside of the tree's 65536 voxels are left out. Throws InputError if the
  // camera is, or if the pose is not finite; the tree stays as it is then. Precondition:
  // CheckRangeInVoxels() passes.
  std::vector<VoxelObservation> Insert(const std::vector<VoxelObservation>& observations,
                                       const Rigid3d& T_map_camera, SemanticOcTree& tree);

 private:
  // An observation in the map.
  struct Located {
    octomap::point3d position;
    octomap::OcTreeKey key;
    std::uint32_t index;  // into the observations
  };
  using Observations = std::vector<VoxelObservation>;

  void Locate(const Observations& observations, const Rigid3d& T_map_camera,
              const SemanticOcTree& tree);
  void ResetGrid(const SemanticOcTree& tree);
  void SortByVoxel();
  // Of the voxel with the points located_[*begin] to located_[*(end - 1)].
  void InsertVoxel(const std::uint32_t* begin, const std::uint32_t* end,
                   const Observations& observations, const SemanticOcTree& tree,
                   Observations& combined);
  void MarkRay(const octomap::point3d& end, const SemanticOcTree& tree);
  void UpdateTree(const Observations& combined, SemanticOcTree& tree);
  bool IsInside(const octomap::point3d& centre) const;

  const OctreeInserterOptions options_;
  const LabelFusion fusion_;

  // Of the scan at hand, here to keep their memory.
  octomap::point3d origin_;
  octomap::OcTreeKey origin_key_;
  int lowest_z_ = 0;  // keys
  int highest_z_ = 0;
  std::vector<Located> located_;
  std::vector<std::uint32_t> sorted_;       // into located_, voxel by voxel
  std::vector<std::uint32_t> slots_;        // of located_; of those that the grid covers
  std::vector<std::uint32_t> slot_ends_;    // into sorted_
  std::vector<std::uint32_t> hit_of_slot_;  // into what Insert() returns
  ScanGrid grid_;
  ObservationCombiner steady_;
  ObservationCombiner transient_;
};

}  // namespace semantic_slam
