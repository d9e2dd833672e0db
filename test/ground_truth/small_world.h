#pragma once

#include <string>
#include <utility>
#include <vector>

#include "semantic_slam/worlds/world.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam {

// Labels of SmallVocabulary().
constexpr LabelId kWall = 1;
constexpr LabelId kFloor = 2;
constexpr LabelId kChair = 3;
constexpr LabelId kTable = 4;
constexpr LabelId kLamp = 9;

inline Mesh Merged(const std::vector<Mesh>& meshes) {
  Mesh merged;
  for (const Mesh& mesh : meshes) Append(merged, mesh);
  return merged;
}

// An object of one surface.
inline WorldObject MakeObject(LabelId label, Mesh mesh,
                              const Rigid3d& T_world_object = Rigid3d::Identity()) {
  WorldObject object;
  object.label = label;
  object.T_world_object = T_world_object;
  object.surfaces.push_back({std::move(mesh), 0, {}});
  return object;
}

inline WorldObject MakeStructure(LabelId label, Mesh mesh) {
  WorldObject object = MakeObject(label, std::move(mesh));
  object.is_structure = true;
  return object;
}

// Numbers the objects and works out the bounds.
inline World MakeWorld(std::vector<WorldObject> objects) {
  World world;
  world.vocabulary_hash = SmallVocabulary().hash();
  world.materials.emplace_back();
  for (WorldObject& object : objects) {
    object.instance = static_cast<InstanceId>(world.objects.size() + 1);
    world.objects.push_back(std::move(object));
    const WorldObject& added = world.objects.back();
    if (added.IsMoving()) continue;
    for (const Surface& surface : added.surfaces) {
      for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
        world.bounds_m.extend(added.T_world_object * p.cast<double>());
      }
    }
  }
  return world;
}

// A sheet, facing up.
inline Mesh FloorMesh(float width_m, float depth_m) {
  return QuadMesh({0, depth_m, 0}, {width_m, 0, 0}, {0, -depth_m, 0});
}

// Walls of 0.1 m around [0, width] x [0, depth], 2.5 m high.
inline Mesh WallsMesh(float width_m, float depth_m) {
  const float z = 1.25f, height = 2.5f, t = 0.1f;
  return Merged({BoxMesh({0.5f * width_m, -0.5f * t, z}, {width_m + 2 * t, t, height}),
                 BoxMesh({0.5f * width_m, depth_m + 0.5f * t, z}, {width_m + 2 * t, t, height}),
                 BoxMesh({-0.5f * t, 0.5f * depth_m, z}, {t, depth_m, height}),
                 BoxMesh({width_m + 0.5f * t, 0.5f * depth_m, z}, {t, depth_m, height})});
}

// A top of 1.2 m x 0.8 m, 0.70 to 0.74 m high, about the z axis, on four legs of 5 cm.
inline Mesh TableMesh() {
  Mesh mesh = BoxMesh({0, 0, 0.72f}, {1.2f, 0.8f, 0.04f});
  for (const float x : {-0.55f, 0.55f}) {
    for (const float y : {-0.35f, 0.35f})
      Append(mesh, BoxMesh({x, y, 0.35f}, {0.05f, 0.05f, 0.7f}));
  }
  return mesh;
}

inline Rigid3d At(double x_m, double y_m, double yaw_rad = 0.0) {
  return Eigen::Translation3d(x_m, y_m, 0.0) *
         Rigid3d(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

// A room of 4 m x 3 m with a table in its middle and a lamp, 1.7 m high, in a corner.
inline World SmallWorld() {
  return MakeWorld({MakeStructure(kFloor, FloorMesh(4, 3)), MakeStructure(kWall, WallsMesh(4, 3)),
                    MakeObject(kTable, TableMesh(), At(2.0, 1.5)),
                    MakeObject(kLamp, CylinderMesh({0, 0, 0}, 0.15f, 0.15f, 1.7f), At(3.5, 2.5))});
}

}  // namespace semantic_slam
