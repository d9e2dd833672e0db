#include "semantic_slam/ground_truth/voxel_label_score.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "semantic_slam/octree/occupied_voxels.h"

namespace semantic_slam {
namespace {

int ObservationBin(int observations) {
  int bin = 0;
  while (observations >= 2 && bin < VoxelLabelScore::kObservationBins - 1) {
    observations /= 2;
    ++bin;
  }
  return bin;
}

void Count(bool is_right, VoxelCount& count) {
  ++count.voxels;
  count.right += is_right;
}

// `nearby` is not empty.
void AddVoxel(const CompactLabels& labels, const std::vector<NearbySurface>& nearby, double edge_m,
              VoxelLabelScore& score) {
  const LabelId label = labels.label(0);
  const double radius_m = std::max(0.5 * std::sqrt(3.0) * edge_m, nearby.front().distance_m);
  const bool is_right =
      std::any_of(nearby.begin(), nearby.end(), [&](const NearbySurface& surface) {
        return surface.label == label && surface.distance_m <= radius_m && label != kUnknownLabel;
      });
  score.unlabelled += label == kUnknownLabel;
  Count(is_right, score.all);
  Count(is_right && label == nearby.front().label, score.strict);
  Count(is_right, score.by_class[nearby.front().label]);
  Count(is_right, score.by_observations[ObservationBin(labels.observations())]);
}

}  // namespace

double VoxelCount::share() const {
  return voxels > 0 ? static_cast<double>(right) / static_cast<double>(voxels) : 0.0;
}

VoxelLabelScore ScoreVoxelLabels(const SemanticOcTree& tree, const Rigid3d& T_world_map,
                                 const SurfaceLabels& surfaces) {
  VoxelLabelScore score;
  const double edge_m = tree.getResolution();
  ForEachOccupiedVoxel(tree, [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
    ++score.occupied;
    const octomap::point3d centre = tree.keyToCoord(key);
    const Eigen::Vector3d point(centre.x(), centre.y(), centre.z());
    const auto nearby = surfaces.Around(T_world_map * point, edge_m);
    if (nearby.empty()) {
      ++score.without_surface;
    } else {
      AddVoxel(node.labels(), nearby, edge_m, score);
    }
  });
  return score;
}

}  // namespace semantic_slam
