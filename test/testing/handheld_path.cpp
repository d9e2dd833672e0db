#include "testing/handheld_path.h"

#include <cmath>

namespace semantic_slam {
namespace {

constexpr double kPeriodS = 16.0;
constexpr double kStartS = 1.0;  // the time it takes to come up to speed

// Time as the sweep sees it: slow at first, and a constant behind the clock in the end.
double SweepTime(double t_s) {
  return t_s - kStartS * (1.0 - std::exp(-t_s / kStartS));
}

Eigen::Vector3d Position(double t_s) {
  const double a = 2.0 * M_PI * SweepTime(t_s) / kPeriodS;
  const Eigen::Vector3d sweep(-0.15 + 0.30 * std::sin(2.0 * a), 0.75 * std::sin(a),
                              1.30 + 0.12 * std::sin(3.0 * a));
  const Eigen::Vector3d tremor(std::sin(7.1 * t_s), std::sin(8.3 * t_s + 1.0),
                               std::sin(9.7 * t_s + 2.0));
  return sweep + 0.004 * tremor;
}

// The point in the middle of the picture.
Eigen::Vector3d Target(double t_s) {
  const double a = 2.0 * M_PI * SweepTime(t_s) / kPeriodS;
  return {1.9, -0.5 * std::sin(2.0 * a) + 0.01 * std::sin(6.3 * t_s),
          0.85 + 0.15 * std::sin(a) + 0.01 * std::sin(5.1 * t_s)};
}

}  // namespace

Rigid3d HandheldPath::T_world_camera(double t_s) {
  const Eigen::Vector3d position = Position(t_s);
  const Eigen::Vector3d z = (Target(t_s) - position).normalized();           // forward
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();  // right
  Eigen::Matrix3d level;
  level << x, z.cross(x), z;
  const double roll_rad = 0.06 * std::sin(2.0 * M_PI * SweepTime(t_s) / 5.0);
  return Eigen::Translation3d(position) * Eigen::Quaterniond(level) *
         Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ());
}

Eigen::Vector3d HandheldPath::SpecificForce(double t_s) {
  const double h_s = 1e-3;  // second differences: error 1e-6 by truncation, 1e-9 by rounding
  const Eigen::Vector3d acceleration =
      (Position(t_s + h_s) - 2.0 * Position(t_s) + Position(t_s - h_s)) / (h_s * h_s);
  const Eigen::Vector3d force_world = acceleration + 9.81 * Eigen::Vector3d::UnitZ();
  return T_world_camera(t_s).linear().transpose() * force_world;
}

}  // namespace semantic_slam
