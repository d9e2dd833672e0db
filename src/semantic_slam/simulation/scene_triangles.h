#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/simulation/light_grid.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

constexpr int kNoGrid = -1;

// Some of the lamps of a world: bit i % 64 stands for lamp i, and in a large world for more of
// them.
using LampSet = std::uint64_t;
constexpr LampSet kAllLamps = ~LampSet{0};

inline LampSet OnlyLamp(std::size_t i) {
  return LampSet{1} << (i % 64);
}

struct SceneCorner {
  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;
  Eigen::Vector2f texture_m;
};

struct SceneTriangle {
  Eigen::Vector3d normal;  // of its plane, of unit length
  double offset_m = 0.0;   // normal . p of all points p of the plane
  Eigen::Vector3i corners = Eigen::Vector3i::Zero();
  int surface = 0;            // index into SceneTriangles::surfaces
  int part = 0;               // triangles of one smooth piece of surface have the same
  int grid = kNoGrid;         // that knows its light; without one, its corners do
  LampSet lamps = kAllLamps;  // that may shine on it
};

// What all triangles of a Surface of the world have in common.
struct SceneSurface {
  InstanceId instance = kNoInstance;
  LabelId label = kUnknownLabel;
  int material = 0;
};

// Whether a surface is ever elsewhere: its object walks, or it swings by itself.
inline bool Moves(const WorldObject& object, const Surface& surface) {
  return object.IsMoving() || surface.swing.has_value();
}

// Triangles in the world frame, as they are traced and shaded.
struct SceneTriangles {
  std::vector<SceneCorner> corners;
  std::vector<LightSample> corner_light;  // one per corner
  std::vector<SceneTriangle> triangles;
  std::vector<SceneSurface> surfaces;

  // Adds a surface without triangles; those added next belong to it.
  void AddSurface(const WorldObject& object, const Surface& surface);

  // Adds the triangles of one smooth piece, moved by T_world_part.
  void AddPart(const Mesh& part, const Rigid3d& T_world_part, int part_id, int grid);

  std::vector<Eigen::Vector3f> Positions() const;
  std::vector<Eigen::Vector3i> Corners() const;
};

// Where a ray has met a surface.
struct SurfacePoint {
  const SceneTriangle* triangle = nullptr;
  const SceneSurface* surface = nullptr;
  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;  // of the smooth surface, towards where the ray came from
  Eigen::Vector2f texture_m;
  Eigen::Vector3f irradiance;  // of lamps, walls and all else that stands still: blue, green, red
};

// The point of a triangle with the weights `barycentric` of its second and third corner, seen along
// `direction`. `grids` are those that triangles name.
SurfacePoint PointOn(const SceneTriangles& scene, const std::vector<LightGrid>& grids,
                     unsigned triangle, const Eigen::Vector2f& barycentric,
                     const Eigen::Vector3f& position_m, const Eigen::Vector3f& direction);

}  // namespace semantic_slam
