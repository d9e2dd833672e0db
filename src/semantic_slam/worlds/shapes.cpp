#include "semantic_slam/worlds/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

// A flat face with its corners counter-clockwise from the lower left one, as seen from outside.
void AddFace(Mesh& mesh, const std::array<Eigen::Vector3f, 4>& corners_m) {
  const Eigen::Vector3f normal =
      (corners_m[1] - corners_m[0]).cross(corners_m[3] - corners_m[0]).normalized();
  const Eigen::Vector3f right = (corners_m[1] - corners_m[0]).normalized();
  const Eigen::Vector3f down = right.cross(normal);
  const int first = static_cast<int>(mesh.positions_m.size());
  for (const Eigen::Vector3f& corner_m : corners_m) {
    mesh.positions_m.push_back(corner_m);
    mesh.normals.push_back(normal);
    mesh.texture_m.emplace_back((corner_m - corners_m[3]).dot(right),
                                (corner_m - corners_m[3]).dot(down));
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
  mesh.triangles.emplace_back(first, first + 2, first + 3);
}

// Joins corners that lie row by row, u to the right and v down, to triangles that face the front.
void AddGridTriangles(Mesh& mesh, int first, int columns, int rows, bool faces_front) {
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int a = first + row * (columns + 1) + column;
      const int below = a + columns + 1;
      if (faces_front) {
        mesh.triangles.emplace_back(a, below, below + 1);
        mesh.triangles.emplace_back(a, below + 1, a + 1);
      } else {
        mesh.triangles.emplace_back(a, below + 1, below);
        mesh.triangles.emplace_back(a, a + 1, below + 1);
      }
    }
  }
}

// Normals of corners from `first` on: those of the triangles around, weighted by area.
void SmoothNormals(Mesh& mesh, int first) {
  mesh.normals.resize(first);
  mesh.normals.resize(mesh.positions_m.size(), Eigen::Vector3f::Zero());
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t[0] < first) continue;
    const Eigen::Vector3f& a = mesh.positions_m[t[0]];
    const Eigen::Vector3f face = (mesh.positions_m[t[1]] - a).cross(mesh.positions_m[t[2]] - a);
    for (int i = 0; i < 3; ++i) mesh.normals[t[i]] += face;
  }
  for (std::size_t i = first; i < mesh.normals.size(); ++i) mesh.normals[i].normalize();
}

// Where to cut the side of a rounded box of half width `half_m`: finely in the round edges.
std::vector<float> RoundedCuts(float half_m, float radius_m) {
  constexpr int kSteps = 3;
  std::vector<float> cuts;
  for (int i = kSteps; i >= 0; --i) {
    cuts.push_back(half_m - radius_m + radius_m * std::tan(kPi / 4 * i / kSteps));
  }
  const std::size_t count = cuts.size();
  std::vector<float> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(-cuts[i]);
  if (half_m - radius_m < 1e-6f) all.pop_back();
  for (std::size_t i = count; i > 0; --i) all.push_back(cuts[i - 1]);
  return all;
}

}  // namespace

Mesh BeamMesh(const Eigen::Vector3f& foot_m, const Eigen::Vector3f& head_m,
              const Eigen::Vector2f& foot_size_m, const Eigen::Vector2f& head_size_m) {
  const auto corner = [](const Eigen::Vector3f& centre_m, const Eigen::Vector2f& size_m, int i) {
    const float x = (i == 0 || i == 3) ? 0.5f : -0.5f;  // counter-clockwise as seen from above
    const float y = (i == 0 || i == 1) ? 0.5f : -0.5f;
    return Eigen::Vector3f(centre_m + Eigen::Vector3f(x * size_m.x(), y * size_m.y(), 0));
  };
  std::array<Eigen::Vector3f, 4> foot;
  std::array<Eigen::Vector3f, 4> head;
  for (int i = 0; i < 4; ++i) {
    foot[i] = corner(foot_m, foot_size_m, i);
    head[i] = corner(head_m, head_size_m, i);
  }
  Mesh mesh;
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    AddFace(mesh, {foot[i], foot[next], head[next], head[i]});
  }
  AddFace(mesh, head);
  AddFace(mesh, {foot[3], foot[2], foot[1], foot[0]});
  return mesh;
}

Mesh LimbMesh(const Eigen::Vector3f& from_m, const Eigen::Vector3f& to_m, float from_radius_m,
              float to_radius_m, int sides) {
  constexpr int kSteps = 4;  // per round end
  const float length_m = (to_m - from_m).norm();
  std::vector<Eigen::Vector2f> profile_m;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle = kPi / 2 * i / kSteps;
    profile_m.emplace_back(i == 0 ? 0.0f : from_radius_m * std::sin(angle),
                           -from_radius_m * std::cos(angle));
  }
  for (int i = kSteps; i >= 0; --i) {
    const float angle = kPi / 2 * i / kSteps;
    profile_m.emplace_back(i == 0 ? 0.0f : to_radius_m * std::sin(angle),
                           length_m + to_radius_m * std::cos(angle));
  }
  Rigid3d T = Rigid3d::Identity();
  T.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), (to_m - from_m).cast<double>())
          .toRotationMatrix();
  T.translation() = from_m.cast<double>();
  Mesh mesh;
  Append(mesh, LatheMesh(Eigen::Vector3f::Zero(), profile_m, sides), T);
  return mesh;
}

Mesh RoundedBoxMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& size_m,
                    float radius_m) {
  const Eigen::Vector3f half_m = 0.5f * size_m;
  const Eigen::Vector3f core_m = half_m.array() - radius_m;
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0f, -1.0f}) {
      const Eigen::Vector3f normal = sign * Eigen::Vector3f::Unit(axis);
      const Eigen::Vector3f up = axis == 2 ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitZ();
      const Eigen::Vector3f right = up.cross(normal);
      const float half_width_m = std::abs(right.dot(half_m));
      const float half_height_m = std::abs(up.dot(half_m));
      const std::vector<float> across_m = RoundedCuts(half_width_m, radius_m);
      const std::vector<float> down_m = RoundedCuts(half_height_m, radius_m);
      const int first = static_cast<int>(mesh.positions_m.size());
      for (const float down : down_m) {
        for (const float across : across_m) {
          // The sharp box's surface, drawn in to the round one.
          const Eigen::Vector3f sharp_m = normal.cwiseProduct(half_m) + across * right - down * up;
          const Eigen::Vector3f inner_m = sharp_m.cwiseMax(-core_m).cwiseMin(core_m);
          const Eigen::Vector3f out = (sharp_m - inner_m).normalized();
          mesh.positions_m.push_back(centre_m + inner_m + radius_m * out);
          mesh.normals.push_back(out);
          mesh.texture_m.emplace_back(across + half_width_m, down + half_height_m);
        }
      }
      AddGridTriangles(mesh, first, static_cast<int>(across_m.size()) - 1,
                       static_cast<int>(down_m.size()) - 1, true);
    }
  }
  return mesh;
}

Mesh SlabMesh(const std::vector<Eigen::Vector2f>& outline_m, float bottom_m, float top_m) {
  const int corners = static_cast<int>(outline_m.size());
  Mesh mesh;
  for (int i = 0; i < corners; ++i) {
    const Eigen::Vector2f& a = outline_m[i];
    const Eigen::Vector2f& b = outline_m[(i + 1) % corners];
    AddFace(mesh, {Eigen::Vector3f(a.x(), a.y(), bottom_m), Eigen::Vector3f(b.x(), b.y(), bottom_m),
                   Eigen::Vector3f(b.x(), b.y(), top_m), Eigen::Vector3f(a.x(), a.y(), top_m)});
  }
  for (const bool upper : {true, false}) {
    const int first = static_cast<int>(mesh.positions_m.size());
    for (const Eigen::Vector2f& p : outline_m) {
      mesh.positions_m.emplace_back(p.x(), p.y(), upper ? top_m : bottom_m);
      mesh.normals.emplace_back(0, 0, upper ? 1.0f : -1.0f);
      mesh.texture_m.emplace_back(p.y(), -p.x());  // as on a box
    }
    for (int i = 1; i + 1 < corners; ++i) {
      mesh.triangles.emplace_back(first, first + (upper ? i : i + 1), first + (upper ? i + 1 : i));
    }
  }
  return mesh;
}

std::vector<Eigen::Vector2f> RoundedRectangle(const Eigen::Vector2f& size_m, float radius_m) {
  constexpr int kSteps = 5;  // per corner
  const Eigen::Vector2f core_m = 0.5f * size_m.array() - radius_m;
  std::vector<Eigen::Vector2f> outline_m;
  for (int corner = 0; corner < 4; ++corner) {
    const Eigen::Vector2f sign(corner == 0 || corner == 3 ? 1 : -1, corner < 2 ? 1 : -1);
    for (int i = 0; i <= kSteps; ++i) {
      const float angle = kPi / 2 * (corner + static_cast<float>(i) / kSteps);
      const Eigen::Vector2f corner_m =
          core_m.cwiseProduct(sign) + radius_m * Eigen::Vector2f(std::cos(angle), std::sin(angle));
      const bool new_place = outline_m.empty() || ((outline_m.back() - corner_m).norm() > 1e-4f &&
                                                   (outline_m.front() - corner_m).norm() > 1e-4f);
      if (new_place) outline_m.push_back(corner_m);
    }
  }
  return outline_m;
}

std::vector<Eigen::Vector2f> EllipseOutline(const Eigen::Vector2f& size_m) {
  constexpr int kCorners = 40;
  std::vector<Eigen::Vector2f> outline_m;
  for (int i = 0; i < kCorners; ++i) {
    const float angle = 2 * kPi * i / kCorners;
    outline_m.emplace_back(0.5f * size_m.x() * std::cos(angle),
                           0.5f * size_m.y() * std::sin(angle));
  }
  return outline_m;
}

Mesh SheetMesh(const std::function<Eigen::Vector3f(float u, float v)>& middle_m,
               const std::function<float(float u, float v)>& half_m, const Eigen::Vector3f& forward,
               int columns, int rows) {
  Mesh mesh;
  for (const float side : {1.0f, -1.0f}) {
    const int first = static_cast<int>(mesh.positions_m.size());
    Eigen::Vector2f texture_m = Eigen::Vector2f::Zero();
    for (int row = 0; row <= rows; ++row) {
      const float v = static_cast<float>(row) / rows;
      if (row > 0) texture_m.y() += (middle_m(0.5f, v) - middle_m(0.5f, v - 1.0f / rows)).norm();
      texture_m.x() = 0.0f;
      for (int column = 0; column <= columns; ++column) {
        const float u = static_cast<float>(column) / columns;
        if (column > 0) texture_m.x() += (middle_m(u, v) - middle_m(u - 1.0f / columns, v)).norm();
        const bool edge = row == 0 || row == rows || column == 0 || column == columns;
        mesh.positions_m.push_back(middle_m(u, v) + (edge ? 0.0f : side * half_m(u, v)) * forward);
        mesh.texture_m.push_back(texture_m);
      }
    }
    AddGridTriangles(mesh, first, columns, rows, side > 0.0f);
    SmoothNormals(mesh, first);
  }
  return mesh;
}

Mesh PillowMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& size_m) {
  const auto middle_m = [&](float u, float v) -> Eigen::Vector3f {
    const float x = std::cos(kPi * v);  // dense near the seams, where it curves
    const float y = std::cos(kPi * u);
    // The seams are drawn in between the corners.
    const float drawn_x = 1.0f - 0.08f * (1.0f - y * y) * x * x;
    const float drawn_y = 1.0f - 0.08f * (1.0f - x * x) * y * y;
    return centre_m + 0.5f * Eigen::Vector3f(x * drawn_x * size_m.x(), y * drawn_y * size_m.y(), 0);
  };
  const auto half_m = [&](float u, float v) {
    const float y = std::cos(kPi * u);
    const float x = std::cos(kPi * v);
    return 0.5f * size_m.z() * std::sqrt((1 - x * x * x * x) * (1 - y * y * y * y));
  };
  return SheetMesh(middle_m, half_m, Eigen::Vector3f::UnitZ(), 12, 12);
}

Mesh LeafMesh(float length_m, float width_m, float droop_m) {
  constexpr float kHalfM = 0.001f;    // of its thickness where it is widest
  const auto outline = [](float v) {  // widest at a quarter of its length
    return std::max(std::sin(kPi * std::sqrt(std::max(1.0f - v, 0.0f))), 0.06f);
  };
  const auto middle_m = [=](float u, float v) -> Eigen::Vector3f {
    const float along = 1.0f - v;
    const float half_m = 0.5f * width_m * outline(v);
    const float across = 1.0f - 2.0f * u;
    const float valley_m = 0.3f * half_m * (1.0f - std::abs(across));
    return {along * length_m, half_m * across, -droop_m * along * along - valley_m};
  };
  return SheetMesh(
      middle_m, [=](float, float v) { return kHalfM * outline(v); }, Eigen::Vector3f::UnitZ(), 4,
      6);
}

}  // namespace semantic_slam
