#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/semantic_fusion/label_distribution.h"

// What a semantic map knows of a place, and where something is.

namespace semantic_slam {

struct VoxelState {
  bool is_known = false;
  bool is_occupied = false;
  float occupancy = 0.5f;    // probability
  LabelDistribution labels;  // of an occupied voxel
};

// Of the voxel in which `position_m` lies.
VoxelState StateAt(const SemanticOcTree& tree, const Eigen::Vector3d& position_m);

struct VoxelQuery {
  std::optional<LabelId> label;              // the most probable one of a voxel; nullopt: any
  std::optional<Eigen::AlignedBox3d> box_m;  // that holds its centre; nullopt: everywhere
  Eigen::Vector3d near_m = Eigen::Vector3d::Zero();
};

struct VoxelsFound {
  struct OfLabel {
    LabelId label;
    std::size_t voxels;  // the smallest ones
  };
  struct Nearest {
    LabelId label;
    Eigen::Vector3d centre_m;
    double distance_m;  // from the query's `near_m`
  };

  std::vector<OfLabel> labels;     // by ascending id; those with a voxel
  std::size_t voxels = 0;          // of all
  std::optional<Nearest> nearest;  // nullopt: nothing was found
};

// The occupied voxels for which the query holds.
VoxelsFound FindVoxels(const SemanticOcTree& tree, const VoxelQuery& query);

}  // namespace semantic_slam
