#include "semantic_slam_ros/simulator_conversions.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/waypoint_conversions.h"
#include "testing/expect_error.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::InputError;
using semantic_slam::MessageOf;
using semantic_slam::QuadrotorState;

constexpr Stamp kStamp{101'000'000'000};

semantic_slam::AttitudeThrust Command() {
  const semantic_slam::AttitudeCommand command{
      semantic_slam::ExpSo3({0.1, 0.2, 0.3}), {0.4, 0.5, 0.6}, 8.0};
  return ToAttitudeThrust(command, Eigen::Matrix3d::Identity(), MakeHeader(kStamp, "base_link"));
}

TEST(SimulatorConversionsTest, ReadsACommandRelativeToTheBase) {
  const auto command = ToRelativeAttitudeCommand(Command());
  EXPECT_EQ(command.stamp, kStamp);
  EXPECT_FALSE(command.level);
  EXPECT_TRUE(command.R_base_desired.isApprox(semantic_slam::ExpSo3({0.1, 0.2, 0.3}), 1e-12));
  EXPECT_TRUE(command.angular_velocity_radps.isApprox(Eigen::Vector3d(0.4, 0.5, 0.6)));
  EXPECT_EQ(command.thrust_n, 8.0);
}

TEST(SimulatorConversionsTest, ReadsALevelCommand) {
  const semantic_slam::AttitudeCommand braking{semantic_slam::ExpSo3({0.0, -0.1, 0.0}),
                                               Eigen::Vector3d::Zero(), 8.0};
  const auto command =
      ToRelativeAttitudeCommand(ToLevelThrust(braking, MakeHeader(kStamp, "base_link")));
  EXPECT_TRUE(command.level);
  EXPECT_TRUE(command.R_base_desired.isApprox(braking.R_world_desired, 1e-12));
  EXPECT_EQ(command.thrust_n, 8.0);
}

TEST(SimulatorConversionsTest, RefusesCommandsThatAreNone) {
  semantic_slam::AttitudeThrust msg = Command();
  msg.header.stamp = ros::Time();
  EXPECT_NE(MessageOf<InputError>([&] { ToRelativeAttitudeCommand(msg); }).find("no stamp"),
            std::string::npos);
  msg = Command();
  msg.orientation.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(MessageOf<InputError>([&] { ToRelativeAttitudeCommand(msg); }), "");
  msg = Command();
  msg.orientation = {};
  EXPECT_NE(MessageOf<InputError>([&] { ToRelativeAttitudeCommand(msg); }), "");
}

TEST(SimulatorConversionsTest, AnImuMessageSaysHowNoisyItIs) {
  semantic_slam::ImuReading reading;
  reading.stamp = kStamp;
  reading.angular_velocity_radps = {0.1, 0.2, 0.3};
  reading.specific_force_mps2 = {1.0, 2.0, 9.0};
  semantic_slam::ImuOptions options;
  options.gyroscope_noise_radps_per_sqrt_hz = 1e-3;
  const sensor_msgs::Imu msg = ToImu(reading, options, 200.0, "imu");
  EXPECT_EQ(ToStamp(msg.header.stamp), kStamp);
  EXPECT_EQ(msg.header.frame_id, "imu");
  EXPECT_EQ(msg.orientation_covariance[0], -1.0) << "it knows no orientation";
  EXPECT_EQ(ToAccelerometerReading(msg).acceleration_imu, reading.specific_force_mps2);
  EXPECT_EQ(msg.angular_velocity.y, 0.2);
  EXPECT_NEAR(msg.angular_velocity_covariance[4], 2e-4, 1e-12);
}

TEST(SimulatorConversionsTest, OdometrysTwistIsInTheBasesAxes) {
  QuadrotorState state;
  state.T_world_base.translation() << 1.0, 2.0, 3.0;
  state.T_world_base.rotate(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  state.velocity_world_mps = {0.0, 0.7, 0.0};
  state.angular_velocity_base_radps = {0.0, 0.0, 0.5};
  const nav_msgs::Odometry msg = ToOdometry(state, kStamp, "world", "ground_truth/base_link");
  EXPECT_EQ(msg.header.frame_id, "world");
  EXPECT_EQ(msg.child_frame_id, "ground_truth/base_link");
  EXPECT_TRUE(ToRigid(msg.pose.pose).isApprox(state.T_world_base, 1e-12));
  EXPECT_NEAR(msg.twist.twist.linear.x, 0.7, 1e-12);
  EXPECT_NEAR(msg.twist.twist.linear.y, 0.0, 1e-12);
  EXPECT_EQ(msg.twist.twist.angular.z, 0.5);
}

}  // namespace
}  // namespace semantic_slam_ros
