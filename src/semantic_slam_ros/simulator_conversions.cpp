#include "semantic_slam_ros/simulator_conversions.h"

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/waypoint_conversions.h"

namespace semantic_slam_ros {

using semantic_slam::ImuOptions;
using semantic_slam::ImuReading;
using semantic_slam::InputError;
using semantic_slam::QuadrotorState;
using semantic_slam::RelativeAttitudeCommand;

namespace {

geometry_msgs::Vector3 ToVector(const Eigen::Vector3d& v) {
  geometry_msgs::Vector3 msg;
  msg.x = v.x(), msg.y = v.y(), msg.z = v.z();
  return msg;
}

void SetDiagonal(boost::array<double, 9>& covariance, double variance) {
  covariance[0] = covariance[4] = covariance[8] = variance;
}

}  // namespace

RelativeAttitudeCommand ToRelativeAttitudeCommand(const semantic_slam::AttitudeThrust& msg) try {
  if (msg.header.stamp.isZero()) throw InputError("has no stamp");
  const auto command = ToAttitudeCommand(msg, Eigen::Matrix3d::Identity());
  return {ToStamp(msg.header.stamp), msg.level != 0, command.R_world_desired,
          command.angular_velocity_radps, command.thrust_n};
} catch (const InputError& e) {
  throw InputError(std::string("attitude_thrust: ") + e.what());
}

sensor_msgs::Imu ToImu(const ImuReading& reading, const ImuOptions& options, double rate_hz,
                       const std::string& frame_id) {
  sensor_msgs::Imu msg;
  msg.header = MakeHeader(reading.stamp, frame_id);
  msg.orientation_covariance[0] = -1.0;  // there is none
  msg.angular_velocity = ToVector(reading.angular_velocity_radps);
  msg.linear_acceleration = ToVector(reading.specific_force_mps2);
  if (!options.noise) return msg;
  const auto variance = [rate_hz](double density) { return density * density * rate_hz; };
  SetDiagonal(msg.angular_velocity_covariance, variance(options.gyroscope_noise_radps_per_sqrt_hz));
  SetDiagonal(msg.linear_acceleration_covariance,
              variance(options.accelerometer_noise_mps2_per_sqrt_hz));
  return msg;
}

nav_msgs::Odometry ToOdometry(const QuadrotorState& state, semantic_slam::Stamp stamp,
                              const std::string& world_frame, const std::string& base_frame) {
  nav_msgs::Odometry msg;
  msg.header = MakeHeader(stamp, world_frame);
  msg.child_frame_id = base_frame;
  msg.pose.pose = ToPose(state.T_world_base);
  msg.twist.twist.linear =
      ToVector(state.T_world_base.linear().transpose() * state.velocity_world_mps);
  msg.twist.twist.angular = ToVector(state.angular_velocity_base_radps);
  return msg;
}

}  // namespace semantic_slam_ros
