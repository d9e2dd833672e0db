#include "semantic_slam/control/speed_limits.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Waypoint At(double x, double y, double hold_s = 0.0) {
  Waypoint waypoint;
  waypoint.position_m << x, y, 1.0;
  waypoint.hold_s = hold_s;
  return waypoint;
}

CornerLimits Limits() {
  CornerLimits limits;
  limits.radius_m = 0.5;
  limits.max_speed_mps = 2.0;
  limits.max_acceleration_mps2 = 1.0;
  limits.max_deceleration_mps2 = 0.5;
  return limits;
}

TEST(BrakingSpeedTest, IsProportionalNearTheStopAndBrakesEvenlyFarFromIt) {
  EXPECT_EQ(BrakingSpeed(0.0, 0.5, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(BrakingSpeed(0.1, 0.5, 2.0), 0.2);
  // v^2 falls by 2 a per metre.
  EXPECT_NEAR(std::pow(BrakingSpeed(5.0, 0.5, 2.0), 2) - std::pow(BrakingSpeed(4.0, 0.5, 2.0), 2),
              1.0, 1e-12);
}

TEST(BrakingSpeedTest, IsContinuousWhereTheTwoMeet) {
  const double seam = 0.5 / 4.0;
  EXPECT_NEAR(BrakingSpeed(seam - 1e-9, 0.5, 2.0), BrakingSpeed(seam + 1e-9, 0.5, 2.0), 1e-8);
}

TEST(PlanPassagesTest, NoneForNone) {
  EXPECT_TRUE(PlanPassages({}, Limits()).empty());
}

TEST(PlanPassagesTest, StopsAtTheFirstAtTheLastAndAtHolds) {
  const auto passages = PlanPassages({At(0, 0), At(10, 0, 1.0), At(20, 0)}, Limits());
  for (const Passage& passage : passages) EXPECT_EQ(passage.speed_mps, 0.0);
}

TEST(PlanPassagesTest, PassesAStraightWayAtFullSpeed) {
  const auto passages = PlanPassages({At(0, 0), At(10, 0), At(20, 0)}, Limits());
  EXPECT_DOUBLE_EQ(passages[1].speed_mps, 2.0);
  EXPECT_DOUBLE_EQ(passages[1].radius_m, 0.5);
}

TEST(PlanPassagesTest, TurnsACornerOnAnArcThatTheAccelerationAllows) {
  const auto passages = PlanPassages({At(0, 0), At(10, 0), At(10, 10)}, Limits());
  // A right angle: the arc's radius is the passage's, and v^2 / r = a.
  EXPECT_NEAR(passages[1].speed_mps, std::sqrt(1.0 * 0.5), 1e-12);
}

TEST(PlanPassagesTest, AlmostStopsWhereTheWayTurnsBack) {
  const auto passages = PlanPassages({At(0, 0), At(10, 0), At(0, 0)}, Limits());
  EXPECT_LT(passages[1].speed_mps, 1e-3);
}

TEST(PlanPassagesTest, KeepsToHalfOfShortLegs) {
  const auto passages = PlanPassages({At(0, 0), At(10, 0), At(10.4, 0), At(20, 0)}, Limits());
  EXPECT_NEAR(passages[1].radius_m, 0.2, 1e-12);
  EXPECT_NEAR(passages[2].radius_m, 0.2, 1e-12);
}

TEST(PlanPassagesTest, BrakesInTimeForTheNextStop) {
  const auto passages = PlanPassages({At(0, 0), At(10, 0), At(11, 0)}, Limits());
  EXPECT_NEAR(passages[1].speed_mps, std::sqrt(2.0 * 0.5 * 1.0), 1e-12);
}

TEST(PlanPassagesTest, StopsAtIdenticalWaypoints) {
  for (const Passage& passage : PlanPassages({At(1, 1), At(1, 1), At(1, 1)}, Limits())) {
    EXPECT_EQ(passage.speed_mps, 0.0);
    EXPECT_EQ(passage.radius_m, 0.0);
  }
}

}  // namespace
}  // namespace semantic_slam
