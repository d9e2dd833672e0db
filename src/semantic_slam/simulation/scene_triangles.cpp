#include "semantic_slam/simulation/scene_triangles.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

Eigen::Vector3f LightOfCorners(const SceneTriangles& scene, const SceneTriangle& triangle,
                               const Eigen::Vector3f& weights) {
  LightSample light = LightSample::Zero();
  for (int i = 0; i < 3; ++i) light += weights[i] * scene.corner_light[triangle.corners[i]];
  return light.head<3>() / std::max(light[3], 1e-6f);
}

}  // namespace

void SceneTriangles::AddSurface(const WorldObject& object, const Surface& surface) {
  surfaces.push_back({object.instance, object.label, surface.material});
}

void SceneTriangles::AddPart(const Mesh& part, const Rigid3d& T_world_part, int part_id, int grid) {
  const int first = static_cast<int>(corners.size());
  const Eigen::Matrix3f R = T_world_part.linear().cast<float>();
  for (std::size_t i = 0; i < part.positions_m.size(); ++i) {
    const Eigen::Vector3d position_m = T_world_part * part.positions_m[i].cast<double>();
    corners.push_back({position_m.cast<float>(), R * part.normals[i], part.texture_m[i]});
  }
  corner_light.resize(corners.size(), LightSample(0, 0, 0, 1));
  for (const Eigen::Vector3i& t : part.triangles) {
    const Eigen::Vector3d a = part.positions_m[t[0]].cast<double>();
    const Eigen::Vector3d b = part.positions_m[t[1]].cast<double>();
    const Eigen::Vector3d c = part.positions_m[t[2]].cast<double>();
    SceneTriangle triangle;
    triangle.normal = T_world_part.linear() * (b - a).cross(c - a).normalized();
    triangle.offset_m = triangle.normal.dot(T_world_part * a);
    triangle.corners = t.array() + first;
    triangle.surface = static_cast<int>(surfaces.size()) - 1;
    triangle.part = part_id;
    triangle.grid = grid;
    triangles.push_back(triangle);
  }
}

std::vector<Eigen::Vector3f> SceneTriangles::Positions() const {
  std::vector<Eigen::Vector3f> positions_m;
  positions_m.reserve(corners.size());
  for (const SceneCorner& corner : corners) positions_m.push_back(corner.position_m);
  return positions_m;
}

std::vector<Eigen::Vector3i> SceneTriangles::Corners() const {
  std::vector<Eigen::Vector3i> indices;
  indices.reserve(triangles.size());
  for (const SceneTriangle& triangle : triangles) indices.push_back(triangle.corners);
  return indices;
}

SurfacePoint PointOn(const SceneTriangles& scene, const std::vector<LightGrid>& grids,
                     unsigned triangle, const Eigen::Vector2f& barycentric,
                     const Eigen::Vector3f& position_m, const Eigen::Vector3f& direction) {
  SurfacePoint point;
  point.triangle = &scene.triangles[triangle];
  point.surface = &scene.surfaces[point.triangle->surface];
  point.position_m = position_m;
  const Eigen::Vector3f weights(1.0f - barycentric.sum(), barycentric.x(), barycentric.y());
  const SceneCorner& a = scene.corners[point.triangle->corners[0]];
  const SceneCorner& b = scene.corners[point.triangle->corners[1]];
  const SceneCorner& c = scene.corners[point.triangle->corners[2]];
  point.texture_m = weights[0] * a.texture_m + weights[1] * b.texture_m + weights[2] * c.texture_m;
  if (point.triangle->grid != kNoGrid) {
    point.normal = point.triangle->normal.cast<float>();
    point.irradiance = grids[point.triangle->grid].At(position_m);
  } else {
    point.normal =
        (weights[0] * a.normal + weights[1] * b.normal + weights[2] * c.normal).normalized();
    point.irradiance = LightOfCorners(scene, *point.triangle, weights);
  }
  if (point.normal.dot(direction) > 0.0f) point.normal = -point.normal;
  return point;
}

}  // namespace semantic_slam
