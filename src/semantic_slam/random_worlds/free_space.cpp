#include "semantic_slam/random_worlds/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace semantic_slam {
namespace {

constexpr double kTouchM = 1e-3;  // boxes that share less than that only touch
constexpr double kFloorThingM = 0.5;

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Interval Along(const Eigen::Vector2d& axis, const std::vector<Eigen::Vector2d>& corners) {
  Interval interval;
  for (const Eigen::Vector2d& corner : corners) {
    interval.low = std::min(interval.low, axis.dot(corner));
    interval.high = std::max(interval.high, axis.dot(corner));
  }
  return interval;
}

bool AnyOverlaps(const UprightBox& box, const std::vector<UprightBox>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const UprightBox& other) { return Overlap(box, other); });
}

}  // namespace

Eigen::Vector2d UprightBox::Axis(int axis) const {
  const double angle = yaw_rad + axis * M_PI / 2;
  return {std::cos(angle), std::sin(angle)};
}

std::vector<Eigen::Vector2d> UprightBox::Corners() const {
  std::vector<Eigen::Vector2d> corners;
  for (const double x : {-half_m.x(), half_m.x()}) {
    for (const double y : {-half_m.y(), half_m.y()}) {
      corners.push_back(centre_m + x * Axis(0) + y * Axis(1));
    }
  }
  return corners;
}

// Separating axes: convex shapes are apart if they are along a side of one of them.
bool Overlap(const UprightBox& a, const UprightBox& b) {
  if (std::min(a.high_m, b.high_m) - std::max(a.low_m, b.low_m) < kTouchM) return false;
  const std::vector<Eigen::Vector2d> corners_a = a.Corners(), corners_b = b.Corners();
  for (const Eigen::Vector2d& axis : {a.Axis(0), a.Axis(1), b.Axis(0), b.Axis(1)}) {
    const Interval along_a = Along(axis, corners_a), along_b = Along(axis, corners_b);
    const double shared = std::min(along_a.high, along_b.high) - std::max(along_a.low, along_b.low);
    if (shared < kTouchM) return false;
  }
  return true;
}

bool FreeSpace::IsInside(const UprightBox& box) const {
  if (box.low_m < -kTouchM || box.high_m > height_m_ + kTouchM) return false;
  for (const Eigen::Vector2d& corner : box.Corners()) {
    if (inside_m_.exteriorDistance(corner) > kTouchM) return false;
  }
  return true;
}

bool FreeSpace::IsPassable(const UprightBox& box) const {
  return IsInside(box) && !AnyOverlaps(box, taken_);
}

bool FreeSpace::Fits(const UprightBox& box) const {
  return IsPassable(box) && !AnyOverlaps(box, kept_);
}

double FreeSpace::FilledShare() const {
  double area_m2 = 0.0;
  for (const UprightBox& box : taken_) {
    if (box.low_m < kFloorThingM) area_m2 += 4.0 * box.half_m.prod();
  }
  return area_m2 / inside_m_.volume();
}

}  // namespace semantic_slam
