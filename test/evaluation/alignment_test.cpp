#include "semantic_slam/evaluation/alignment.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

using Positions = std::vector<Eigen::Vector3d>;

const Positions kSquare{{1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}, {-1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}};

// Coordinates of a few metres, a few roundings each.
constexpr double kRounding = 1e-12;

Rigid3d Pose(const Eigen::Vector3d& translation, const Eigen::Vector3d& rotation_vector) {
  Rigid3d T = Rigid3d::Identity();
  T.translation() = translation;
  T.linear() = ExpSo3(rotation_vector);
  return T;
}

// Matches of poses at `reference` and at `estimate`; no sensor turns.
std::vector<MatchedPose> Matches(const Positions& reference, const Positions& estimate) {
  std::vector<MatchedPose> matches(reference.size());
  for (std::size_t i = 0; i < reference.size(); ++i) {
    matches[i].T_reference_sensor.translation() = reference[i];
    matches[i].T_estimate_sensor.translation() = estimate[i];
  }
  return matches;
}

// Matches of the poses in the reference frame with the same ones, seen from the estimate's frame.
std::vector<MatchedPose> SeenFrom(const Rigid3d& T_reference_estimate,
                                  const std::vector<Rigid3d>& T_reference_sensors) {
  std::vector<MatchedPose> matches;
  for (const Rigid3d& T_reference_sensor : T_reference_sensors) {
    matches.push_back(
        {Stamp{}, T_reference_sensor, T_reference_estimate.inverse() * T_reference_sensor});
  }
  return matches;
}

void ExpectNear(const Rigid3d& actual, const Rigid3d& expected, double tolerance) {
  EXPECT_LT((actual.matrix() - expected.matrix()).cwiseAbs().maxCoeff(), tolerance)
      << "actual\n"
      << actual.matrix() << "\nexpected\n"
      << expected.matrix();
}

TEST(AlignmentTest, FindsAPureTranslation) {
  const Eigen::Vector3d offset(3.0, -4.0, 12.0);
  Positions estimate = kSquare;
  for (Eigen::Vector3d& p : estimate) p -= offset;
  ExpectNear(AlignTrajectories(Matches(kSquare, estimate)), Pose(offset, Eigen::Vector3d::Zero()),
             kRounding);
}

TEST(AlignmentTest, FindsAKnownRotation) {
  // A quarter turn about z takes (x, y) to (-y, x).
  const Rigid3d T = Pose({0.5, 0.0, 2.0}, {0.0, 0.0, M_PI / 2});
  const Positions estimate{{1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 3.0}};
  const Positions reference{{0.5, 1.0, 2.0}, {-1.5, 0.0, 2.0}, {0.5, 0.0, 5.0}};
  std::vector<MatchedPose> matches = Matches(reference, estimate);
  for (MatchedPose& match : matches) match.T_reference_sensor.linear() = T.linear();
  ExpectNear(AlignTrajectories(matches), T, kRounding);
}

TEST(AlignmentTest, FindsAnyRigidMotion) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
  };
  for (int i = 0; i < 50; ++i) {
    const Rigid3d T_reference_estimate = Pose(10.0 * vector(), M_PI * vector());
    std::vector<Rigid3d> poses;
    for (int k = 0; k < 10; ++k) poses.push_back(Pose(3.0 * vector(), M_PI * vector()));
    ExpectNear(AlignTrajectories(SeenFrom(T_reference_estimate, poses)), T_reference_estimate,
               kRounding);
  }
}

TEST(AlignmentTest, DoesNotScale) {
  Positions twice = kSquare;
  for (Eigen::Vector3d& p : twice) p *= 2.0;
  ExpectNear(AlignTrajectories(Matches(kSquare, twice)), Rigid3d::Identity(), kRounding);
}

TEST(AlignmentTest, DoesNotMirror) {
  const Positions reference{{1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}};
  Positions mirrored = reference;
  for (Eigen::Vector3d& p : mirrored) p.x() = -p.x();
  EXPECT_NEAR(AlignTrajectories(Matches(reference, mirrored)).linear().determinant(), 1.0,
              kRounding);
}

TEST(AlignmentTest, ABadPoseCountsAsMuchAsAnyOther) {
  // The centre of a square is a metre too high: no torque, and a fifth of it is taken out.
  Positions reference = kSquare;
  reference.push_back(Eigen::Vector3d::Zero());
  Positions estimate = reference;
  estimate.back().z() = 1.0;
  ExpectNear(AlignTrajectories(Matches(reference, estimate)),
             Pose({0.0, 0.0, -0.2}, Eigen::Vector3d::Zero()), kRounding);
}

TEST(AlignmentTest, IsTheBestInTheSenseOfLeastSquares) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 0.05);
  const auto vector = [&] { return Eigen::Vector3d(noise(random), noise(random), noise(random)); };
  std::vector<MatchedPose> matches(20);
  for (MatchedPose& match : matches) {
    match.T_reference_sensor.translation() = 20.0 * vector();
    match.T_estimate_sensor.translation() = match.T_reference_sensor.translation() + vector();
  }
  const auto cost = [&](const Rigid3d& T) {
    double sum = 0.0;
    for (const MatchedPose& match : matches) {
      sum += (match.T_reference_sensor.translation() - T * match.T_estimate_sensor.translation())
                 .squaredNorm();
    }
    return sum;
  };
  const Rigid3d best = AlignTrajectories(matches);
  for (int i = 0; i < 100; ++i) EXPECT_LT(cost(best), cost(Pose(vector(), vector()) * best));
}

TEST(AlignmentTest, OrientationsDecideWhatAStraightPathLeavesOpen) {
  // Positions along x say nothing about the rotation around x.
  const Rigid3d T_reference_estimate = Pose({1.0, 2.0, 3.0}, {0.7, 0.0, 0.0});
  std::vector<Rigid3d> poses;
  for (int i = 0; i < 5; ++i) poses.push_back(Pose({0.1 * i, 0.0, 0.0}, {0.0, 0.3 * i, 0.0}));
  // Orientations weigh 1e-9, so that a rounding (1e-16) may grow to 1e-7.
  ExpectNear(AlignTrajectories(SeenFrom(T_reference_estimate, poses)), T_reference_estimate, 1e-6);
}

TEST(AlignmentTest, OrientationsDecideNothingElse) {
  std::vector<MatchedPose> matches = Matches(kSquare, kSquare);
  for (MatchedPose& match : matches) match.T_estimate_sensor.linear() = ExpSo3({0.2, -0.1, 0.3});
  // They weigh 1e-9 of the positions: less than a nanometre at a metre from the centre.
  ExpectNear(AlignTrajectories(matches), Rigid3d::Identity(), 1e-9);
}

TEST(AlignmentTest, TurnsASensorThatNeverMoved) {
  const Rigid3d T_reference_estimate = Pose({1.0, 2.0, 3.0}, {0.4, -0.5, 0.6});
  const Rigid3d pose = Pose({0.5, 0.5, 0.5}, {0.1, 0.0, 0.0});
  // Positions cancel up to rounding (1e-32 m^2), far below the floor of the weight (1e-12 m^2).
  ExpectNear(AlignTrajectories(SeenFrom(T_reference_estimate, {pose, pose, pose})),
             T_reference_estimate, kRounding);
  ExpectNear(AlignTrajectories(SeenFrom(T_reference_estimate, {pose})), T_reference_estimate,
             kRounding);
}

}  // namespace
}  // namespace semantic_slam
