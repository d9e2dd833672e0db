#pragma once

#include <cstdint>
#include <vector>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/octree/ray_layer.h"
#include "semantic_slam/octree/scan_grid.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/semantic_cloud/check_cloud.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"
#include "semantic_slam/semantic_fusion/label_fusion.h"
#include "semantic_slam/semantic_fusion/voxel_observation.h"
#include "semantic_slam/semantic_fusion/voxel_sums.h"

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

  // `points` are in the camera's optical frame. Those whose most probable label is in `transient`
  // are only seen; the others say nothing of such labels, so that no map ever shows one. Returns
  // one observation for each voxel with points, one more if some are only seen, from which the same
  // insertion can be repeated, also at a corrected pose; they are valid until the next call.
  //
  // The occupancy of every voxel becomes, to the bit, what octomap's insertPointCloud(points,
  // origin, range, lazy, discretize) makes of it if both ranges are equal, nothing is transient and
  // z is not limited: end points are voxel centres, each is one ray, and hits win over rays.
  //
  // Points that are outside of the tree's 65536 voxels are left out. Throws InputError if the
  // camera is, or if the pose is not finite; the tree stays as it is then. Preconditions:
  // CheckRangeInVoxels() passes, and `contents` is what CheckSemanticCloud() has found.
  const std::vector<VoxelObservation>& Insert(const std::vector<SemanticPoint>& points,
                                              const CloudContents& contents,
                                              const LabelMask& transient,
                                              const Rigid3d& T_map_camera, SemanticOcTree& tree);
  const std::vector<VoxelObservation>& Insert(const std::vector<VoxelObservation>& observations,
                                              const Rigid3d& T_map_camera, SemanticOcTree& tree);

 private:
  using Observations = std::vector<VoxelObservation>;

  // `Points` is read by index; see the source.
  template <typename Points>
  const Observations& InsertPoints(const Points& points, const Rigid3d& T_map_camera,
                                   SemanticOcTree& tree);

  void SetOrigin(const Rigid3d& T_map_camera, const SemanticOcTree& tree);
  void ResetGrid(const Eigen::AlignedBox3f& around_m, const Rigid3d& T_map_camera,
                 const SemanticOcTree& tree);
  template <typename Points>
  void SumUp(const Points& points, const Rigid3d& T_map_camera, const SemanticOcTree& tree);
  ScanGrid::EndId AddEnd(const std::array<int, 3>& key);
  // Judges every voxel with points, and says where rays end.
  void Combine(const Rigid3d& T_map_camera, const SemanticOcTree& tree);
  void MarkRays(const SemanticOcTree& tree);
  void UpdateTree(SemanticOcTree& tree);

  octomap::point3d RayEnd(const octomap::point3d& centre) const;
  bool IsInside(const octomap::point3d& centre) const;

  const OctreeInserterOptions options_;
  const LabelFusion fusion_;

  // Of the scan at hand, here to keep their memory.
  octomap::point3d origin_;
  octomap::OcTreeKey origin_key_;
  ScanGrid grid_;
  RayLayer rays_;
  VoxelSums sums_;
  std::vector<bool> is_seen_through_;             // by end: nothing stays there
  std::vector<octomap::OcTreeKey> out_of_reach_;  // of points that the grid does not cover
  std::vector<octomap::point3d> ray_ends_;
  Observations combined_;                   // what Insert() returns
  std::vector<std::uint32_t> combined_of_;  // into combined_
};

}  // namespace semantic_slam
