#include "semantic_slam/control/rotor_mixer.h"

#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kRounding = 1e-9;  // of sums of a few numbers near 1

BodyWrench Wrench(double thrust_n, double x, double y, double z) {
  return {thrust_n, Eigen::Vector3d(x, y, z)};
}

BodyWrench Mixed(const BodyWrench& wrench) {
  const RotorMixer mixer;
  return mixer.WrenchOf(mixer.RotorSpeeds(wrench));
}

TEST(RotorMixerTest, EqualSpeedsGiveThrustAlone) {
  const QuadrotorParameters parameters;
  const BodyWrench wrench =
      RotorMixer(parameters)
          .WrenchOf(Eigen::Vector4d::Constant(parameters.hover_rotor_speed_radps()));
  EXPECT_NEAR(wrench.thrust_n, 0.816 * 9.81, kRounding);
  EXPECT_LT(wrench.torque_nm.norm(), kRounding);
}

TEST(RotorMixerTest, EachRotorTurnsTheBodyAsItSits) {
  const RotorMixer mixer;
  const auto torque = [&mixer](int rotor) {
    return mixer.WrenchOf(100.0 * Eigen::Vector4d::Unit(rotor)).torque_nm;
  };
  // 100 rad/s are 0.0854858 N, on an arm of 0.17 m.
  const double lever = 0.0854858 * 0.17, drag = 0.0854858 * 0.016;
  EXPECT_TRUE(torque(0).isApprox(Eigen::Vector3d(0, -lever, drag)));   // front: nose up
  EXPECT_TRUE(torque(1).isApprox(Eigen::Vector3d(lever, 0, -drag)));   // left: left side up
  EXPECT_TRUE(torque(2).isApprox(Eigen::Vector3d(0, lever, drag)));    // back: nose down
  EXPECT_TRUE(torque(3).isApprox(Eigen::Vector3d(-lever, 0, -drag)));  // right: left side down
}

TEST(RotorMixerTest, GivesWhatTheRotorsCan) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const BodyWrench wanted = Wrench(12.0 + 2.0 * share(random), 0.2 * share(random),
                                     0.2 * share(random), 0.05 * share(random));
    const BodyWrench mixed = Mixed(wanted);
    EXPECT_NEAR(mixed.thrust_n, wanted.thrust_n, kRounding);
    EXPECT_LT((mixed.torque_nm - wanted.torque_nm).norm(), kRounding);
  }
}

TEST(RotorMixerTest, GivesUpYawFirst) {
  const BodyWrench mixed = Mixed(Wrench(8.0, 0.3, -0.3, 10.0));
  EXPECT_NEAR(mixed.thrust_n, 8.0, kRounding);
  EXPECT_NEAR(mixed.torque_nm.x(), 0.3, kRounding);
  EXPECT_NEAR(mixed.torque_nm.y(), -0.3, kRounding);
  EXPECT_GT(mixed.torque_nm.z(), 0.01);
  EXPECT_LT(mixed.torque_nm.z(), 10.0);
}

TEST(RotorMixerTest, GivesUpThrustNext) {
  const BodyWrench too_strong = Mixed(Wrench(24.0, 0.5, 0.0, 0.0));
  EXPECT_NEAR(too_strong.torque_nm.x(), 0.5, kRounding);
  EXPECT_LT(too_strong.thrust_n, 24.0);
  const BodyWrench too_weak = Mixed(Wrench(0.0, 0.5, 0.0, 0.0));
  EXPECT_NEAR(too_weak.torque_nm.x(), 0.5, kRounding);
  EXPECT_GT(too_weak.thrust_n, 0.0);
}

TEST(RotorMixerTest, ShrinksTorquesAboutXAndYInProportion) {
  const BodyWrench mixed = Mixed(Wrench(8.0, 9.0, 3.0, 0.0));
  // One rotor at rest and the one across at its most, 6.0 N: 1.02 Nm.
  EXPECT_NEAR(mixed.torque_nm.x(), QuadrotorParameters().max_rotor_thrust_n() * 0.17, kRounding);
  EXPECT_NEAR(mixed.torque_nm.y(), mixed.torque_nm.x() / 3.0, kRounding);
}

TEST(RotorMixerTest, SpeedsStayWithinTheirLimits) {
  const RotorMixer mixer;
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.0, 20.0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector4d speeds =
        mixer.RotorSpeeds(Wrench(normal(random), normal(random), normal(random), normal(random)));
    EXPECT_GE(speeds.minCoeff(), 0.0);
    EXPECT_LE(speeds.maxCoeff(), 838.0 + kRounding);
  }
}

TEST(RotorMixerTest, RefusesParametersOutOfRange) {
  QuadrotorParameters parameters;
  parameters.arm_length_m = 0.0;
  EXPECT_THROW(RotorMixer{parameters}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
