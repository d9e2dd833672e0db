// Flies a simulated quadrotor over real topics, in lockstep, by waypoint_controller, as a node and
// as a nodelet (waypoint_controller_node.test, waypoint_controller_nodelet.test): by tracking's
// odometry and state, and, in the namespace "truth", by ground truth.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <semantic_slam/AttitudeThrust.h>
#include <semantic_slam/TrackingState.h>
#include <semantic_slam/WaypointStatus.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "control/flying_quadrotor.h"
#include "ros/ros_testing.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/tracking_conversions.h"
#include "semantic_slam_ros/waypoint_conversions.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::AttitudeThrust;
using semantic_slam::FlyingQuadrotor;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;
using semantic_slam::Waypoint;
using semantic_slam::WaypointStatus;

constexpr double kLimitS = 15.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSteadyM =
    0.03;  // 2 cm is what is asked of the controller; and rounding of stamps

Waypoint At(double x, double y, double z, double yaw_rad = 0.0) {
  Waypoint waypoint;
  waypoint.position_m << x, y, z;
  waypoint.yaw_rad = yaw_rad;
  return waypoint;
}

Rigid3d Shift(double x, double y, double z, double yaw_rad) {
  return Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

class WaypointControllerNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return commands_.connected() && statuses_.connected() &&
                 odometry_pub_.getNumSubscribers() > 0 && state_pub_.getNumSubscribers() > 0 &&
                 waypoints_pub_.getNumSubscribers() > 0 && goal_pub_.getNumSubscribers() > 0;
        },
        kLimitS))
        << "waypoint_controller did not connect; is it running?";
    Call("waypoint_controller/reset");
    SetPaused(false);
    stamp_.ns += 10'000'000'000;  // a gap: poses of the last test mean nothing
  }

  void Call(const std::string& service) {
    std_srvs::Trigger trigger;
    ASSERT_TRUE(ros::service::call(service, trigger));
    EXPECT_TRUE(trigger.response.success);
  }
  void SetPaused(bool paused) {
    std_srvs::SetBool pause;
    pause.request.data = paused;
    ASSERT_TRUE(ros::service::call("waypoint_controller/pause", pause));
  }

  Rigid3d MapPose() const { return drone_.state().T_world_base; }  // the map is the world here

  nav_msgs::Odometry Odometry() const {
    nav_msgs::Odometry msg;
    msg.header = MakeHeader(stamp_, "odom");
    msg.child_frame_id = "base_link";
    msg.pose.pose = ToPose(T_map_odom_.inverse() * MapPose());
    return msg;
  }
  semantic_slam::TrackingState State(TrackingStatus status) const {
    TrackedImage image;
    image.stamp = stamp_;
    image.status = status;
    image.map_id = map_id_;
    image.keyframe_id = 0;
    image.T_map_camera = MapPose();
    image.T_odom_camera = T_map_odom_.inverse() * MapPose();
    return ToTrackingState(image, "map", "camera");
  }

  // Waits for the command at the present stamp and flies by it.
  AttitudeThrust Obey() {
    const ros::Time stamp = ToRos(stamp_);
    const bool came = SpinUntil(
        [&] { return commands_.last() && commands_.last()->header.stamp == stamp; }, kLimitS);
    EXPECT_TRUE(came) << "no command at " << stamp;
    if (!came) return AttitudeThrust();
    const AttitudeThrust command = *commands_.last();
    drone_.Fly(ToAttitudeCommand(command, MapPose().linear()));
    Tick();
    return command;
  }
  static void Tick() { stamp_.ns += 33'333'333; }

  AttitudeThrust Fly() {
    odometry_pub_.publish(Odometry());
    state_pub_.publish(State(TrackingStatus::kTracking));
    return Obey();
  }
  void Fly(double seconds) {
    for (int i = 0; i < std::lround(30.0 * seconds) && !HasFailure(); ++i) Fly();
  }
  AttitudeThrust FlyLost() {
    state_pub_.publish(State(TrackingStatus::kLost));
    return Obey();
  }
  // Until the status says so, for at most a minute of flight.
  void FlyUntil(std::uint8_t state) {
    for (int i = 0; i < 1800 && !HasFailure(); ++i) {
      if (WaitForStatus().state == state) return;
      Fly();
    }
    ADD_FAILURE() << "never in state " << int{state};
  }
  // That of the last command.
  WaypointStatus WaitForStatus() {
    SpinUntil(
        [&] {
          return statuses_.last() && commands_.last() &&
                 statuses_.last()->header.stamp >= commands_.last()->header.stamp;
        },
        kLimitS);
    return statuses_.last() ? *statuses_.last() : WaypointStatus();
  }

  nav_msgs::Path PathOf(const std::vector<Waypoint>& waypoints, const char* frame = "map") const {
    return ToPath(waypoints, MakeHeader(stamp_, frame));
  }
  // Sends a path and waits until it is taken over.
  void Send(const std::vector<Waypoint>& waypoints) {
    waypoints_pub_.publish(PathOf(waypoints));
    EXPECT_TRUE(SpinUntil(
        [&] { return paths_.last() && paths_.last()->poses.size() == waypoints.size(); }, kLimitS));
  }
  void SendGoal(const Waypoint& goal) {
    paths_.Forget();
    goal_pub_.publish(PathOf({goal}).poses.front());
    EXPECT_TRUE(SpinUntil([&] { return paths_.last() != nullptr; }, kLimitS));
  }

  double ErrorTo(const Waypoint& waypoint) const {
    return (MapPose().translation() - waypoint.position_m).norm();
  }
  int Dropped(const std::string& cause) {
    if (!diagnostics_.last()) return 0;
    const std::string text = DiagnosticValue(*diagnostics_.last(), "dropped: " + cause);
    return text.empty() ? 0 : std::stoi(text);
  }
  // Expects that what `send` sends is dropped and counted under `cause`.
  template <typename Sender>
  void ExpectDropped(const std::string& cause, Sender send) {
    diagnostics_.Forget();
    ASSERT_TRUE(SpinUntil([&] { return diagnostics_.count() > 1; }, kLimitS));
    const int before = Dropped(cause);
    send();
    EXPECT_TRUE(SpinUntil([&] { return Dropped(cause) == before + 1; }, kLimitS)) << cause;
  }

  static Stamp stamp_;  // time goes on from test to test
  static int map_id_;   // likewise

  ros::NodeHandle nh_;
  Listener<AttitudeThrust> commands_{nh_, "attitude_thrust"};
  Listener<WaypointStatus> statuses_{nh_, "waypoint_status"};
  Listener<nav_msgs::Path> paths_{nh_, "reference_path"};
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "test_diagnostics"};
  ros::Publisher odometry_pub_ = nh_.advertise<nav_msgs::Odometry>("odometry", 10);
  ros::Publisher state_pub_ = nh_.advertise<semantic_slam::TrackingState>("tracking_state", 10);
  ros::Publisher waypoints_pub_ = nh_.advertise<nav_msgs::Path>("waypoints", 10);
  ros::Publisher goal_pub_ = nh_.advertise<geometry_msgs::PoseStamped>("goal", 10);
  FlyingQuadrotor drone_{Shift(1.0, 2.0, 0.5, 0.8)};
  Rigid3d T_map_odom_ = Shift(0.4, -0.3, 0.1, 0.3);
};

Stamp WaypointControllerNodeTest::stamp_{1'000'000'000};
int WaypointControllerNodeTest::map_id_ = 0;

TEST_F(WaypointControllerNodeTest, KeepsItsPlaceWithoutWaypoints) {
  const AttitudeThrust command = Fly();
  EXPECT_EQ(command.header.frame_id, "base_link");
  EXPECT_FALSE(command.level);
  Fly(3.0);
  EXPECT_LT(ErrorTo(At(1.0, 2.0, 0.5)), kSteadyM);
  const WaypointStatus status = WaitForStatus();
  EXPECT_EQ(status.state, WaypointStatus::STATE_IDLE);
  EXPECT_EQ(status.count, 0u);
  EXPECT_TRUE(status.localized);
  EXPECT_EQ(status.header.frame_id, "map");
}

TEST_F(WaypointControllerNodeTest, FliesAPathInTheMap) {
  Fly(0.5);
  Send({At(2.0, 2.0, 1.0), At(2.0, 3.0, 1.0, 2.0)});
  Fly();
  const WaypointStatus status = WaitForStatus();
  EXPECT_EQ(status.state, WaypointStatus::STATE_FLYING);
  EXPECT_EQ(status.index, 0u);
  EXPECT_EQ(status.count, 2u);
  EXPECT_NEAR(status.distance, std::hypot(1.0, 0.5), 0.05);
  FlyUntil(WaypointStatus::STATE_DONE);
  Fly(4.0);
  EXPECT_LT(ErrorTo(At(2.0, 3.0, 1.0)), kSteadyM);
  EXPECT_NEAR(semantic_slam::Heading(MapPose().linear()), 2.0, 0.03);
  EXPECT_EQ(WaitForStatus().index, 1u);
}

TEST_F(WaypointControllerNodeTest, AppendsGoals) {
  Fly(0.5);
  SendGoal(At(1.5, 2.0, 0.5));
  SendGoal(At(1.5, 2.5, 0.5));
  Fly();
  EXPECT_EQ(WaitForStatus().count, 2u);
  FlyUntil(WaypointStatus::STATE_DONE);
  EXPECT_LT(ErrorTo(At(1.5, 2.5, 0.5)), 0.11);  // what counts as reached
}

TEST_F(WaypointControllerNodeTest, FollowsACorrectionOfTheMap) {
  Send({At(3.0, 2.0, 0.5, 0.8)});
  Fly(2.0);
  // The drift is taken out: the same odometry is elsewhere in the map, and so is the drone.
  T_map_odom_ = Shift(0.2, 0.1, 0.0, 0.05) * T_map_odom_;
  Fly(12.0);
  EXPECT_LT(ErrorTo(At(3.0, 2.0, 0.5)), kSteadyM);
}

TEST_F(WaypointControllerNodeTest, PauseHoldsAndGoesOn) {
  Send({At(4.0, 2.0, 0.5)});
  Fly(2.5);
  SetPaused(true);
  Fly(4.0);
  EXPECT_TRUE(WaitForStatus().paused);
  const double x = MapPose().translation().x();
  Fly(2.0);
  EXPECT_NEAR(MapPose().translation().x(), x, kSteadyM);
  EXPECT_LT(x, 3.5);
  SetPaused(false);
  FlyUntil(WaypointStatus::STATE_DONE);
  EXPECT_LT(ErrorTo(At(4.0, 2.0, 0.5)), 0.11);
}

TEST_F(WaypointControllerNodeTest, ClearForgetsTheWaypoints) {
  Send({At(4.0, 2.0, 0.5)});
  Fly(2.0);
  Call("waypoint_controller/clear");
  Fly(5.0);
  EXPECT_EQ(WaitForStatus().state, WaypointStatus::STATE_IDLE);
  EXPECT_LT(drone_.state().velocity_world_mps.norm(), 0.05);
  EXPECT_LT(MapPose().translation().x(), 3.0);
}

TEST_F(WaypointControllerNodeTest, FliesLevelWhileTheCameraIsLost) {
  Send({At(4.0, 2.0, 0.5, 0.8)});
  Fly(2.5);
  const AttitudeThrust command = FlyLost();
  EXPECT_TRUE(command.level);
  EXPECT_NEAR(command.thrust, 8.0, 1.0);
  EXPECT_FALSE(WaitForStatus().localized);
  for (int i = 0; i < 60; ++i) FlyLost();
  EXPECT_LT(drone_.state().velocity_world_mps.norm(), 0.2);
  FlyUntil(WaypointStatus::STATE_DONE);
  EXPECT_LT(ErrorTo(At(4.0, 2.0, 0.5)), 0.11);
}

TEST_F(WaypointControllerNodeTest, AnotherMapForgetsTheWaypoints) {
  Fly();
  Send({At(4.0, 2.0, 0.5)});
  Fly(0.5);
  ++map_id_;
  Fly();
  EXPECT_EQ(WaitForStatus().state, WaypointStatus::STATE_IDLE);
}

TEST_F(WaypointControllerNodeTest, DropsBadMessagesAndGoesOn) {
  Fly(1.0);
  ExpectDropped("bad_stamp", [&] {
    nav_msgs::Odometry msg = Odometry();
    msg.header.stamp = ros::Time();
    odometry_pub_.publish(msg);
  });
  ExpectDropped("bad_odometry", [&] {
    nav_msgs::Odometry msg = Odometry();
    msg.pose.pose.position.x = kNan;
    odometry_pub_.publish(msg);
  });
  ExpectDropped("bad_tracking_state", [&] {
    semantic_slam::TrackingState msg = State(TrackingStatus::kTracking);
    msg.T_map_camera.orientation.w = kNan;
    state_pub_.publish(msg);
  });
  ExpectDropped("out_of_order", [&] {
    stamp_.ns -= 100'000'000;
    odometry_pub_.publish(Odometry());
    state_pub_.publish(State(TrackingStatus::kTracking));
    stamp_.ns += 100'000'000;
  });
  ExpectDropped("bad_waypoints", [&] { waypoints_pub_.publish(PathOf({})); });
  ExpectDropped("bad_waypoints", [&] { waypoints_pub_.publish(PathOf({At(0, kNan, 0)})); });
  ExpectDropped("bad_waypoints", [&] { waypoints_pub_.publish(PathOf({At(0, 0, 0)}, "other")); });
  ExpectDropped("bad_waypoints", [&] {
    geometry_msgs::PoseStamped goal;
    goal.header.frame_id = "map";  // a quaternion of zeros
    goal_pub_.publish(goal);
  });
  Fly(2.0);
  EXPECT_LT(ErrorTo(At(1.0, 2.0, 0.5)), kSteadyM);
}

TEST_F(WaypointControllerNodeTest, TimeThatJumpsBackBeginsANewFlight) {
  Send({At(4.0, 2.0, 0.5)});
  Fly(1.0);
  stamp_.ns -= 5'000'000'000;
  Fly();
  const auto is_idle = [&] {
    return statuses_.last() && statuses_.last()->state == WaypointStatus::STATE_IDLE;
  };
  EXPECT_TRUE(SpinUntil(is_idle, kLimitS));  // there is no file
}

TEST(WaypointControllerByTruthTest, FliesTheTourOfItsFile) {
  ros::NodeHandle nh("truth");
  Listener<AttitudeThrust> commands(nh, "attitude_thrust");
  Listener<WaypointStatus> statuses(nh, "waypoint_status");
  ros::Publisher odometry_pub = nh.advertise<nav_msgs::Odometry>("odometry", 10);
  ASSERT_TRUE(SpinUntil(
      [&] { return commands.connected() && odometry_pub.getNumSubscribers() > 0; }, kLimitS));
  FlyingQuadrotor drone(Shift(1.0, 1.0, 1.2, M_PI / 2));  // the file's first waypoint
  Stamp stamp{5'000'000'000};
  for (int i = 0; i < 1800; ++i) {
    nav_msgs::Odometry msg;
    msg.header = MakeHeader(stamp, "world");
    msg.child_frame_id = "base_link";
    msg.pose.pose = ToPose(drone.state().T_world_base);
    const Eigen::Vector3d velocity =
        drone.state().T_world_base.linear().transpose() * drone.state().velocity_world_mps;
    msg.twist.twist.linear.x = velocity.x();
    msg.twist.twist.linear.y = velocity.y();
    msg.twist.twist.linear.z = velocity.z();
    odometry_pub.publish(msg);
    ASSERT_TRUE(SpinUntil(
        [&] { return commands.last() && commands.last()->header.stamp == ToRos(stamp); }, kLimitS));
    drone.Fly(ToAttitudeCommand(*commands.last(), drone.state().T_world_base.linear()));
    stamp.ns += 33'333'333;
    if (statuses.last() && statuses.last()->state == WaypointStatus::STATE_DONE) break;
  }
  ASSERT_TRUE(statuses.last());
  EXPECT_EQ(statuses.last()->state, WaypointStatus::STATE_DONE);
  EXPECT_EQ(statuses.last()->count, 3u);
  EXPECT_LT((drone.state().T_world_base.translation() - Eigen::Vector3d(2.5, 2.0, 1.2)).norm(),
            0.11);
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "waypoint_controller_node_test");
  return RUN_ALL_TESTS();
}
