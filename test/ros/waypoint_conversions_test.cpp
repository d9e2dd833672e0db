#include "semantic_slam_ros/waypoint_conversions.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::AttitudeCommand;
using semantic_slam::AttitudeThrust;
using semantic_slam::ExpSo3;
using semantic_slam::InputError;
using semantic_slam::Waypoint;
using semantic_slam::WaypointStatus;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const std_msgs::Header kHeader = MakeHeader(Stamp{5'000'000'007}, "map");

geometry_msgs::PoseStamped PoseAt(double x, double yaw_rad, const char* frame = "/map") {
  geometry_msgs::PoseStamped msg;
  msg.header.frame_id = frame;
  msg.pose = ToPose(Eigen::Translation3d(x, 2.0, 3.0) *
                    Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  return msg;
}

TEST(WaypointConversionsTest, ReadsAGoal) {
  const Waypoint waypoint = ToWaypoint(PoseAt(1.0, -2.0), "map");
  EXPECT_EQ(waypoint.position_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(waypoint.yaw_rad, -2.0, 1e-12);
  EXPECT_EQ(waypoint.hold_s, 0.0);
}

TEST(WaypointConversionsTest, RefusesAnotherFrameOrNoPose) {
  EXPECT_THROW(ToWaypoint(PoseAt(1.0, 0.0, "odom"), "map"), InputError);
  EXPECT_THROW(ToWaypoint(PoseAt(1.0, 0.0, ""), "map"), InputError);
  EXPECT_THROW(ToWaypoint(PoseAt(kNan, 0.0), "map"), InputError);
  geometry_msgs::PoseStamped no_turn = PoseAt(1.0, 0.0);
  no_turn.pose.orientation.w = 0.0;
  EXPECT_THROW(ToWaypoint(no_turn, "map"), InputError);
}

TEST(WaypointConversionsTest, APathComesBackAsItWas) {
  std::vector<Waypoint> waypoints(2);
  waypoints[1].position_m << 1, -2, 3;
  waypoints[1].yaw_rad = 3.0;
  const std::vector<Waypoint> back = ToWaypoints(ToPath(waypoints, kHeader), "map");
  ASSERT_EQ(back.size(), 2u);
  EXPECT_EQ(back[1].position_m, waypoints[1].position_m);
  EXPECT_NEAR(back[1].yaw_rad, 3.0, 1e-12);
}

TEST(WaypointConversionsTest, PosesOfAPathMayNameNoFrameButNoOther) {
  nav_msgs::Path path;
  path.header.frame_id = "map";
  path.poses.push_back(PoseAt(1.0, 0.0, ""));
  EXPECT_EQ(ToWaypoints(path, "map").size(), 1u);
  path.poses.push_back(PoseAt(1.0, 0.0, "odom"));
  EXPECT_THROW(ToWaypoints(path, "map"), InputError);
  path.poses.clear();
  EXPECT_THROW(ToWaypoints(path, "map"), InputError);
}

TEST(WaypointConversionsTest, ReadsOdometryWithItsTwistInTheBase) {
  nav_msgs::Odometry msg;
  msg.header = kHeader;
  msg.pose.pose = PoseAt(1.0, M_PI / 2).pose;
  msg.twist.twist.linear.x = 0.5;
  EXPECT_FALSE(ToBasePose(msg, false).velocity_odom_mps.has_value());
  const semantic_slam::BasePose pose = ToBasePose(msg, true);
  EXPECT_EQ(pose.stamp, Stamp{5'000'000'007});
  EXPECT_TRUE(pose.velocity_odom_mps->isApprox(Eigen::Vector3d(0, 0.5, 0)));
  msg.twist.twist.linear.y = kNan;
  EXPECT_NO_THROW(ToBasePose(msg, false));
  EXPECT_THROW(ToBasePose(msg, true), InputError);
}

TEST(WaypointConversionsTest, ACommandComesBackInAnyFrame) {
  AttitudeCommand command;
  command.R_world_desired = ExpSo3({0.1, -0.2, 2.0});
  command.angular_velocity_radps << 0.1, 0.2, 0.3;
  command.thrust_n = 7.5;
  const Eigen::Matrix3d R_map_base = ExpSo3({0.2, 0.1, 1.5});
  const AttitudeThrust msg = ToAttitudeThrust(command, R_map_base, kHeader);
  EXPECT_EQ(msg.header.stamp, kHeader.stamp);
  EXPECT_FALSE(msg.level);
  // The drone's own world is turned by a radian against the map.
  const Eigen::Matrix3d R_world_map = ExpSo3({0, 0, 1.0});
  const AttitudeCommand back = ToAttitudeCommand(msg, R_world_map * R_map_base);
  EXPECT_TRUE(back.R_world_desired.isApprox(R_world_map * command.R_world_desired, 1e-9));
  EXPECT_EQ(back.angular_velocity_radps, command.angular_velocity_radps);
  EXPECT_EQ(back.thrust_n, 7.5);
}

TEST(WaypointConversionsTest, ALevelCommandCountsFromLevelAtTheHeading) {
  AttitudeCommand command;
  command.R_world_desired = ExpSo3({0, 0.1, 0});
  command.thrust_n = 8.0;
  const AttitudeThrust msg = ToLevelThrust(command, kHeader);
  EXPECT_TRUE(msg.level);
  const Eigen::Matrix3d tilted = ExpSo3({0, 0, 2.0}) * ExpSo3({0.4, 0, 0});
  EXPECT_TRUE(ToAttitudeCommand(msg, tilted)
                  .R_world_desired.isApprox(ExpSo3({0, 0, 2.0}) * ExpSo3({0, 0.1, 0}), 1e-9));
}

TEST(WaypointConversionsTest, RefusesBadCommands) {
  const AttitudeThrust good =
      ToAttitudeThrust(AttitudeCommand(), Eigen::Matrix3d::Identity(), kHeader);
  const auto refuses = [](const AttitudeThrust& msg) {
    EXPECT_THROW(ToAttitudeCommand(msg, Eigen::Matrix3d::Identity()), InputError);
  };
  AttitudeThrust bad = good;
  bad.thrust = -1.0;
  refuses(bad);
  bad.thrust = kNan;
  refuses(bad);
  bad = good;
  bad.orientation.w = 0.0;
  refuses(bad);
  bad = good;
  bad.angular_velocity.z = kNan;
  refuses(bad);
}

TEST(WaypointConversionsTest, TellsTheStatus) {
  const WaypointStatus msg =
      ToWaypointStatus({semantic_slam::FlightState::kHolding, true, 2, 5}, 0.25, true, kHeader);
  EXPECT_EQ(msg.state, WaypointStatus::STATE_HOLDING);
  EXPECT_TRUE(msg.paused);
  EXPECT_TRUE(msg.localized);
  EXPECT_EQ(msg.index, 2u);
  EXPECT_EQ(msg.count, 5u);
  EXPECT_EQ(msg.distance, 0.25);
  EXPECT_EQ(msg.header.frame_id, "map");
}

}  // namespace
}  // namespace semantic_slam_ros
