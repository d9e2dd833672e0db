#pragma once

#include <string>

#include <Eigen/Core>

#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/worlds/building.h"
#include "semantic_slam/worlds/furniture.h"
#include "semantic_slam/worlds/world_assembly.h"

namespace semantic_slam {

// Two numbers within 1 km. Throws ConfigError naming file, line and key.
Eigen::Vector2d ReadPlace(YamlReader& reader, const std::string& key);

// What is to be placed.
struct Placeable {
  Mount mount = Mount::kFloor;
  Eigen::Vector3f size_m = Eigen::Vector3f::Zero();
};

// Where what a world file names is put: by a wall, on or beside another piece, or on the plan.
// Not thread-safe; keeps references.
class PlacementReader {
 public:
  PlacementReader(const Building& building, const WorldAssembly& assembly)
      : building_(building), assembly_(assembly) {}

  // Reads `at`, `yaw_deg` and `z_m` with one of `wall` (and `along_m`, `gap_m`), `on`, `beside` or
  // none of them. Names are first looked for with `prefix`; without any, places are in
  // `T_world_frame`. Throws ConfigError naming file, line and key.
  Rigid3d Read(YamlReader& reader, const Placeable& piece, const std::string& prefix,
               const Rigid3d& T_world_frame) const;

 private:
  struct Place;
  Rigid3d AtWall(YamlReader& reader, const Placeable& piece, const Place& place) const;
  Rigid3d OnTop(YamlReader& reader, const Place& place, const std::string& prefix) const;
  double CeilingHeight(const YamlReader& reader, const Eigen::Vector2d& at_m) const;
  const WorldObject& Named(YamlReader& reader, const std::string& key,
                           const std::string& prefix) const;

  const Building& building_;
  const WorldAssembly& assembly_;
};

}  // namespace semantic_slam
