#include "semantic_slam/worlds/mesh.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

void AddTriangle(Mesh& mesh, int a, int b, int c) {
  mesh.triangles.emplace_back(a, b, c);
}

int AddCorner(Mesh& mesh, const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal,
              const Eigen::Vector2f& texture_m) {
  mesh.positions_m.push_back(position_m);
  mesh.normals.push_back(normal);
  mesh.texture_m.push_back(texture_m);
  return static_cast<int>(mesh.positions_m.size()) - 1;
}

// A flat fan about an upright axis, facing up or down.
void AddLid(Mesh& mesh, const Eigen::Vector3f& centre_m, float radius_m, bool faces_up, int sides) {
  const Eigen::Vector3f normal(0, 0, faces_up ? 1.0f : -1.0f);
  const int centre = AddCorner(mesh, centre_m, normal, Eigen::Vector2f::Zero());
  for (int i = 0; i <= sides; ++i) {
    const float angle = 2 * kPi * i / sides;
    const Eigen::Vector2f rim = radius_m * Eigen::Vector2f(std::cos(angle), std::sin(angle));
    const int corner =
        AddCorner(mesh, centre_m + Eigen::Vector3f(rim.x(), rim.y(), 0), normal, rim);
    if (i > 0 && faces_up) AddTriangle(mesh, centre, corner - 1, corner);
    if (i > 0 && !faces_up) AddTriangle(mesh, centre, corner, corner - 1);
  }
}

}  // namespace

void Append(Mesh& mesh, const Mesh& part, const Rigid3d& T_mesh_part) {
  const Eigen::Isometry3f T = T_mesh_part.cast<float>();
  const int first = static_cast<int>(mesh.positions_m.size());
  for (const Eigen::Vector3f& p : part.positions_m) mesh.positions_m.push_back(T * p);
  for (const Eigen::Vector3f& n : part.normals) mesh.normals.push_back(T.linear() * n);
  mesh.texture_m.insert(mesh.texture_m.end(), part.texture_m.begin(), part.texture_m.end());
  for (const Eigen::Vector3i& t : part.triangles) mesh.triangles.push_back(t.array() + first);
}

Mesh QuadMesh(const Eigen::Vector3f& corner_m, const Eigen::Vector3f& right_m,
              const Eigen::Vector3f& down_m) {
  const Eigen::Vector3f normal = down_m.cross(right_m).normalized();
  const float width_m = right_m.norm();
  const float height_m = down_m.norm();
  Mesh mesh;
  AddCorner(mesh, corner_m, normal, {0, 0});
  AddCorner(mesh, corner_m + right_m, normal, {width_m, 0});
  AddCorner(mesh, corner_m + right_m + down_m, normal, {width_m, height_m});
  AddCorner(mesh, corner_m + down_m, normal, {0, height_m});
  AddTriangle(mesh, 0, 3, 2);
  AddTriangle(mesh, 0, 2, 1);
  return mesh;
}

Mesh BoxMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& size_m) {
  const Eigen::Vector3f half_m = 0.5f * size_m;
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0f, -1.0f}) {
      const Eigen::Vector3f normal = sign * Eigen::Vector3f::Unit(axis);
      const Eigen::Vector3f up = axis == 2 ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitZ();
      const Eigen::Vector3f right = up.cross(normal);
      const Eigen::Vector3f corner_m = centre_m + (normal + up - right).cwiseProduct(half_m);
      Append(mesh, QuadMesh(corner_m, right.cwiseProduct(size_m), -up.cwiseProduct(size_m)));
    }
  }
  return mesh;
}

Mesh CylinderMesh(const Eigen::Vector3f& foot_m, float bottom_radius_m, float top_radius_m,
                  float height_m, int sides) {
  const float slant_m = std::hypot(height_m, bottom_radius_m - top_radius_m);
  const float texture_radius_m = std::max(bottom_radius_m, top_radius_m);
  Mesh mesh;
  for (int i = 0; i <= sides; ++i) {
    const float angle = 2 * kPi * i / sides;
    const Eigen::Vector3f out(std::cos(angle), std::sin(angle), 0);
    const Eigen::Vector3f normal =
        (height_m * out + (bottom_radius_m - top_radius_m) * Eigen::Vector3f::UnitZ()).normalized();
    const float along_m = angle * texture_radius_m;
    AddCorner(mesh, foot_m + bottom_radius_m * out, normal, {along_m, slant_m});
    const Eigen::Vector3f head_m = foot_m + height_m * Eigen::Vector3f::UnitZ();
    const int top = AddCorner(mesh, head_m + top_radius_m * out, normal, {along_m, 0});
    if (i == 0) continue;
    if (bottom_radius_m > 0) AddTriangle(mesh, top - 3, top - 1, top);
    if (top_radius_m > 0) AddTriangle(mesh, top - 3, top, top - 2);
  }
  if (bottom_radius_m > 0) AddLid(mesh, foot_m, bottom_radius_m, false, sides);
  if (top_radius_m > 0) {
    AddLid(mesh, foot_m + height_m * Eigen::Vector3f::UnitZ(), top_radius_m, true, sides);
  }
  return mesh;
}

Mesh EllipsoidMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& radii_m, int sides) {
  const int rings = std::max(sides / 2, 2);
  const float equator_m = std::max(radii_m.x(), radii_m.y());
  Mesh mesh;
  for (int ring = 0; ring <= rings; ++ring) {
    const float polar = kPi * ring / rings;  // 0 at the top
    for (int side = 0; side <= sides; ++side) {
      const float angle = 2 * kPi * side / sides;
      const Eigen::Vector3f unit(std::sin(polar) * std::cos(angle),
                                 std::sin(polar) * std::sin(angle), std::cos(polar));
      const int corner = AddCorner(mesh, centre_m + unit.cwiseProduct(radii_m),
                                   unit.cwiseQuotient(radii_m).normalized(),
                                   {angle * equator_m, polar * radii_m.z()});
      if (ring == 0 || side == 0) continue;
      const int above = corner - (sides + 1);
      if (ring > 1) AddTriangle(mesh, above - 1, corner, above);
      if (ring < rings) AddTriangle(mesh, above - 1, corner - 1, corner);
    }
  }
  return mesh;
}

}  // namespace semantic_slam
