#include "semantic_slam_ros/node_health.h"

#include <gtest/gtest.h>

#include "ros/ros_testing.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam_ros {
namespace {

using diagnostic_msgs::DiagnosticArray;

constexpr double kLimitS = 10.0;

TEST(NodeHealthTest, TellsStateLatencyAndDrops) {
  ros::NodeHandle nh, private_nh("~told");
  private_nh.setParam("diagnostic_period", 0.1);
  DropCounter drops;
  NodeHealth health(nh, private_nh, "stage", drops, [](NodeHealth::Status& status) {
    status.summary(diagnostic_msgs::DiagnosticStatus::WARN, "waiting");
    status.add("images", 5);
  });
  drops.AddQuietly("late", 3);
  health.AddLatency(std::chrono::steady_clock::now() - std::chrono::milliseconds(100));
  EXPECT_EQ(health.processed(), 1);
  Listener<DiagnosticArray> diagnostics(nh, "/diagnostics");
  ASSERT_TRUE(SpinUntil(
      [&] {
        return diagnostics.last() && DiagnosticValue(*diagnostics.last(), "dropped: late") == "3";
      },
      kLimitS));
  const DiagnosticArray& array = *diagnostics.last();
  ASSERT_EQ(array.status.size(), 1u);
  EXPECT_NE(array.status[0].name.find("stage"), std::string::npos);
  EXPECT_EQ(array.status[0].level, diagnostic_msgs::DiagnosticStatus::WARN);
  EXPECT_EQ(array.status[0].message, "waiting");
  EXPECT_EQ(DiagnosticValue(array, "images"), "5");
  EXPECT_GE(std::stod(DiagnosticValue(array, "latency median [ms]")), 98.0) << "buckets of 2 %";
  EXPECT_NE(DiagnosticValue(array, "latency 95 % [ms]"), "");
}

TEST(NodeHealthTest, RefusesAPeriodOutOfRange) {
  ros::NodeHandle nh, private_nh("~refused");
  private_nh.setParam("diagnostic_period", 0.0);
  const DropCounter drops;
  semantic_slam::ExpectOneLineWith(
      semantic_slam::MessageOf<semantic_slam::ConfigError>(
          [&] { NodeHealth(nh, private_nh, "stage", drops, [](NodeHealth::Status&) {}); }),
      {"/refused/diagnostic_period = 0, but must be in [0.1, 60]"});
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_health_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
