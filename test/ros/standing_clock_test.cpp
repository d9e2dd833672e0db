// A bag that is paused, or not yet started: simulated time stands, and nodes must say how they are.

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "ros/ros_testing.h"

namespace semantic_slam_ros {
namespace {

TEST(StandingClockTest, DiagnosticsGoOn) {
  ros::NodeHandle nh;
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics(nh, "/diagnostics");
  // The first may be what the updater sends when a task is added.
  EXPECT_TRUE(SpinUntil([&] { return diagnostics.count() >= 3; }, 20.0));
  ASSERT_TRUE(diagnostics.last());
  EXPECT_EQ(DiagnosticValue(*diagnostics.last(), "images"), "0");
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "standing_clock_test");
  return RUN_ALL_TESTS();
}
