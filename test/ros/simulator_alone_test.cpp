// Looks on while the simulator flies a tour by itself, without lockstep.

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/Image.h>

#include "ros/ros_testing.h"

namespace semantic_slam_ros {
namespace {

constexpr double kLimitS = 60.0;

TEST(SimulatorAloneTest, FliesTheTourAndEndsWithIt) {
  ros::NodeHandle nh;
  Listener<sensor_msgs::Image> colour(nh, "rgb/image_raw");
  Listener<sensor_msgs::Image> depth(nh, "depth_registered/image_raw");
  Listener<nav_msgs::Odometry> odometry(nh, "ground_truth/odometry");
  Listener<rosgraph_msgs::Clock> clock(nh, "/clock");
  ASSERT_TRUE(SpinUntil([&] { return colour.count() > 10 && depth.count() > 10; }, kLimitS));
  ASSERT_TRUE(SpinUntil([&] { return !colour.connected(); }, kLimitS)) << "it does not end";
  ASSERT_TRUE(odometry.last() && clock.last());
  // At the last waypoint; 10 cm: within that it is reached.
  EXPECT_NEAR(odometry.last()->pose.pose.position.x, 1.4, 0.1);
  EXPECT_EQ(colour.last()->encoding, "bgr8");
  EXPECT_EQ(depth.last()->encoding, "32FC1");
  EXPECT_EQ(colour.last()->header.frame_id, "camera_color_optical_frame");
  EXPECT_GT(clock.last()->clock, ros::Time(101.0));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulator_alone_test");
  return RUN_ALL_TESTS();
}
