#include "semantic_slam/worlds/mesh.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kSmoothCosine = 0.7071f;  // of 45 degrees

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

// Outward normals (radial, up) at the two ends of a segment of a lathe's profile.
struct SegmentNormals {
  Eigen::Vector2f begin;
  Eigen::Vector2f end;
};

std::vector<SegmentNormals> ProfileNormals(const std::vector<Eigen::Vector2f>& profile_m) {
  std::vector<Eigen::Vector2f> flat;
  for (std::size_t i = 0; i + 1 < profile_m.size(); ++i) {
    const Eigen::Vector2f along = (profile_m[i + 1] - profile_m[i]).normalized();
    flat.emplace_back(along.y(), -along.x());
  }
  std::vector<SegmentNormals> normals;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const auto smooth = [&](std::size_t neighbour) -> Eigen::Vector2f {
      if (neighbour >= flat.size() || flat[i].dot(flat[neighbour]) < kSmoothCosine) return flat[i];
      return (flat[i] + flat[neighbour]).normalized();
    };
    normals.push_back({smooth(i - 1), smooth(i + 1)});  // i - 1 of 0 is beyond the end, too
  }
  return normals;
}

// One ring of corners of a lathe's segment.
void AddRing(Mesh& mesh, const Eigen::Vector3f& foot_m, const Eigen::Vector2f& profile_m,
             const Eigen::Vector2f& normal, float texture_radius_m, float down_m, bool from_above,
             int sides) {
  for (int i = 0; i <= sides; ++i) {
    const float angle = 2 * kPi * i / sides;
    const Eigen::Vector3f out(std::cos(angle), std::sin(angle), 0);
    const Eigen::Vector3f spot = profile_m.x() * out + profile_m.y() * Eigen::Vector3f::UnitZ();
    const Eigen::Vector2f wrapped(angle * texture_radius_m, down_m);
    AddCorner(mesh, foot_m + spot, normal.x() * out + normal.y() * Eigen::Vector3f::UnitZ(),
              from_above ? Eigen::Vector2f(spot.head<2>()) : wrapped);
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

Mesh LatheMesh(const Eigen::Vector3f& foot_m, const std::vector<Eigen::Vector2f>& profile_m,
               int sides) {
  const std::vector<SegmentNormals> normals = ProfileNormals(profile_m);
  float texture_radius_m = 0.0f;
  for (const Eigen::Vector2f& p : profile_m) texture_radius_m = std::max(texture_radius_m, p.x());
  float along_m = 0.0f;
  Mesh mesh;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Eigen::Vector2f step_m = profile_m[i + 1] - profile_m[i];
    const bool from_above = std::abs(step_m.y()) < 0.2f * std::abs(step_m.x());
    const int begin = static_cast<int>(mesh.positions_m.size());
    AddRing(mesh, foot_m, profile_m[i], normals[i].begin, texture_radius_m, -along_m, from_above,
            sides);
    along_m += step_m.norm();
    AddRing(mesh, foot_m, profile_m[i + 1], normals[i].end, texture_radius_m, -along_m, from_above,
            sides);
    for (int side = begin; side < begin + sides; ++side) {
      const int above = side + sides + 1;
      if (profile_m[i].x() > 0) AddTriangle(mesh, side, side + 1, above + 1);
      if (profile_m[i + 1].x() > 0) AddTriangle(mesh, side, above + 1, above);
    }
  }
  return mesh;
}

Mesh CylinderMesh(const Eigen::Vector3f& foot_m, float bottom_radius_m, float top_radius_m,
                  float height_m, int sides) {
  std::vector<Eigen::Vector2f> profile_m;
  if (bottom_radius_m > 0) profile_m.emplace_back(0, 0);
  profile_m.emplace_back(bottom_radius_m, 0);
  profile_m.emplace_back(top_radius_m, height_m);
  if (top_radius_m > 0) profile_m.emplace_back(0, height_m);
  return LatheMesh(foot_m, profile_m, sides);
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
