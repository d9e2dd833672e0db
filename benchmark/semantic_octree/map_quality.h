#pragma once

#include "semantic_octree/mapping_method.h"

namespace semantic_slam {

// How a map compares with the room without noise, by the smallest voxels. All but the counts are
// parts of 1.
struct MapQuality {
  std::size_t true_voxels = 0;      // that a surface in range of some image lies in
  std::size_t occupied_voxels = 0;  // of the map
  double recall = 0.0;              // of the true voxels
  double precision = 0.0;           // occupied voxels in or beside a true one
  double label_accuracy = 0.0;      // of occupied true voxels with a label
  double unlabelled = 0.0;          // of the occupied voxels
  double alien = 0.0;               // of the occupied voxels, with a label that is no class
};

// Of the map after the first `frames` images.
MapQuality JudgeMap(const MappingMethod& method, const MappingSettings& settings, int frames);

}  // namespace semantic_slam
