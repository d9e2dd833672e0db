#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <octomap/octomap_types.h>

#include <octomap/OcTreeKey.h>  // needs what the one above includes

#include "semantic_octree/synthetic_room.h"

namespace semantic_slam {

// A mapper that is measured.
class MappingMethod {
 public:
  using VisitVoxel = std::function<void(const octomap::OcTreeKey& key, LabelId label)>;

  virtual ~MappingMethod() = default;

  // Brings the image into the form in which the mapper takes it, in the camera's frame; may take
  // the points. Not timed.
  virtual void Prepare(synthetic_room::Frame& frame) = 0;

  // From that form and the pose to the map. Timed.
  virtual void Insert(const synthetic_room::Frame& frame) = 0;

  // Frees what Prepare() has made. Not timed.
  virtual void Release() {}

  virtual std::size_t Leaves() const = 0;
  virtual std::size_t Nodes() const = 0;
  virtual std::size_t MapBytes() const = 0;

  // Serialises the whole map; returns its size.
  virtual std::size_t Serialise() const = 0;

  // Every occupied voxel, the smallest ones; kUnknownLabel if it has no label.
  virtual void ForEachOccupied(const VisitVoxel& visit) const = 0;

  // Log-odds of the voxel, NaN if it is unknown.
  virtual float LogOdds(const octomap::OcTreeKey& key) const = 0;

  // Calls visit(key, 0) for every known voxel, the smallest ones.
  virtual void ForEachKnown(const VisitVoxel& visit) const = 0;
};

struct MappingSettings {
  double resolution_m = 0.05;
  double range_m = 5.0;
};

// The methods' names, the baseline first.
std::vector<std::string> MappingMethodNames();

// Throws ConfigError, listing the names, if `name` is none of them.
std::unique_ptr<MappingMethod> MakeMappingMethod(const std::string& name,
                                                 const MappingSettings& settings);

}  // namespace semantic_slam
