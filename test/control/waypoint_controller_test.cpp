#include "semantic_slam/control/waypoint_controller.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "control/flying_quadrotor.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Waypoint At(double x, double y, double z, double yaw_rad = 0.0) {
  Waypoint waypoint;
  waypoint.position_m << x, y, z;
  waypoint.yaw_rad = yaw_rad;
  return waypoint;
}

Rigid3d Shift(double x, double y, double z, double yaw_rad = 0.0) {
  return Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

// A quadrotor that is flown by measured poses in a frame of their own, 30 per second.
class WaypointControllerTest : public testing::Test {
 protected:
  BasePose Measured() {
    BasePose pose;
    pose.stamp = stamp_;
    pose.T_map_odom = T_map_odom_;
    pose.T_odom_base = T_odom_world_ * drone_.state().T_world_base;
    for (int axis = 0; axis < 3; ++axis) {
      pose.T_odom_base.translation()[axis] += noise_m_ * normal_(random_);
    }
    return pose;
  }

  // The command counts from the attitude at the pose, so it needs no common frame.
  void Fly(const AttitudeCommand& command, const Eigen::Matrix3d& R_map_base) {
    AttitudeCommand in_world = command;
    in_world.R_world_desired =
        drone_.state().T_world_base.linear() * R_map_base.transpose() * command.R_world_desired;
    drone_.Fly(in_world);
    stamp_.ns += 33'333'333;
  }
  void Fly() {
    const BasePose pose = Measured();
    Fly(controller_.Update(pose), (pose.T_map_odom * pose.T_odom_base).linear());
  }
  void Fly(double seconds) {
    for (int i = 0; i < std::lround(30.0 * seconds); ++i) Fly();
  }
  void FlyBlind(double seconds) {
    for (int i = 0; i < std::lround(30.0 * seconds); ++i) {
      Fly(controller_.FlyBlind(stamp_),
          LevelAttitude(drone_.state().T_world_base.linear()).transpose() *
              drone_.state().T_world_base.linear());
    }
  }

  Eigen::Vector3d PlaceInMap() const {
    return (T_map_odom_ * T_odom_world_ * drone_.state().T_world_base).translation();
  }
  double Speed() const { return drone_.state().velocity_world_mps.norm(); }

  FlyingQuadrotor drone_{Shift(3, -2, 1, 2.0)};
  WaypointController controller_;
  Rigid3d T_odom_world_ = Shift(3, -2, 1, 2.0).inverse();
  Rigid3d T_map_odom_ = Rigid3d::Identity();
  Stamp stamp_{1'000'000'000};
  double noise_m_ = 0.0;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
};

TEST_F(WaypointControllerTest, StaysWhereItFirstWas) {
  Fly(5.0);
  EXPECT_LT(PlaceInMap().norm(), 0.01);
  EXPECT_EQ(controller_.follower().status().state, FlightState::kIdle);
}

TEST_F(WaypointControllerTest, ReachesItsWaypointsByPosesAlone) {
  controller_.follower().Replace({At(2, 0, 0.3), At(2, 2, 0, 1.5)});
  Fly(20.0);
  EXPECT_EQ(controller_.follower().status().state, FlightState::kDone);
  EXPECT_LT((PlaceInMap() - Eigen::Vector3d(2, 2, 0)).norm(), 0.02);
  EXPECT_LT(controller_.DistanceToGo(), 0.02);
}

TEST_F(WaypointControllerTest, ReachesThemWithNoisyPoses) {
  noise_m_ = 0.01;
  controller_.follower().Replace({At(2, 0, 0.3), At(2, 2, 0, 1.5)});
  Fly(20.0);
  EXPECT_EQ(controller_.follower().status().state, FlightState::kDone);
  EXPECT_LT((PlaceInMap() - Eigen::Vector3d(2, 2, 0)).norm(), 0.05);  // some sigmas of the noise
  EXPECT_LT(Speed(), 0.15);
}

TEST_F(WaypointControllerTest, BelievesAVelocityThatIsGiven) {
  Fly();
  BasePose pose = Measured();
  pose.velocity_odom_mps = Eigen::Vector3d(1.0, 0.0, 0.0);
  const AttitudeCommand command = controller_.Update(pose);
  EXPECT_LT(command.R_world_desired(0, 2), -0.2);  // it brakes
}

TEST_F(WaypointControllerTest, ACorrectionOfTheMapIsNoJerk) {
  controller_.follower().Replace({At(5, 0, 0)});
  Fly(3.0);
  const Eigen::Matrix3d before = drone_.state().T_world_base.linear();
  const double speed = Speed();
  T_map_odom_ = Shift(0.4, 0.3, 0.0, 0.05) * T_map_odom_;
  for (int i = 0; i < 15; ++i) {
    Fly();
    // Half a metre of error would tilt the drone by its 30 degrees; what is left is the turn of 3.
    EXPECT_LT(RotationAngle(before.transpose() * drone_.state().T_world_base.linear()), 0.12);
    EXPECT_NEAR(Speed(), speed, 0.15);
  }
  Fly(10.0);
  EXPECT_LT((PlaceInMap() - Eigen::Vector3d(5, 0, 0)).norm(), 0.02);
}

TEST_F(WaypointControllerTest, AJumpOfTheOdometryIsNoJerk) {
  controller_.follower().Replace({At(5, 0, 0)});
  Fly(3.0);
  const double speed = Speed();
  T_odom_world_ = Shift(-1.0, 0.5, 0.0) * T_odom_world_;
  for (int i = 0; i < 15; ++i) {
    Fly();
    EXPECT_NEAR(Speed(), speed, 0.2);
  }
  Fly(15.0);
  EXPECT_LT((PlaceInMap() - Eigen::Vector3d(5, 0, 0)).norm(), 0.02);
}

TEST_F(WaypointControllerTest, BrakesBlindlyAndGoesOnWhenThePoseIsBack) {
  controller_.follower().Replace({At(5, 0, 0)});
  Fly(4.0);
  ASSERT_GT(Speed(), 0.5);
  const Eigen::Vector3d before = PlaceInMap();
  FlyBlind(2.0);
  EXPECT_LT(Speed(), 0.15);
  EXPECT_LT((PlaceInMap() - before).norm(), 0.7);  // 0.7 m/s / 2 per s, and the lag of the attitude
  EXPECT_LT(std::abs(PlaceInMap().z()), 0.1);
  Fly(15.0);
  EXPECT_LT((PlaceInMap() - Eigen::Vector3d(5, 0, 0)).norm(), 0.02);
}

TEST_F(WaypointControllerTest, BlindFromTheStartItHovers) {
  FlyBlind(3.0);
  EXPECT_LT(Speed(), 0.01);
}

TEST_F(WaypointControllerTest, AGapBeginsTheReferenceAnew) {
  controller_.follower().Replace({At(5, 0, 0)});
  Fly(3.0);
  const Eigen::Vector3d before = PlaceInMap();
  stamp_.ns += 5'000'000'000;  // the clock went on, the drone did not
  Fly(1.0);
  EXPECT_LT((PlaceInMap() - before).norm(), 0.7);  // no way of 5 s at 0.7 m/s is made up for
  Fly(15.0);
  EXPECT_LT((PlaceInMap() - Eigen::Vector3d(5, 0, 0)).norm(), 0.02);
}

TEST_F(WaypointControllerTest, RefusesBadPosesAndGoesOn) {
  Fly(0.5);
  BasePose pose = Measured();
  pose.T_odom_base.translation().x() = kNan;
  EXPECT_THROW(controller_.Update(pose), InputError);
  pose = Measured();
  pose.T_map_odom.linear()(0, 0) = kNan;
  EXPECT_THROW(controller_.Update(pose), InputError);
  pose = Measured();
  pose.velocity_odom_mps = Eigen::Vector3d(kNan, 0, 0);
  EXPECT_THROW(controller_.Update(pose), InputError);
  pose = Measured();
  pose.stamp.ns -= 33'333'333;  // the last one's
  EXPECT_THROW(controller_.Update(pose), InputError);
  Fly(2.0);
  EXPECT_LT(PlaceInMap().norm(), 0.01);
}

TEST_F(WaypointControllerTest, RefusesOptionsOutOfRange) {
  WaypointControllerOptions options;
  options.follower.max_lag_m = -1.0;
  EXPECT_THROW(WaypointController{options}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
