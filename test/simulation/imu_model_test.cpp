#include "semantic_slam/simulation/imu_model.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/control/quadrotor_parameters.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr double kPeriodS = 1.0 / 200.0;
ImuOptions Perfect() {
  ImuOptions options;
  options.noise = false;
  return options;
}

std::vector<ImuReading> ReadingsAtRest(const ImuOptions& options, int count) {
  ImuModel imu(options, Rigid3d::Identity());
  const QuadrotorState rest;
  std::vector<ImuReading> readings;
  for (int i = 0; i < count; ++i) readings.push_back(imu.Measure(Stamp{i}, rest, rest, kPeriodS));
  return readings;
}

TEST(ImuModelTest, FeelsGravityUpwardsAtRest) {
  const ImuReading reading = ReadingsAtRest(Perfect(), 1).front();
  EXPECT_EQ(reading.specific_force_mps2, Eigen::Vector3d(0.0, 0.0, kGravityMps2));
  EXPECT_EQ(reading.angular_velocity_radps, Eigen::Vector3d::Zero());
}

TEST(ImuModelTest, FeelsNothingInFreeFall) {
  ImuModel imu(Perfect(), Rigid3d::Identity());
  QuadrotorState before, now;
  now.velocity_world_mps.z() = -kGravityMps2 * kPeriodS;
  const ImuReading reading = imu.Measure(Stamp{1}, before, now, kPeriodS);
  EXPECT_LT(reading.specific_force_mps2.norm(), 1e-12);
}

TEST(ImuModelTest, ReadsInItsOwnAxes) {
  Rigid3d T_base_imu = Rigid3d::Identity();  // an optical frame: z ahead, x right, y down
  T_base_imu.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  ImuModel imu(Perfect(), T_base_imu);
  QuadrotorState before, now;
  now.velocity_world_mps.x() = 2.0 * kPeriodS;
  now.angular_velocity_base_radps.z() = before.angular_velocity_base_radps.z() = 0.5;
  const ImuReading reading = imu.Measure(Stamp{1}, before, now, kPeriodS);
  EXPECT_TRUE(reading.specific_force_mps2.isApprox(Eigen::Vector3d(0, -kGravityMps2, 2.0), 1e-12));
  EXPECT_TRUE(reading.angular_velocity_radps.isApprox(Eigen::Vector3d(0, -0.5, 0), 1e-12));
}

TEST(ImuModelTest, TurnsTheForceIntoATiltedBase) {
  ImuModel imu(Perfect(), Rigid3d::Identity());
  QuadrotorState tilted;
  tilted.T_world_base.linear() = ExpSo3({0.0, 0.3, 0.0});
  const ImuReading reading = imu.Measure(Stamp{1}, tilted, tilted, kPeriodS);
  EXPECT_NEAR(reading.specific_force_mps2.x(), -kGravityMps2 * std::sin(0.3), 1e-12);
  EXPECT_NEAR(reading.specific_force_mps2.z(), kGravityMps2 * std::cos(0.3), 1e-12);
}

// On a circle of radius r it is pulled inwards with r w^2.
TEST(ImuModelTest, FeelsThatItGoesRoundTheCentreOfMass) {
  Rigid3d T_base_imu = Rigid3d::Identity();
  T_base_imu.translation().x() = 0.2;
  ImuModel imu(Perfect(), T_base_imu);
  constexpr double kRate = 3.0, kStepS = 1e-4;
  QuadrotorState before, now;
  before.angular_velocity_base_radps.z() = now.angular_velocity_base_radps.z() = kRate;
  now.T_world_base.linear() = ExpSo3({0.0, 0.0, kRate * kStepS});
  const ImuReading reading = imu.Measure(Stamp{1}, before, now, kStepS);
  // 1e-3: the mean over a step is not quite the value at its end.
  EXPECT_NEAR(reading.specific_force_mps2.x(), -0.2 * kRate * kRate, 1e-3);
}

TEST(ImuModelTest, WhiteNoiseHasTheStatedDensity) {
  ImuOptions options;
  options.gyroscope_bias_radps = options.accelerometer_bias_mps2 = 0.0;
  options.gyroscope_walk_radps_per_sqrt_s = options.accelerometer_walk_mps2_per_sqrt_s = 0.0;
  constexpr int kCount = 20000;
  double gyroscope = 0.0, accelerometer = 0.0;
  for (const ImuReading& reading : ReadingsAtRest(options, kCount)) {
    gyroscope += reading.angular_velocity_radps.squaredNorm() / (3 * kCount);
    accelerometer += std::pow(reading.specific_force_mps2.x(), 2) / kCount;
  }
  // Density times the square root of the rate; the tolerance is four standard deviations.
  const double root_rate = std::sqrt(1.0 / kPeriodS), tolerance = 4.0 * std::sqrt(0.5 / kCount);
  EXPECT_NEAR(std::sqrt(gyroscope) / (options.gyroscope_noise_radps_per_sqrt_hz * root_rate), 1.0,
              tolerance);
  EXPECT_NEAR(std::sqrt(accelerometer) / (options.accelerometer_noise_mps2_per_sqrt_hz * root_rate),
              1.0, tolerance);
}

TEST(ImuModelTest, TheBiasWalksAwayWithTheRootOfTime) {
  ImuOptions options;
  options.gyroscope_noise_radps_per_sqrt_hz = options.gyroscope_bias_radps = 0.0;
  options.gyroscope_walk_radps_per_sqrt_s = 0.01;
  constexpr int kRuns = 300, kReadings = 800;  // 4 s, so that the bias is off by 0.02
  double squares = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    options.seed = run;
    squares += ReadingsAtRest(options, kReadings).back().angular_velocity_radps.squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(squares / (3 * kRuns)), 0.02, 0.02 * 4.0 * std::sqrt(0.5 / (3 * kRuns)));
}

TEST(ImuModelTest, SameSeedSameReadings) {
  ImuOptions options;
  const auto once = ReadingsAtRest(options, 50), again = ReadingsAtRest(options, 50);
  options.seed = 2;
  const auto other = ReadingsAtRest(options, 50);
  EXPECT_EQ(once.back().specific_force_mps2, again.back().specific_force_mps2);
  EXPECT_NE(once.back().specific_force_mps2, other.back().specific_force_mps2);
}

TEST(ImuModelTest, RefusesOptionsOutOfRange) {
  ImuOptions options;
  options.accelerometer_bias_mps2 = -1.0;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { ImuModel(options, Rigid3d::Identity()); }),
                    {"accelerometer_bias_mps2 = -1"});
}

}  // namespace
}  // namespace semantic_slam
