#include "semantic_slam/octree/clear_box.h"

#include <array>
#include <map>

#include "semantic_slam/octree/occupied_voxels.h"
#include "semantic_slam/octree/tree_updater.h"

namespace semantic_slam {

std::size_t ClearBox(const Eigen::AlignedBox3d& box_m, SemanticOcTree& tree) {
  std::map<std::array<int, 3>, ScanGrid::Brick> bricks;  // by corner
  std::size_t voxels = 0;
  ForEachOccupiedVoxel(tree, box_m, [&](const octomap::OcTreeKey& key, const SemanticNode&) {
    const std::array<int, 3> corner{key[0] & ~7, key[1] & ~7, key[2] & ~7};
    ScanGrid::Brick& brick = bricks[corner];
    for (unsigned i = 0; i < 3; ++i) brick.corner[i] = static_cast<octomap::key_type>(corner[i]);
    const unsigned place = ScanLayout::PlaceOf(key);
    brick.free[place >> 6] |= std::uint64_t{1} << (place & 63);
    ++voxels;
  });
  // As many rays as it takes from the one bound to the other.
  const float span = tree.getClampingThresMaxLog() - tree.getClampingThresMinLog();
  for (float cleared = 0.0f; cleared < span; cleared -= tree.miss_log_odds()) {
    TreeUpdater updater(tree);
    for (const auto& [corner, brick] : bricks)
      updater.Update(brick, [](SemanticNode&, bool, unsigned) {});
  }
  return voxels;
}

}  // namespace semantic_slam
