#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/worlds/world.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr double kPi = 3.14159265358979;

// 4 m along x, 3 m along y, 5 m back, at 1 m/s; turns take as long as they are [rad].
Walk Triangle() {
  return Walk({{0, 0}, {4, 0}, {4, 3}}, 1.0, 1.0);
}

double HeadingAt(const Walk& walk, double time_s) {
  const Eigen::Vector3d ahead = walk.Pose(time_s).linear().col(0);
  return std::atan2(ahead.y(), ahead.x());
}

TEST(WalkTest, GoesStraightAndTurnsOnTheSpot) {
  const Walk walk = Triangle();
  EXPECT_TRUE(walk.Pose(1.0).translation().isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_NEAR(HeadingAt(walk, 1.0), 0.0, 1e-12);
  EXPECT_TRUE(walk.Pose(4.5).translation().isApprox(Eigen::Vector3d(4, 0, 0)));
  EXPECT_NEAR(HeadingAt(walk, 4.5), 0.5, 1e-9);
  const double second_leg_s = 4.0 + kPi / 2;
  EXPECT_TRUE(walk.Pose(second_leg_s + 2.0).translation().isApprox(Eigen::Vector3d(4, 2, 0), 1e-9));
  EXPECT_NEAR(HeadingAt(walk, second_leg_s + 2.0), kPi / 2, 1e-9);
}

TEST(WalkTest, RepeatsForEverInBothDirections) {
  const Walk walk = Triangle();
  const double round_s = 12.0 + 2 * kPi;
  EXPECT_NEAR(walk.RoundDuration(), round_s, 1e-9);
  for (const double time_s : {0.5, 4.4, 7.0, 11.0}) {
    for (const int rounds : {-2, 1, 50}) {
      EXPECT_TRUE(walk.Pose(time_s).isApprox(walk.Pose(time_s + rounds * round_s), 1e-6));
      EXPECT_NEAR(walk.Distance(time_s + rounds * round_s), walk.Distance(time_s) + 12.0 * rounds,
                  1e-6);
    }
  }
}

TEST(WalkTest, PoseIsContinuous) {
  const Walk walk = Triangle();
  for (double time_s = -1.0; time_s < 40.0; time_s += 0.01) {
    const Rigid3d step = walk.Pose(time_s).inverse() * walk.Pose(time_s + 0.01);
    ASSERT_LT(step.translation().norm(), 0.01 + 1e-9) << time_s;
    ASSERT_LT(RotationAngle(step.linear()), 0.01 + 1e-6) << time_s;
  }
}

TEST(WalkTest, DistanceStandsStillWhileTurning) {
  const Walk walk = Triangle();
  EXPECT_NEAR(walk.Distance(3.0), 3.0, 1e-12);
  EXPECT_NEAR(walk.Distance(4.2), 4.0, 1e-12);
  EXPECT_NEAR(walk.Distance(5.0), 4.0, 1e-12);
}

TEST(WalkTest, ToAndFroTurnsAboutAtEachEnd) {
  const Walk walk({{0, 0}, {2, 0}}, 0.5, kPi);
  EXPECT_NEAR(walk.Pose(7.0).translation().x(), 1.0, 1e-9);  // 4 s there, 1 s about, 2 s back
  EXPECT_NEAR(std::abs(HeadingAt(walk, 7.0)), kPi, 1e-9);
}

TEST(WalkTest, RefusesWhatIsNoWalk) {
  EXPECT_EQ(MessageOf<ConfigError>([] {
              Walk({{1, 1}}, 1.0);
            }),
            "a walk needs at least two corners");
  EXPECT_EQ(MessageOf<ConfigError>([] {
              Walk({{1, 1}, {2, 1}, {2, 1}}, 1.0);
            }),
            "a walk's successive corners coincide");
  EXPECT_EQ(MessageOf<ConfigError>([] {
              Walk({{1, 1}, {2, 1}, {1, 1}}, 1.0);
            }),
            "a walk's successive corners coincide");
  EXPECT_EQ(MessageOf<ConfigError>([] {
              Walk({{1, 1}, {2, 1}}, 0.0);
            }),
            "a walk's speed and turn rate must be positive");
  EXPECT_EQ(MessageOf<ConfigError>([] {
              Walk({{1, 1}, {2, 1}}, 1.0, -1.0);
            }),
            "a walk's speed and turn rate must be positive");
}

}  // namespace
}  // namespace semantic_slam
