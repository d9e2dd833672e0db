// Looks on while a drone flies for five seconds in lockstep with tracking and the waypoint
// controller.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <semantic_slam/AttitudeThrust.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/ros_testing.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {
namespace {

using diagnostic_msgs::DiagnosticArray;
using StateMsg = semantic_slam::TrackingState;

constexpr std::size_t kImages = 150;  // five seconds
constexpr double kLimitS = 280.0;

// Everything that comes, by stamp.
class Onlooker {
 public:
  bool SawAll() const {
    return images.size() >= kImages && states.size() >= kImages && !commands.empty();
  }

  std::vector<ros::Time> clock;
  std::vector<ros::Time> images;
  std::map<ros::Time, StateMsg> states;
  std::map<ros::Time, Rigid3d> T_world_camera;
  std::set<ros::Time> commands;
  std::map<std::string, std::string> diagnostics;  // of the simulator

 private:
  template <typename Message, typename Take>
  ros::Subscriber Listen(const char* topic, Take take) {
    return nh_.subscribe<Message>(
        topic, 1000, [take](const boost::shared_ptr<const Message>& msg) { take(*msg); });
  }
  void TakeDiagnostics(const DiagnosticArray& msg) {
    for (const auto& status : msg.status) {
      if (status.name.find("simulator") == std::string::npos) continue;
      for (const auto& value : status.values) diagnostics[value.key] = value.value;
    }
  }

  ros::NodeHandle nh_;
  ros::Subscriber clock_sub_ = Listen<rosgraph_msgs::Clock>(
      "/clock", [this](const rosgraph_msgs::Clock& msg) { clock.push_back(msg.clock); });
  ros::Subscriber image_sub_ = Listen<sensor_msgs::Image>(
      "rgb/image_raw",
      [this](const sensor_msgs::Image& msg) { images.push_back(msg.header.stamp); });
  ros::Subscriber state_sub_ = Listen<StateMsg>(
      "tracking_state", [this](const StateMsg& msg) { states[msg.header.stamp] = msg; });
  ros::Subscriber command_sub_ = Listen<semantic_slam::AttitudeThrust>(
      "attitude_thrust",
      [this](const semantic_slam::AttitudeThrust& msg) { commands.insert(msg.header.stamp); });
  ros::Subscriber truth_sub_ =
      Listen<tf2_msgs::TFMessage>("tf_ground_truth", [this](const tf2_msgs::TFMessage& msg) {
        for (const auto& link : msg.transforms) {
          T_world_camera[link.header.stamp] = ToRigid(link.transform);
        }
      });
  ros::Subscriber diagnostics_sub_ = Listen<DiagnosticArray>(
      "/diagnostics", [this](const DiagnosticArray& msg) { TakeDiagnostics(msg); });
};

TEST(SimulatorFlightTest, FliesInLockstepByTheEstimatedPose) {
  Onlooker seen;
  ASSERT_TRUE(SpinUntil([&] { return seen.SawAll() && !seen.diagnostics.empty(); }, kLimitS))
      << seen.images.size() << " images, " << seen.states.size() << " states";

  for (std::size_t i = 1; i < seen.clock.size(); ++i) EXPECT_LE(seen.clock[i - 1], seen.clock[i]);
  for (std::size_t i = 1; i < seen.images.size(); ++i) {
    // Whole nanoseconds.
    EXPECT_NEAR((seen.images[i] - seen.images[i - 1]).toSec(), 1.0 / 30.0, 2e-9);
  }
  EXPECT_EQ(seen.diagnostics["waits for tracking that ran out"], "0");
  EXPECT_EQ(seen.diagnostics["waits for control that ran out"], "0");

  // From the first answer on every image but the last has been answered to, twice. What came before
  // the onlooker had subscribed to everything does not count.
  const ros::Time first = std::max({seen.states.begin()->first, *seen.commands.begin(),
                                    seen.T_world_camera.begin()->first, seen.images.front()});
  const Rigid3d T_map_world =
      ToRigid(seen.states.at(first).T_map_camera) * seen.T_world_camera.at(first).inverse();
  double moved_m = 0.0;
  for (std::size_t i = 0; i + 1 < kImages; ++i) {
    const ros::Time stamp = seen.images[i];
    if (stamp < first) continue;
    ASSERT_EQ(seen.states.count(stamp), 1u) << "image " << i;
    ASSERT_EQ(seen.commands.count(stamp), 1u) << "image " << i;
    const StateMsg& state = seen.states.at(stamp);
    ASSERT_EQ(state.state, StateMsg::STATE_TRACKING) << "image " << i;
    const Rigid3d truth = T_map_world * seen.T_world_camera.at(stamp);
    // 5 cm: depth noise of a centimetre at 2 m, averaged over hundreds of points, in five seconds.
    EXPECT_LT((ToRigid(state.T_map_camera).translation() - truth.translation()).norm(), 0.05);
    moved_m = std::max(moved_m, (seen.T_world_camera.at(stamp).translation() -
                                 seen.T_world_camera.at(first).translation())
                                    .norm());
  }
  EXPECT_GT(moved_m, 0.8) << "it must fly for this to say anything";
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulator_flight_test");
  return RUN_ALL_TESTS();
}
