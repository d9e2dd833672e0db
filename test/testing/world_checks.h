#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/triangle_distance.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// An object of a world at time 0 as bare triangles in the world frame.
class Solid {
 public:
  explicit Solid(const WorldObject& object) : object_(&object) {
    for (const Surface& surface : object.surfaces) {
      for (const Eigen::Vector3i& t : surface.mesh.triangles) {
        std::array<Eigen::Vector3d, 3> triangle;
        for (int i = 0; i < 3; ++i) {
          triangle[i] = object.Pose(0) * surface.mesh.positions_m[t[i]].cast<double>();
          bounds_.extend(triangle[i]);
        }
        triangles_.push_back(triangle);
        AddPoints(triangle);
      }
    }
  }

  const WorldObject& object() const { return *object_; }
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  // At most `limit`.
  double Distance(const Eigen::Vector3d& p, double limit) const {
    if (bounds_.exteriorDistance(p) >= limit) return limit;
    for (const auto& triangle : triangles_) {
      limit = std::min(limit, DistanceToTriangle(p, triangle[0], triangle[1], triangle[2]));
    }
    return limit;
  }

  // By what an upright ray crosses above the point: solids that overlap count together.
  bool Contains(const Eigen::Vector3d& p) const {
    if (!bounds_.contains(p)) return false;
    int crossings = 0;
    for (const auto& triangle : triangles_) {
      const auto [height, faces_up] = HeightOf(triangle, p.head<2>());
      if (height > p.z()) crossings += faces_up ? 1 : -1;
    }
    return crossings > 0;
  }

  // The highest surface that faces up at or below the point; far below if there is none.
  double TopBelow(const Eigen::Vector3d& p) const {
    double top = -1e9;
    if ((p.head<2>().array() < bounds_.min().head<2>().array()).any() ||
        (p.head<2>().array() > bounds_.max().head<2>().array()).any()) {
      return top;
    }
    for (const auto& triangle : triangles_) {
      const auto [height, faces_up] = HeightOf(triangle, p.head<2>());
      if (faces_up && height <= p.z()) top = std::max(top, height);
    }
    return top;
  }

  // Points on all of its surface, at most 8 cm apart.
  const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  void AddPoints(const std::array<Eigen::Vector3d, 3>& t) {
    constexpr double kSpacingM = 0.08;
    const double edge_m =
        std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
    const int steps = std::max(1, static_cast<int>(std::ceil(edge_m / kSpacingM)));
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        points_.push_back(t[0] + (t[1] - t[0]) * i / steps + (t[2] - t[0]) * j / steps);
      }
    }
  }

  // Height of a triangle at a place of the plan, -1e9 beside it, and whether it faces up.
  static std::pair<double, bool> HeightOf(const std::array<Eigen::Vector3d, 3>& t,
                                          const Eigen::Vector2d& at) {
    const double highest_x = std::max({t[0].x(), t[1].x(), t[2].x()});
    const double lowest_x = std::min({t[0].x(), t[1].x(), t[2].x()});
    if (at.x() < lowest_x || at.x() > highest_x) return {-1e9, false};  // most of them
    const Eigen::Vector2d ab = (t[1] - t[0]).head<2>();
    const Eigen::Vector2d ac = (t[2] - t[0]).head<2>();
    const Eigen::Vector2d ap = at - t[0].head<2>();
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (std::abs(area) < 1e-12) return {-1e9, false};
    const double b = (ap.x() * ac.y() - ap.y() * ac.x()) / area;
    const double c = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
    if (b < 0 || c < 0 || b + c > 1) return {-1e9, false};
    return {t[0].z() + b * (t[1] - t[0]).z() + c * (t[2] - t[0]).z(), area > 0};
  }

  const WorldObject* object_;
  std::vector<std::array<Eigen::Vector3d, 3>> triangles_;
  std::vector<Eigen::Vector3d> points_;
  Eigen::AlignedBox3d bounds_;
};

// All that stands still.
inline std::vector<Solid> StillSolids(const World& world) {
  std::vector<Solid> solids;
  for (const WorldObject& object : world.objects) {
    if (!object.IsMoving()) solids.emplace_back(object);
  }
  return solids;
}

constexpr double kTouchingM = 0.015;

inline bool LiesOn(const Solid& solid, const Solid& other) {
  return std::any_of(solid.points().begin(), solid.points().end(), [&](const Eigen::Vector3d& p) {
    if (other.bounds().exteriorDistance(p) > kTouchingM) return false;
    const Eigen::Vector3d above = p + Eigen::Vector3d(0, 0, kTouchingM);
    return std::abs(other.TopBelow(above) - p.z()) < kTouchingM;
  });
}

inline bool Touches(const Solid& solid, const Solid& other) {
  return std::any_of(solid.points().begin(), solid.points().end(), [&](const Eigen::Vector3d& p) {
    return other.Distance(p, 2 * kTouchingM) < kTouchingM;
  });
}

// True if the object lies on another, or touches a wall or a ceiling.
inline bool IsHeld(const Solid& solid, const std::vector<Solid>& all) {
  std::vector<const Solid*> near;
  for (const Solid& other : all) {
    const double gap_m = other.bounds().exteriorDistance(solid.bounds());
    if (&other != &solid && gap_m < kTouchingM) near.push_back(&other);
  }
  return std::any_of(near.begin(), near.end(),
                     [&](const Solid* other) { return LiesOn(solid, *other); }) ||
         std::any_of(near.begin(), near.end(), [&](const Solid* other) {
           return other->object().is_structure && Touches(solid, *other);
         });
}

// Where a surface of `a` lies deeper in `b` than `depth_m`; nullopt if nowhere.
inline std::optional<Eigen::Vector3d> DeepInside(const Solid& a, const Solid& b, double depth_m) {
  if (!a.bounds().intersects(b.bounds())) return std::nullopt;
  for (Eigen::Vector3d p : a.points()) {
    p += Eigen::Vector3d(1.1e-5, 0.7e-5, 0);  // off the edges between triangles
    if (b.Contains(p) && b.Distance(p, 2 * depth_m) > depth_m) return p;
  }
  return std::nullopt;
}

}  // namespace semantic_slam
