#pragma once

#include <array>
#include <cstddef>
#include <map>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/ground_truth/surface_labels.h"
#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Of some voxels that have a surface: how many there are, and how many have its class.
struct VoxelCount {
  std::size_t voxels = 0;
  std::size_t right = 0;

  // 0 without voxels.
  double share() const;
};

// How far the occupied voxels of a semantic octree tell the truth. A voxel has a surface if one is
// within an edge of its centre; the nearest one is its own. Its label is right if a surface of that
// class passes through the sphere around it, or else is the nearest: a voxel at the foot of a chair
// holds chair and floor.
struct VoxelLabelScore {
  // Voxels that were observed 1, 2 to 3, 4 to 7, 8 to 15, 16 to 31, 32 times and more.
  static constexpr int kObservationBins = 6;

  std::size_t occupied = 0;
  std::size_t without_surface = 0;  // of those: farther than an edge from any surface
  std::size_t not_counted = 0;      // of those: the nearest surface's label is none of the classes
  std::size_t unlabelled = 0;       // of those with a surface: no class is known; never right
  VoxelCount all;                   // of those with a surface that counts
  VoxelCount strict;                // the same, where only the nearest surface's class is right
  std::map<LabelId, VoxelCount> by_class;  // of the nearest surface
  std::array<VoxelCount, kObservationBins> by_observations;
};

// Compares a map that lies at T_world_map with its world's surfaces. With `classes` labels count as
// those say, in the map and in the world; without, each as itself.
VoxelLabelScore ScoreVoxelLabels(const SemanticOcTree& tree, const Rigid3d& T_world_map,
                                 const SurfaceLabels& surfaces, const ClassList* classes = nullptr);

}  // namespace semantic_slam
