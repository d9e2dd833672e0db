#pragma once

#include <memory>

#include "semantic_octree/mapping_method.h"

namespace semantic_slam {

enum class InnerNodes {
  kEager,  // brought up to date by every voxel that changes
  kLazy,   // all of them after every image
};

// OctoMap's own insertPointCloud(), with discretised end points: occupancy alone.
std::unique_ptr<MappingMethod> MakeOctomapMethod(const MappingSettings& settings, InnerNodes inner);

// The lazy one, of points that are brought into the map as our mapper does it: OctoMap's own
// transform rounds otherwise, so that a few in a million points fall into the voxel beside. Not to
// be timed.
std::unique_ptr<MappingMethod> MakeSamePointsMethod(const MappingSettings& settings);

// Eagerly into a ColorOcTree, and averageNodeColor() for every point.
std::unique_ptr<MappingMethod> MakeColourOctomapMethod(const MappingSettings& settings);

}  // namespace semantic_slam
