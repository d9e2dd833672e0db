#include "semantic_slam/ground_truth/voxel_label_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
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

// By label: the one that it counts as; unknown if it does not.
using LabelTable = std::array<LabelId, 256>;

LabelTable TableOf(const ClassList* classes) {
  LabelTable table;
  for (int id = 0; id < 256; ++id) {
    const auto label = static_cast<LabelId>(id);
    const int c = classes ? classes->of_label[label] : kIgnoredClass;
    table[label] = !classes ? label : c == kIgnoredClass ? kUnknownLabel : classes->labels[c];
  }
  return table;
}

// `nearby` is not empty.
void AddVoxel(const CompactLabels& labels, std::vector<NearbySurface> nearby,
              const LabelTable& counts_as, double edge_m, VoxelLabelScore& score) {
  const LabelId label = counts_as[labels.label(0)];
  for (NearbySurface& surface : nearby) surface.label = counts_as[surface.label];
  if (nearby.front().label == kUnknownLabel) {
    ++score.not_counted;
    return;
  }
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
                                 const SurfaceLabels& surfaces, const ClassList* classes) {
  VoxelLabelScore score;
  const LabelTable counts_as = TableOf(classes);
  const double edge_m = tree.getResolution();
  ForEachOccupiedVoxel(tree, [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
    ++score.occupied;
    const octomap::point3d centre = tree.keyToCoord(key);
    const Eigen::Vector3d point(centre.x(), centre.y(), centre.z());
    auto nearby = surfaces.Around(T_world_map * point, edge_m);
    if (nearby.empty()) {
      ++score.without_surface;
    } else {
      AddVoxel(node.labels(), std::move(nearby), counts_as, edge_m, score);
    }
  });
  return score;
}

}  // namespace semantic_slam
