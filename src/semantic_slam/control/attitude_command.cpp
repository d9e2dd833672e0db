#include "semantic_slam/control/attitude_command.h"

#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

AttitudeCommand After(const AttitudeCommand& command, double seconds) {
  AttitudeCommand later = command;
  later.R_world_desired *= ExpSo3(seconds * command.angular_velocity_radps);
  return later;
}

Eigen::Matrix3d LevelAttitude(const Eigen::Matrix3d& R_world_base) {
  return Eigen::AngleAxisd(Heading(R_world_base), Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

AttitudeCommand LevelCommand(const Eigen::Matrix3d& R_world_base, double thrust_n) {
  return {LevelAttitude(R_world_base), Eigen::Vector3d::Zero(), thrust_n};
}

double Heading(const Eigen::Matrix3d& R_world_base) {
  return std::atan2(R_world_base(1, 0), R_world_base(0, 0));
}

double WrappedAngle(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * M_PI);
}

}  // namespace semantic_slam
