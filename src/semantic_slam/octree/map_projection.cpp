#include "semantic_slam/octree/map_projection.h"

#include <algorithm>

namespace semantic_slam {
namespace {

// Calls visit(leaf, first column's keys, columns along a side) for every leaf at a height that
// counts.
template <typename Visit>
void ForEachLeafAtHeight(const SemanticOcTree& tree, const MapProjectionOptions& options,
                         Visit&& visit) {
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
    // A leaf that is a block counts if one of its voxels does.
    const double half = 0.5 * (leaf.getSize() - tree.getResolution());
    if (leaf.getZ() + half < options.min_z_m || leaf.getZ() - half > options.max_z_m) continue;
    visit(*leaf, tree.LowestKey(leaf.getKey(), leaf.getDepth()),
          1 << (tree.getTreeDepth() - leaf.getDepth()));
  }
}

}  // namespace

ProjectedMap ProjectDown(const SemanticOcTree& tree, const MapProjectionOptions& options) {
  ProjectedMap map;
  map.resolution_m = tree.getResolution();
  int low_x = 65536, low_y = 65536, high_x = 0, high_y = 0;
  ForEachLeafAtHeight(tree, options,
                      [&](const SemanticNode&, const octomap::OcTreeKey& key, int side) {
                        low_x = std::min<int>(low_x, key[0]);
                        low_y = std::min<int>(low_y, key[1]);
                        high_x = std::max(high_x, key[0] + side);
                        high_y = std::max(high_y, key[1] + side);
                      });
  if (low_x >= high_x) return map;
  map.width = high_x - low_x;
  map.height = high_y - low_y;
  const double half = 0.5 * map.resolution_m;
  map.origin_m = {tree.keyToCoord(static_cast<octomap::key_type>(low_x)) - half,
                  tree.keyToCoord(static_cast<octomap::key_type>(low_y)) - half};
  map.cells.assign(static_cast<std::size_t>(map.width) * map.height, ProjectedMap::kUnknown);
  ForEachLeafAtHeight(
      tree, options, [&](const SemanticNode& node, const octomap::OcTreeKey& key, int side) {
        const bool counts = tree.isNodeOccupied(node) && !options.left_out[node.labels().label(0)];
        const std::int8_t cell = counts ? ProjectedMap::kOccupied : ProjectedMap::kFree;
        for (int y = key[1] - low_y; y < key[1] - low_y + side; ++y) {
          std::int8_t* const row = &map.cells[static_cast<std::size_t>(y) * map.width];
          for (int x = key[0] - low_x; x < key[0] - low_x + side; ++x)
            row[x] = std::max(row[x], cell);
        }
      });
  return map;
}

}  // namespace semantic_slam
