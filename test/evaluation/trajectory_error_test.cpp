#include "semantic_slam/evaluation/trajectory_error.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;

// A few roundings of numbers around one; an angle loses half the digits of a matrix that is nearly
// the identity.
constexpr double kRounding = 1e-12;
constexpr double kAngleRounding_deg = 1e-6;

Rigid3d Pose(const Eigen::Vector3d& translation,
             const Eigen::Vector3d& rotation_vector = Eigen::Vector3d::Zero()) {
  Rigid3d T = Rigid3d::Identity();
  T.translation() = translation;
  T.linear() = ExpSo3(rotation_vector);
  return T;
}

// A perfect estimate of a sensor at (0, 0, 0), (step_m, 0, 0), ... every `step_s`.
std::vector<MatchedPose> AlongX(int poses, double step_m, double step_s) {
  std::vector<MatchedPose> matches;
  for (int i = 0; i < poses; ++i) {
    const Rigid3d T = Pose({step_m * i, 0.0, 0.0});
    matches.push_back({Stamp::FromSeconds(step_s * i), T, T});
  }
  return matches;
}

// Perfect estimates at these seconds.
std::vector<MatchedPose> AtSeconds(const std::vector<double>& stamps_s) {
  std::vector<MatchedPose> matches;
  for (const double stamp_s : stamps_s) {
    const Rigid3d T = Pose({stamp_s, 0.0, 0.0});
    matches.push_back({Stamp::FromSeconds(stamp_s), T, T});
  }
  return matches;
}

void ExpectAllNear(const std::vector<double>& values, double expected, double tolerance) {
  for (const double value : values) EXPECT_NEAR(value, expected, tolerance);
}

TEST(TrajectoryErrorTest, Summarises) {
  const ErrorStatistics statistics = Summarise({7.0, 1.0});
  EXPECT_DOUBLE_EQ(statistics.rmse, 5.0);
  EXPECT_DOUBLE_EQ(statistics.mean, 4.0);
  EXPECT_DOUBLE_EQ(statistics.median, 4.0);
  EXPECT_DOUBLE_EQ(statistics.max, 7.0);
  EXPECT_DOUBLE_EQ(Summarise({5.0, 1.0, 2.0}).median, 2.0);
  EXPECT_DOUBLE_EQ(Summarise({8.0, 1.0, 4.0, 2.0}).median, 3.0);
}

TEST(TrajectoryErrorTest, SummarisesNothingAsZero) {
  const ErrorStatistics statistics = Summarise({});
  EXPECT_EQ(statistics.rmse, 0.0);
  EXPECT_EQ(statistics.mean, 0.0);
  EXPECT_EQ(statistics.median, 0.0);
  EXPECT_EQ(statistics.max, 0.0);
}

TEST(TrajectoryErrorTest, AbsoluteErrorsAreThoseOfEachPoseAndOfItsTwoViews) {
  MatchedPose match;
  match.T_reference_sensor = Pose({1.0, 1.0, 1.0}, {0.0, 0.0, 0.5});
  match.T_estimate_sensor = Pose({4.0, 5.0, 13.0}, {0.0, 0.0, 0.5 - 30.0 * kRadPerDeg});
  const AbsoluteErrors errors = ComputeAbsoluteErrors({match, {}}, Rigid3d::Identity());
  ASSERT_EQ(errors.position_m.size(), 2u);
  EXPECT_NEAR(errors.position_m[0], 13.0, kRounding);  // of (3, 4, 12)
  EXPECT_NEAR(errors.deviation_xy_m[0], 5.0, kRounding);
  EXPECT_NEAR(errors.deviation_xz_m[0], std::sqrt(153.0), kRounding);
  EXPECT_NEAR(errors.rotation_deg[0], 30.0, kAngleRounding_deg);
  EXPECT_EQ(errors.position_m[1], 0.0);
  EXPECT_EQ(errors.rotation_deg[1], 0.0);
}

TEST(TrajectoryErrorTest, AbsoluteErrorsAreTakenAfterAlignment) {
  const Rigid3d T_reference_estimate = Pose({5.0, 6.0, 7.0}, {0.3, -0.2, 1.0});
  MatchedPose match;
  match.T_estimate_sensor = Pose({1.0, 2.0, 3.0}, {0.1, 0.2, 0.3});
  match.T_reference_sensor = T_reference_estimate * match.T_estimate_sensor;
  match.T_reference_sensor.translation().y() += 0.25;
  const AbsoluteErrors errors = ComputeAbsoluteErrors({match}, T_reference_estimate);
  EXPECT_NEAR(errors.position_m[0], 0.25, kRounding);
  EXPECT_NEAR(errors.deviation_xy_m[0], 0.25, kRounding);
  EXPECT_NEAR(errors.deviation_xz_m[0], 0.0, kRounding);
  EXPECT_NEAR(errors.rotation_deg[0], 0.0, kAngleRounding_deg);
}

TEST(TrajectoryErrorTest, OverTimeIsTheDriftInAnInterval) {
  auto matches = AlongX(31, 0.1, 0.1);  // 1 m/s for 3 s
  for (MatchedPose& match : matches) match.T_estimate_sensor.translation() *= 1.05;
  const RelativeErrors errors = RelativeErrorsOverTime(matches, 1.0);
  EXPECT_EQ(errors.pairs(), 21u);  // from 0 s to 1 s, ..., from 2 s to 3 s
  ExpectAllNear(errors.translation_m, 0.05, kRounding);
  ExpectAllNear(errors.rotation_deg, 0.0, kAngleRounding_deg);
  ExpectAllNear(errors.path_m, 1.0, kRounding);
  ExpectAllNear(RelativeErrorsOverTime(matches, 2.0).translation_m, 0.1, kRounding);
}

TEST(TrajectoryErrorTest, OverTimeIsTheTurnInAnInterval) {
  auto matches = AlongX(31, 0.1, 0.1);
  for (MatchedPose& match : matches) {  // rolls about its own path by 4 degrees a second
    const double angle_rad = 4.0 * kRadPerDeg * match.stamp.seconds();
    match.T_estimate_sensor.linear() = ExpSo3({angle_rad, 0.0, 0.0});
  }
  const RelativeErrors errors = RelativeErrorsOverTime(matches, 1.0);
  EXPECT_EQ(errors.pairs(), 21u);
  ExpectAllNear(errors.rotation_deg, 4.0, kAngleRounding_deg);
  ExpectAllNear(errors.translation_m, 0.0, kRounding);
}

TEST(TrajectoryErrorTest, RelativeErrorsDoNotDependOnTheOrigins) {
  auto matches = AlongX(31, 0.1, 0.1);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const double s = 0.1 * static_cast<double>(i);
    matches[i].T_reference_sensor = Pose({s, s * s, -s}, {0.2 * s, s, 0.0});
    matches[i].T_estimate_sensor =
        Pose({7.0, -8.0, 9.0}, {1.0, 2.0, -1.0}) * matches[i].T_reference_sensor;
  }
  for (const RelativeErrors& errors :
       {RelativeErrorsOverTime(matches, 1.0), RelativeErrorsOverPath(matches, 1.0)}) {
    EXPECT_GT(errors.pairs(), 0u);
    ExpectAllNear(errors.translation_m, 0.0, kRounding);
    ExpectAllNear(errors.rotation_deg, 0.0, kAngleRounding_deg);
  }
}

TEST(TrajectoryErrorTest, ABadPoseSpoilsThePairsItIsIn) {
  auto matches = AlongX(31, 0.1, 0.1);
  matches[15].T_estimate_sensor.translation().y() += 0.5;
  const RelativeErrors errors = RelativeErrorsOverTime(matches, 1.0);
  for (std::size_t start = 0; start < errors.pairs(); ++start) {
    const bool has_it = start == 5 || start == 15;
    EXPECT_NEAR(errors.translation_m[start], has_it ? 0.5 : 0.0, kRounding) << start;
  }
}

TEST(TrajectoryErrorTest, OverTimeTakesTheNearestPoseAndTheEarlierOfTwo) {
  // path_m tells which pose was taken. All stamps are exact in binary.
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0, 0.9375, 1.03125}), 1.0).path_m,
            std::vector<double>{1.03125});
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0, 0.96875, 1.0625}), 1.0).path_m,
            std::vector<double>{0.96875});
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0, 0.9375, 1.0625}), 1.0).path_m,
            std::vector<double>{0.9375});
}

TEST(TrajectoryErrorTest, OverTimeLeavesOutAPoseWithoutAPartner) {
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0, 1.09}), 1.0).pairs(), 1u);
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0, 0.91}), 1.0).pairs(), 1u);
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0, 1.11}), 1.0).pairs(), 0u);
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0, 0.89}), 1.0).pairs(), 0u);
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0}), 1.0).pairs(), 0u);
  EXPECT_EQ(RelativeErrorsOverTime({}, 1.0).pairs(), 0u);
  EXPECT_EQ(RelativeErrorsOverTime(AtSeconds({0.0}), 0.01).pairs(), 0u);  // never with itself
}

TEST(TrajectoryErrorTest, OverPathIsTheDriftOfASegment) {
  auto matches = AlongX(31, 0.1, 1.0);  // 3 m
  for (MatchedPose& match : matches) match.T_estimate_sensor.translation() *= 1.02;
  const RelativeErrors errors = RelativeErrorsOverPath(matches, 1.0);
  EXPECT_EQ(errors.pairs(), 21u);  // ten steps each, although their sum may round below a metre
  ExpectAllNear(errors.path_m, 1.0, kRounding);
  ExpectAllNear(errors.translation_m, 0.02, kRounding);
  EXPECT_NEAR(MeanTranslationPercent(errors), 2.0, 1e2 * kRounding);
  EXPECT_NEAR(MeanRotationDegPerMetre(errors), 0.0, kAngleRounding_deg);
}

TEST(TrajectoryErrorTest, OverPathIsTheTurnOfASegment) {
  auto matches = AlongX(31, 0.1, 1.0);
  for (MatchedPose& match : matches) {  // rolls about its own path by 3 degrees a metre
    const double angle_rad = 3.0 * kRadPerDeg * match.T_reference_sensor.translation().x();
    match.T_estimate_sensor.linear() = ExpSo3({angle_rad, 0.0, 0.0});
  }
  const RelativeErrors errors = RelativeErrorsOverPath(matches, 0.5);
  EXPECT_EQ(errors.pairs(), 26u);
  ExpectAllNear(errors.rotation_deg, 1.5, kAngleRounding_deg);
  EXPECT_NEAR(MeanRotationDegPerMetre(errors), 3.0, kAngleRounding_deg);
  EXPECT_NEAR(MeanTranslationPercent(errors), 0.0, 1e2 * kRounding);
}

TEST(TrajectoryErrorTest, ASegmentEndsAtTheFirstPoseThatIsFarEnough) {
  auto matches = AlongX(4, 0.75, 1.0);  // the path passes 1 m on the way to 1.5 m
  matches[2].T_estimate_sensor.translation().y() = 0.3;
  const RelativeErrors errors = RelativeErrorsOverPath(matches, 1.0);
  EXPECT_EQ(errors.path_m, (std::vector<double>{1.5, 1.5}));
  EXPECT_NEAR(errors.translation_m[0], 0.3, kRounding);
  EXPECT_NEAR(errors.translation_m[1], 0.0, kRounding);
  EXPECT_NEAR(MeanTranslationPercent(errors), 10.0, 1e2 * kRounding);  // of 0.3 / 1.5 and of 0
}

TEST(TrajectoryErrorTest, SegmentsFollowTheReferencesPath) {
  auto matches = AlongX(5, 0.0, 1.0);  // around a square with sides of a metre
  matches[1].T_reference_sensor.translation() << 1.0, 0.0, 0.0;
  matches[2].T_reference_sensor.translation() << 1.0, 1.0, 0.0;
  matches[3].T_reference_sensor.translation() << 0.0, 1.0, 0.0;
  EXPECT_DOUBLE_EQ(ReferencePathLength(matches), 4.0);
  const RelativeErrors errors = RelativeErrorsOverPath(matches, 3.0);
  EXPECT_EQ(errors.path_m, (std::vector<double>{3.0, 3.0}));
  EXPECT_NEAR(errors.translation_m[0], 1.0, kRounding);  // (0, 1) instead of (0, 0)
}

TEST(TrajectoryErrorTest, WithoutASegmentThereIsNoError) {
  const RelativeErrors errors = RelativeErrorsOverPath(AlongX(31, 0.0, 1.0), 1.0);
  EXPECT_EQ(errors.pairs(), 0u);
  EXPECT_EQ(MeanTranslationPercent(errors), 0.0);
  EXPECT_EQ(MeanRotationDegPerMetre(errors), 0.0);
  EXPECT_EQ(RelativeErrorsOverPath(AlongX(10, 0.1, 1.0), 1.0).pairs(), 0u);
  EXPECT_EQ(RelativeErrorsOverPath({}, 1.0).pairs(), 0u);
  EXPECT_EQ(ReferencePathLength({}), 0.0);
}

}  // namespace
}  // namespace semantic_slam
