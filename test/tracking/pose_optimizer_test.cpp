#include "semantic_slam/tracking/pose_optimizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = M_PI / 180.0;

// A camera somewhere in the map that sees points between 1 and 5 m before it.
class PoseOptimizerTest : public testing::Test {
 protected:
  // Every point seen exactly where it is.
  std::vector<PoseObservation> Observe(int points) {
    std::uniform_real_distribution<double> u_px(0.0, 639.0), v_px(0.0, 479.0), depth_m(1.0, 5.0);
    std::vector<PoseObservation> observations;
    for (int i = 0; i < points; ++i) {
      const Eigen::Vector2d pixel(u_px(random_), v_px(random_));
      const double z_m = depth_m(random_);
      observations.push_back(
          {T_map_camera_ * camera_.Unproject(pixel.x(), pixel.y(), z_m), pixel, z_m, 1.0});
    }
    return observations;
  }

  // The noise that the optimizer is told of, times `share`.
  void AddNoise(double share, std::vector<PoseObservation>& observations) {
    std::normal_distribution<double> normal;
    for (PoseObservation& o : observations) {
      o.pixel += share * noise_.PixelSigma(o.pyramid_scale) *
                 Eigen::Vector2d(normal(random_), normal(random_));
      o.depth_m = 1.0 / (1.0 / o.depth_m + share * noise_.InverseDepthSigma() * normal(random_));
    }
  }

  PoseEstimate Optimize(const std::vector<PoseObservation>& observations) const {
    // As bad as a prediction from the last image gets.
    return OptimizePose(observations, Nudged(T_map_camera_, 0.10, 5.0 * kDegree, 1), camera_,
                        noise_);
  }

  void ExpectNear(const Rigid3d& T_map_camera, double distance_m, double angle_rad) const {
    EXPECT_LT(DistanceBetween(T_map_camera, T_map_camera_), distance_m);
    EXPECT_LT(AngleBetween(T_map_camera, T_map_camera_), angle_rad);
  }

  std::mt19937 random_{1};
  const CameraModel camera_{{640, 480, 525.0, 525.0, 319.5, 239.5, {}}};
  const ObservationNoise noise_;
  const Rigid3d T_map_camera_ = Nudged(Rigid3d::Identity(), 3.0, 2.5, 7);
};

TEST_F(PoseOptimizerTest, FindsTheExactPoseFromExactObservations) {
  const PoseEstimate estimate = Optimize(Observe(50));
  ExpectNear(estimate.T_map_camera, 1e-6, 1e-6);  // Gauss-Newton is quadratic without residuals
  EXPECT_EQ(estimate.inliers, 50);
}

TEST_F(PoseOptimizerTest, PixelsWithoutDepthAreEnough) {
  auto observations = Observe(50);
  for (PoseObservation& o : observations) o.depth_m = kNan;
  ExpectNear(Optimize(observations).T_map_camera, 1e-6, 1e-6);
}

TEST_F(PoseOptimizerTest, StandsNoiseAndThirtyPercentOutliers) {
  auto observations = Observe(300);
  AddNoise(1.0, observations);
  std::uniform_real_distribution<double> u_px(0.0, 639.0), v_px(0.0, 479.0);
  std::vector<bool> is_wrong(observations.size());
  for (std::size_t i = 0; i < observations.size(); ++i) {
    is_wrong[i] = i % 10 < 3;
    if (is_wrong[i]) observations[i].pixel = Eigen::Vector2d(u_px(random_), v_px(random_));
  }
  const PoseEstimate estimate = Optimize(observations);
  // 1 px at 3 m is 6 mm, and 210 good points make that sqrt(210) = 14 times better: 0.4 mm.
  // Rotation and translation share the information, hence the factor of ten.
  ExpectNear(estimate.T_map_camera, 0.004, 0.1 * kDegree);
  int wrong_kept = 0, good_lost = 0;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    wrong_kept += is_wrong[i] && estimate.is_inlier[i];
    good_lost += !is_wrong[i] && !estimate.is_inlier[i];
  }
  EXPECT_LE(wrong_kept, 2);         // by chance one may lie near its place
  EXPECT_LE(good_lost, 0.1 * 210);  // 5 % of good ones exceed the limit by definition
  EXPECT_EQ(estimate.inliers,
            std::count(estimate.is_inlier.begin(), estimate.is_inlier.end(), true));
}

TEST_F(PoseOptimizerTest, WrongDepthAtEdgesDoesNoHarmAndDoesNotCostTheFeature) {
  auto observations = Observe(100);
  for (std::size_t i = 0; i < observations.size(); i += 3) observations[i].depth_m += 1.0;
  const PoseEstimate estimate = Optimize(observations);
  // All the wrong depths pull to the same side until they are set aside. The last round then ends
  // when steps no longer pay, not at the last digit.
  ExpectNear(estimate.T_map_camera, 1e-4, 1e-4);
  EXPECT_EQ(estimate.inliers, 100);
}

TEST_F(PoseOptimizerTest, DepthTellsHowFarAwayADistantGroupOfPointsIs) {
  // Points in the middle of the image at one distance: the pixels hardly tell 3 m from 2.9 m.
  auto observations = Observe(100);
  for (PoseObservation& o : observations) {
    o.pixel = Eigen::Vector2d(319.5, 239.5) + 0.1 * (o.pixel - Eigen::Vector2d(319.5, 239.5));
    o.depth_m = 3.0;
    o.p_map = T_map_camera_ * camera_.Unproject(o.pixel.x(), o.pixel.y(), o.depth_m);
  }
  AddNoise(1.0, observations);
  const auto error_along_axis = [&](const PoseEstimate& estimate) {
    return std::abs((T_map_camera_.inverse() * estimate.T_map_camera).translation().z());
  };
  const double with_depth = error_along_axis(Optimize(observations));
  // sigma_z = 0.02 * 3^2 = 0.18 m each, 0.018 m for a hundred of them.
  EXPECT_LT(with_depth, 3.0 * 0.018);
}

TEST_F(PoseOptimizerTest, NoSmallStepMakesTheResultBetter) {
  auto observations = Observe(100);
  AddNoise(0.5, observations);  // so little that everything is an inlier
  for (std::size_t i = 0; i < observations.size(); ++i) {
    observations[i].pyramid_scale = i % 2 == 0 ? 1.0 : 2.0;
  }
  const PoseEstimate estimate = Optimize(observations);
  ASSERT_EQ(estimate.inliers, 100);
  // The sum that OptimizePose() promises to minimise, written down independently of it.
  const auto cost = [&](const Rigid3d& T_map_camera) {
    double sum = 0.0;
    for (const PoseObservation& o : observations) {
      const Eigen::Vector3d p = T_map_camera.inverse() * o.p_map;
      const double u = 525.0 * p.x() / p.z() + 319.5 - o.pixel.x();
      const double v = 525.0 * p.y() / p.z() + 239.5 - o.pixel.y();
      const double depth = (1.0 / p.z() - 1.0 / o.depth_m) / noise_.depth_sigma_at_1m_m;
      sum += (u * u + v * v) / (o.pyramid_scale * o.pyramid_scale) + depth * depth;
    }
    return sum;
  };
  const double least = cost(estimate.T_map_camera);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double step : {-2e-4, 2e-4}) {  // a quarter of a standard deviation
      Rigid3d moved = estimate.T_map_camera, turned = estimate.T_map_camera;
      moved.translation()[axis] += step;
      turned.linear() = turned.linear() * ExpSo3(step * Eigen::Vector3d::Unit(axis));
      EXPECT_GT(cost(moved), least) << axis << " " << step;
      EXPECT_GT(cost(turned), least) << axis << " " << step;
    }
  }
}

TEST_F(PoseOptimizerTest, CoarseFeaturesMayBeFartherOff) {
  auto observations = Observe(100);
  observations[0].pixel.x() += 4.0;  // chi2 = 16 on level 0, 4 where a pixel is two
  observations[1].pixel.x() += 4.0;
  observations[1].pyramid_scale = 2.0;
  const PoseEstimate estimate = Optimize(observations);
  EXPECT_FALSE(estimate.is_inlier[0]);
  EXPECT_TRUE(estimate.is_inlier[1]);
}

TEST_F(PoseOptimizerTest, PointsBehindTheCameraAreOutliers) {
  auto observations = Observe(50);
  for (int i = 0; i < 10; ++i) {
    observations[i].p_map = T_map_camera_ * Eigen::Vector3d(0.1 * i, 0.0, -2.0);
  }
  const PoseEstimate estimate = Optimize(observations);
  ExpectNear(estimate.T_map_camera, 1e-5, 1e-5);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(estimate.is_inlier[i]);
}

TEST_F(PoseOptimizerTest, WithoutObservationsThePoseStays) {
  const PoseEstimate estimate = OptimizePose({}, T_map_camera_, camera_, noise_);
  ExpectNear(estimate.T_map_camera, 1e-12, 1e-7);  // acos() near 1 is good to 1e-8 only
  EXPECT_EQ(estimate.inliers, 0);
  EXPECT_TRUE(estimate.is_inlier.empty());
}

TEST_F(PoseOptimizerTest, TooFewObservationsDoNotBreakIt) {
  for (const int points : {1, 2}) {
    const PoseEstimate estimate = Optimize(Observe(points));
    EXPECT_TRUE(IsFinite(estimate.T_map_camera)) << points;
    EXPECT_EQ(static_cast<int>(estimate.is_inlier.size()), points);
  }
}

// The same camera with a rolling shutter, in motion.
class RollingShutterTest : public PoseOptimizerTest {
 protected:
  static constexpr double kReadoutS = 0.03;

  // Points where each row of its own time shows them: what Observe() saw is moved.
  std::vector<PoseObservation> ObserveRolling(int points) {
    std::vector<PoseObservation> observations = Observe(points);
    for (PoseObservation& o : observations) {
      const Eigen::Vector3d p_row = camera_.Unproject(o.pixel.x(), o.pixel.y(), o.depth_m);
      o.row_fraction = camera_.RowFraction(o.pixel.y());
      o.p_map = T_map_camera_ * twist_.T_now_then(o.row_fraction * kReadoutS) * p_row;
    }
    return observations;
  }

  PoseEstimate OptimizeRolling(const std::vector<PoseObservation>& observations,
                               double readout_s) const {
    RollingShutter shutter{readout_s, twist_, 0.1};
    shutter.twist.angular_velocity_radps.x() += 0.1;  // as wrong as it is said to be
    return OptimizePose(observations, Nudged(T_map_camera_, 0.10, 5.0 * kDegree, 1), camera_, noise_,
                        shutter);
  }

  const CameraTwist twist_{{0.4, -0.2, 0.3}, {0.5, 1.2, -0.4}};
};

TEST_F(RollingShutterTest, FindsThePoseOfTheMiddleRow) {
  const auto observations = ObserveRolling(200);
  // First order in the motion: (30 ms / 2 x 1.4 rad/s)^2 / 2 is 0.2 mrad, 1 mm at 5 m.
  const PoseEstimate estimate = OptimizeRolling(observations, kReadoutS);
  ExpectNear(estimate.T_map_camera, 0.001, 0.0005);
  EXPECT_EQ(estimate.inliers, 200);
  EXPECT_LT((estimate.twist.angular_velocity_radps - twist_.angular_velocity_radps).norm(), 0.03);
}

TEST_F(RollingShutterTest, TakingTheShutterForGlobalCosts) {
  const PoseEstimate global = Optimize(ObserveRolling(200));
  EXPECT_GT(DistanceBetween(global.T_map_camera, T_map_camera_) +
                AngleBetween(global.T_map_camera, T_map_camera_),
            0.002);
}

TEST_F(RollingShutterTest, TheEvidencePointsToTheReadoutTime) {
  auto observations = ObserveRolling(400);
  AddNoise(0.5, observations);
  for (const double assumed_s : {0.01, kReadoutS, 0.05}) {
    const ReadoutEvidence evidence = OptimizeRolling(observations, assumed_s).readout;
    ASSERT_GT(evidence.information, 0.0);
    const double change_s = evidence.gradient / evidence.information;
    // The turn that the evidence is judged by is 10 % wrong, and so is the answer; noise adds 1 ms.
    EXPECT_NEAR(assumed_s + change_s, kReadoutS, 0.006) << assumed_s;
  }
}

TEST_F(RollingShutterTest, ACameraAtRestSaysNothing) {
  const RollingShutter shutter{kReadoutS, CameraTwist(), 0.1};
  const PoseEstimate estimate =
      OptimizePose(Observe(100), T_map_camera_, camera_, noise_, shutter);
  ExpectNear(estimate.T_map_camera, 1e-6, 1e-6);
  EXPECT_LT(estimate.readout.information, 1e-6);  // what keeps the equations solvable
}

// How far an estimate is off: place, then rotation about fixed axes, along the map's.
Vector6d ErrorOf(const Rigid3d& T, const Rigid3d& T_true) {
  const Eigen::AngleAxisd turn(T.linear() * T_true.linear().transpose());
  Vector6d error;
  error << T.translation() - T_true.translation(), turn.angle() * turn.axis();
  return error;
}

TEST_F(PoseOptimizerTest, TheCovarianceIsThatOfManyFits) {
  constexpr int kFits = 400;
  const std::vector<PoseObservation> exact = Observe(60);
  // Half of the noise that it is told of: it must notice.
  for (const double share : {0.5, 1.0}) {
    Matrix6d measured = Matrix6d::Zero(), told = Matrix6d::Zero();
    for (int i = 0; i < kFits; ++i) {
      std::vector<PoseObservation> observations = exact;
      AddNoise(share, observations);
      const PoseEstimate estimate =
          OptimizePose(observations, T_map_camera_, camera_, noise_);
      const Vector6d error = ErrorOf(estimate.T_map_camera, T_map_camera_);
      measured += error * error.transpose() / kFits;
      told += estimate.covariance / kFits;
    }
    // In the units of what is told the measured one is the identity, but for a standard error of
    // sqrt(2 / 400) = 7 %, 4 of those, and 10 % for the good observations that pass for outliers.
    const Matrix6d unit = told.llt().matrixL();
    const Matrix6d ratio =
        unit.inverse() * measured * unit.transpose().inverse();
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(ratio(i, i), 1.0, 0.38) << share << ", " << i;
    EXPECT_LT((ratio - Matrix6d(ratio.diagonal().asDiagonal())).cwiseAbs().maxCoeff(), 0.3) << share;
  }
}

TEST_F(PoseOptimizerTest, WithoutEnoughObservationsThereIsNoCovariance) {
  EXPECT_FALSE(Optimize({}).covariance.allFinite());
}

}  // namespace
}  // namespace semantic_slam
