#pragma once

#include <cstddef>

#include <Eigen/Geometry>

#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Makes the occupied voxels whose centre lies in the box as free as a voxel can be; those that are
// not known stay so. Returns how many there were.
std::size_t ClearBox(const Eigen::AlignedBox3d& box_m, SemanticOcTree& tree);

}  // namespace semantic_slam
