#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace semantic_slam {

// An upright box: a rectangle on the plan, turned by its yaw, between two heights.
struct UprightBox {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d half_m = Eigen::Vector2d::Zero();  // along its own x and y
  double yaw_rad = 0.0;
  double low_m = 0.0;
  double high_m = 0.0;

  Eigen::Vector2d Axis(int axis) const;
  std::vector<Eigen::Vector2d> Corners() const;
};

bool Overlap(const UprightBox& a, const UprightBox& b);

// What of a room is taken. Not thread-safe.
class FreeSpace {
 public:
  explicit FreeSpace(const Eigen::AlignedBox2d& inside_m, double height_m)
      : inside_m_(inside_m), height_m_(height_m) {}

  // In the room, and off all that is taken or kept free.
  bool Fits(const UprightBox& box) const;

  // In the room, and off all that is taken.
  bool IsPassable(const UprightBox& box) const;

  void Take(const UprightBox& box) { taken_.push_back(box); }
  void KeepFree(const UprightBox& box) { kept_.push_back(box); }

  // Share of the floor that is taken by what reaches down to 0.5 m.
  double FilledShare() const;

 private:
  bool IsInside(const UprightBox& box) const;

  Eigen::AlignedBox2d inside_m_;
  double height_m_;
  std::vector<UprightBox> taken_;
  std::vector<UprightBox> kept_;
};

}  // namespace semantic_slam
