#include "semantic_slam/control/waypoint_follower.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kPeriodS = 1.0 / 30.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Waypoint At(double x, double y, double yaw_rad = 0.0, double hold_s = 0.0) {
  Waypoint waypoint;
  waypoint.position_m << x, y, 1.0;
  waypoint.yaw_rad = yaw_rad;
  waypoint.hold_s = hold_s;
  return waypoint;
}

// A follower and a drone that is where the reference is.
class WaypointFollowerTest : public testing::Test {
 protected:
  WaypointFollowerTest() {
    drone_.position_m << 0.0, 0.0, 1.0;
    follower_.StartFrom(drone_);
  }

  void Advance() {
    const FlightReference reference = follower_.Advance(drone_, kPeriodS);
    drone_ = {reference.position_m, reference.velocity_mps, reference.yaw_rad};
  }
  void Advance(double seconds) {
    for (int i = 0; i < std::lround(seconds / kPeriodS); ++i) Advance();
  }
  // Returns the seconds it took until `state`; nothing within five minutes is a failure.
  double AdvanceUntil(FlightState state) {
    for (int i = 0; i < 9000; ++i) {
      if (follower_.status().state == state) return i * kPeriodS;
      Advance();
    }
    ADD_FAILURE() << "never " << ToString(state);
    return 0.0;
  }

  WaypointFollower follower_;
  DronePlace drone_;
};

TEST_F(WaypointFollowerTest, StaysWithoutWaypoints) {
  Advance(5.0);
  EXPECT_EQ(follower_.status().state, FlightState::kIdle);
  EXPECT_EQ(follower_.status().count, 0u);
  EXPECT_EQ(drone_.position_m, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(follower_.DistanceToGo(drone_.position_m), 0.0);
}

TEST_F(WaypointFollowerTest, FliesToOneAndStaysThere) {
  follower_.Replace({At(3, 4, 1.0)});
  EXPECT_EQ(follower_.status().state, FlightState::kFlying);
  EXPECT_NEAR(follower_.DistanceToGo(drone_.position_m), 5.0, 1e-12);
  AdvanceUntil(FlightState::kDone);
  Advance(5.0);
  EXPECT_LT((drone_.position_m - Eigen::Vector3d(3, 4, 1)).norm(), 1e-3);
  EXPECT_NEAR(drone_.yaw_rad, 1.0, 1e-3);
  EXPECT_EQ(follower_.status().index, 0u);
  EXPECT_EQ(follower_.status().count, 1u);
}

TEST_F(WaypointFollowerTest, VisitsThemInOrderWithoutLeavingOneOut) {
  const std::vector<Waypoint> waypoints{At(2, 0, 0.0, 0.5), At(4, 0, 1.0), At(4, 2, 2.0),
                                        At(2, 2, -3.0), At(0, 0, 0.0)};
  follower_.Replace(waypoints);
  std::vector<double> nearest(waypoints.size(), 1e9);
  std::size_t last = 0;
  while (follower_.status().state != FlightState::kDone) {
    Advance();
    const std::size_t now = follower_.status().index;
    ASSERT_LE(last, now);
    ASSERT_LE(now, last + 1);
    nearest[last] =
        std::min(nearest[last], (drone_.position_m - waypoints[last].position_m).norm());
    last = now;
  }
  for (std::size_t i = 0; i < nearest.size(); ++i) EXPECT_LT(nearest[i], 0.31) << i;  // the corner
}

TEST_F(WaypointFollowerTest, DoesNotStopAtCorners) {
  follower_.Replace({At(0, 0), At(3, 0), At(3, 3)});
  Advance(3.0);  // over the start, where it does stop
  ASSERT_EQ(follower_.status().index, 1u);
  double slowest = 1e9;
  while (drone_.position_m.y() < 1.0) {
    Advance();
    if (drone_.position_m.x() > 2.0) slowest = std::min(slowest, drone_.velocity_mps.norm());
  }
  EXPECT_GT(slowest, 0.2);
}

TEST_F(WaypointFollowerTest, KeepsSpeedAndDoesNotOvershoot) {
  follower_.Replace({At(5, 0)});
  double fastest = 0.0, farthest = 0.0;
  while (follower_.status().state != FlightState::kDone) {
    Advance();
    fastest = std::max(fastest, drone_.velocity_mps.norm());
    farthest = std::max(farthest, drone_.position_m.x());
  }
  Advance(5.0);
  EXPECT_LT(fastest, 0.7 * 1.05);
  EXPECT_LT(std::max(farthest, drone_.position_m.x()), 5.0 + 0.005);
}

TEST_F(WaypointFollowerTest, HoldsAsLongAsAWaypointWants) {
  follower_.Replace({At(0, 0, 0.0, 3.0), At(1, 0)});
  AdvanceUntil(FlightState::kHolding);
  EXPECT_NEAR(AdvanceUntil(FlightState::kFlying), 3.0, 2.0 * kPeriodS);
  EXPECT_EQ(follower_.status().index, 1u);
}

TEST_F(WaypointFollowerTest, IdenticalWaypointsAreReachedOneAfterTheOther) {
  follower_.Replace({At(1, 0), At(1, 0), At(1, 0)});
  AdvanceUntil(FlightState::kDone);
  EXPECT_EQ(follower_.status().index, 2u);
}

TEST_F(WaypointFollowerTest, TurnsOnTheSpot) {
  follower_.Replace({At(0, 0, 3.0), At(0, 0, -3.0)});
  AdvanceUntil(FlightState::kDone);
  Advance(3.0);
  EXPECT_NEAR(drone_.yaw_rad, -3.0, 1e-3);
  EXPECT_LT((drone_.position_m - Eigen::Vector3d(0, 0, 1)).norm(), 1e-6);
}

TEST_F(WaypointFollowerTest, ArrivesWithItsHeading) {
  follower_.Replace({At(0.5, 0, 3.0), At(3, 0, 3.0)});
  // Half a metre takes a second, half a turn four: the first is not left before the heading is
  // there.
  while (follower_.status().index == 0) Advance();
  EXPECT_LT(std::abs(3.0 - drone_.yaw_rad), 0.2 + 1e-9);
}

TEST_F(WaypointFollowerTest, WaitsForADroneThatIsBehind) {
  follower_.Replace({At(10, 0)});
  for (int i = 0; i < 600; ++i) follower_.Advance(drone_, kPeriodS);  // it does not move
  const FlightReference reference = follower_.Advance(drone_, kPeriodS);
  EXPECT_LT((reference.position_m - drone_.position_m).norm(), 0.8);  // 0.6, and to brake
  EXPECT_LT(reference.velocity_mps.norm(), 1e-2);
}

TEST_F(WaypointFollowerTest, PausesAndGoesOn) {
  follower_.Replace({At(5, 0)});
  Advance(3.0);
  const double before = drone_.position_m.x();
  follower_.SetPaused(true);
  Advance(10.0);
  EXPECT_TRUE(follower_.status().paused);
  EXPECT_LT(drone_.velocity_mps.norm(), 1e-3);
  EXPECT_GT(drone_.position_m.x(), before);  // it braked, and did not turn back
  EXPECT_LT(drone_.position_m.x(), before + 1.0);
  follower_.SetPaused(false);
  AdvanceUntil(FlightState::kDone);
  EXPECT_NEAR(drone_.position_m.x(), 5.0, 0.11);
}

TEST_F(WaypointFollowerTest, ClearBrakesAndForgets) {
  follower_.Replace({At(5, 0)});
  Advance(3.0);
  follower_.Clear();
  EXPECT_EQ(follower_.status().state, FlightState::kIdle);
  Advance(10.0);
  EXPECT_LT(drone_.velocity_mps.norm(), 1e-3);
  EXPECT_LT(drone_.position_m.x(), 3.0);
}

TEST_F(WaypointFollowerTest, AppendsUnderWayAndBeginsAnewAfterTheLast) {
  follower_.Append(At(1, 0));
  follower_.Append(At(2, 0));
  EXPECT_EQ(follower_.status().count, 2u);
  AdvanceUntil(FlightState::kDone);
  follower_.Append(At(0, 0));
  EXPECT_EQ(follower_.status().count, 1u);
  EXPECT_EQ(follower_.status().index, 0u);
  AdvanceUntil(FlightState::kDone);
  EXPECT_LT((drone_.position_m - Eigen::Vector3d(0, 0, 1)).norm(), 0.11);
}

TEST_F(WaypointFollowerTest, AReplacedPathIsFlownFromWhereTheReferenceIs) {
  follower_.Replace({At(5, 0)});
  Advance(3.0);
  const DronePlace before = drone_;
  follower_.Replace({At(0, 3)});
  Advance();
  EXPECT_LT((drone_.position_m - before.position_m).norm(), 0.7 * 1.05 * kPeriodS);
  EXPECT_LT((drone_.velocity_mps - before.velocity_mps).norm(), 0.05);  // 0.8 m/s^2 for a thirtieth
}

TEST_F(WaypointFollowerTest, ACorrectionMovesTheReferenceAndNotTheWaypoints) {
  follower_.Replace({At(5, 0)});
  Advance(3.0);
  Rigid3d T_new_old = Rigid3d::Identity();
  T_new_old.translation() << 0.3, -0.4, 0.0;
  const Eigen::Vector3d before = drone_.position_m;
  follower_.FollowCorrection(T_new_old);
  drone_.position_m = T_new_old * drone_.position_m;
  Advance();
  EXPECT_LT((drone_.position_m - T_new_old * before).norm(), 0.7 * 1.05 * kPeriodS);
  AdvanceUntil(FlightState::kDone);
  Advance(3.0);
  EXPECT_LT((drone_.position_m - Eigen::Vector3d(5, 0, 1)).norm(), 1e-2);
}

TEST_F(WaypointFollowerTest, RefusesBadWaypointsAndKeepsTheOldOnes) {
  follower_.Replace({At(1, 0)});
  EXPECT_THROW(follower_.Replace({At(2, 0), At(kNan, 0)}), InputError);
  EXPECT_THROW(follower_.Replace({At(2, 0, kNan)}), InputError);
  EXPECT_THROW(follower_.Append(At(2, 0, 0.0, -1.0)), InputError);
  EXPECT_THROW(follower_.Append(At(2, 1e300)), InputError);
  EXPECT_THROW(follower_.Replace(std::vector<Waypoint>(WaypointFollower::kMaxWaypoints + 1)),
               InputError);
  ASSERT_EQ(follower_.waypoints().size(), 1u);
  EXPECT_EQ(follower_.waypoints()[0].position_m.x(), 1.0);
}

TEST_F(WaypointFollowerTest, RefusesOptionsOutOfRange) {
  WaypointFollowerOptions options;
  options.max_speed_mps = 0.0;
  EXPECT_THROW(WaypointFollower{options}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
