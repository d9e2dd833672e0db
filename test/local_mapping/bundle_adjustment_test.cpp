#include "semantic_slam/local_mapping/bundle_adjustment.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kCameras = 6;
constexpr int kFixed = 2;
constexpr int kPoints = 120;

const CameraModel& Camera() {
  static const CameraModel kCamera({640, 480, 525.0, 525.0, 319.5, 239.5, {}});
  return kCamera;
}

// Cameras in a row, 0.15 m apart, each turned a bit otherwise, before a cloud of points 1.5 to 3.5
// m away; all of it moved by T_map_row. The first two cameras are fixed.
BundleProblem ExactProblem(const Rigid3d& T_map_row = Rigid3d::Identity()) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x_m(-0.8, 0.8), y_m(-0.6, 0.6), z_m(1.5, 3.5);
  BundleProblem problem;
  for (int i = 0; i < kCameras; ++i) {
    const Rigid3d T_row_camera = Eigen::Translation3d(0.15 * i - 0.4, 0.02 * i, 0.0) *
                                 Eigen::AngleAxisd(0.04 * (2 - i), Eigen::Vector3d::UnitY());
    problem.cameras.push_back({T_map_row * T_row_camera, i < kFixed});
  }
  for (int j = 0; j < kPoints; ++j) {
    problem.points.push_back(T_map_row * Eigen::Vector3d(x_m(random), y_m(random), z_m(random)));
  }
  for (int i = 0; i < kCameras; ++i) {
    const Rigid3d T_camera_map = problem.cameras[i].T_map_camera.inverse();
    for (int j = 0; j < kPoints; ++j) {
      const Eigen::Vector3d p = T_camera_map * problem.points[j];
      const bool has_depth = (i + j) % 3 != 0;
      problem.observations.push_back({i, j, Camera().Project(p), has_depth ? p.z() : kNan, 1.0});
    }
  }
  return problem;
}

// Moves what may move, by centimetres and a degree, as far as tracking may be wrong.
BundleProblem Perturbed(BundleProblem problem) {
  std::mt19937 random(2);
  std::normal_distribution<double> error_m(0.0, 0.02);
  for (int i = kFixed; i < kCameras; ++i) {
    Rigid3d& T = problem.cameras[i].T_map_camera;
    T = Nudged(T, 0.03, 0.02, static_cast<std::uint32_t>(i));
  }
  for (Eigen::Vector3d& p : problem.points) {
    p += Eigen::Vector3d(error_m(random), error_m(random), error_m(random));
  }
  return problem;
}

// Measurement noise, `share` of what the options say.
void AddNoise(double share, BundleProblem& problem) {
  const ObservationNoise noise;
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, share);
  for (BundleObservation& o : problem.observations) {
    o.pixel += noise.PixelSigma(o.pyramid_scale) * Eigen::Vector2d(normal(random), normal(random));
    o.depth_m = 1.0 / (1.0 / o.depth_m + noise.InverseDepthSigma() * normal(random));
  }
}

BundleOptions ManyIterations() {
  BundleOptions options;
  options.robust_iterations = options.final_iterations = 20;
  return options;
}

void ExpectNear(const BundleProblem& problem, const BundleProblem& truth, double distance_m,
                double angle_rad) {
  for (int i = 0; i < kCameras; ++i) {
    const Rigid3d &T = problem.cameras[i].T_map_camera, &T_true = truth.cameras[i].T_map_camera;
    EXPECT_LT(DistanceBetween(T, T_true), distance_m) << "camera " << i;
    EXPECT_LT(AngleBetween(T, T_true), angle_rad) << "camera " << i;
  }
  double sum_m2 = 0.0;
  for (int j = 0; j < kPoints; ++j) sum_m2 += (problem.points[j] - truth.points[j]).squaredNorm();
  EXPECT_LT(std::sqrt(sum_m2 / kPoints),
            5.0 * distance_m);  // 6 observations each, a camera has 120
}

TEST(AdjustBundleTest, RecoversCamerasAndPointsFromExactObservations) {
  // Also turned by half a turn, where a rotation vector is longest, and nearly so.
  for (const double angle_rad : {0.0, 1.0, M_PI - 1e-3, M_PI}) {
    const Rigid3d T_map_row = Eigen::Translation3d(3.0, -2.0, 1.0) *
                              Eigen::AngleAxisd(angle_rad, Eigen::Vector3d(0.6, 0.8, 0.0));
    const BundleProblem truth = ExactProblem(T_map_row);
    BundleProblem problem = Perturbed(truth);
    const BundleSummary summary = AdjustBundle(problem, Camera(), ManyIterations());
    ExpectNear(problem, truth, 1e-4, 1e-4);  // Ceres stops when the cost falls by less than 1e-5
    EXPECT_LT(summary.final_cost, 1e-3 * summary.initial_cost) << angle_rad;
    EXPECT_EQ(std::count(summary.is_inlier.begin(), summary.is_inlier.end(), true),
              kCameras * kPoints)
        << angle_rad;
  }
}

TEST(AdjustBundleTest, FixedCamerasKeepEveryBit) {
  const BundleProblem start = Perturbed(ExactProblem());
  BundleProblem problem = start;
  AdjustBundle(problem, Camera(), {});
  for (int i = 0; i < kCameras; ++i) {
    EXPECT_EQ(problem.cameras[i].T_map_camera.matrix() == start.cameras[i].T_map_camera.matrix(),
              i < kFixed)
        << i;
  }
}

TEST(AdjustBundleTest, PointsThatNobodySeesStay) {
  BundleProblem problem = Perturbed(ExactProblem());
  const Eigen::Vector3d unseen(1.0, 2.0, 3.0);
  problem.points.push_back(unseen);
  problem.cameras.push_back({Rigid3d::Identity(), false});  // and a camera that sees nothing
  AdjustBundle(problem, Camera(), {});
  EXPECT_EQ(problem.points.back(), unseen);
  EXPECT_TRUE(problem.cameras.back().T_map_camera.isApprox(Rigid3d::Identity(), 1e-12));
}

TEST(AdjustBundleTest, StandsNoiseAndOutliers) {
  const BundleProblem truth = ExactProblem();
  BundleProblem problem = truth;
  AddNoise(1.0, problem);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> error_px(10.0, 60.0);
  std::vector<bool> is_wrong(problem.observations.size());
  for (std::size_t i = 0; i < is_wrong.size(); i += 11) {  // a point has at most one of them
    is_wrong[i] = true;
    problem.observations[i].pixel.x() += error_px(random);
  }
  problem = Perturbed(problem);
  const BundleSummary summary = AdjustBundle(problem, Camera(), ManyIterations());
  // 1 px at 2.5 m is 5 mm; a hundred points make a camera ten times better, and what position and
  // rotation explain alike makes it worse again. A point has six views within 0.75 m: the same 5 mm
  // across, and several times that along the rays.
  ExpectNear(problem, truth, 0.01, 0.005);
  int wrong_kept = 0, good_lost = 0;
  for (std::size_t i = 0; i < is_wrong.size(); ++i) {
    wrong_kept += is_wrong[i] && summary.is_inlier[i];
    good_lost += !is_wrong[i] && !summary.is_inlier[i];
  }
  EXPECT_EQ(wrong_kept, 0);
  EXPECT_LT(good_lost, 0.1 * is_wrong.size());  // 5 % exceed the limit by definition
}

TEST(AdjustBundleTest, WrongDepthDoesNotCostTheObservation) {
  const BundleProblem truth = ExactProblem();
  BundleProblem problem = Perturbed(truth);
  for (std::size_t i = 0; i < problem.observations.size(); i += 7) {
    problem.observations[i].depth_m += 0.8;  // the wall behind the edge
  }
  const BundleSummary summary = AdjustBundle(problem, Camera(), ManyIterations());
  ExpectNear(problem, truth, 1e-3, 1e-3);
  EXPECT_EQ(std::count(summary.is_inlier.begin(), summary.is_inlier.end(), false), 0);
}

TEST(AdjustBundleTest, NoSmallStepMakesTheResultBetter) {
  BundleProblem problem = ExactProblem();
  AddNoise(0.4, problem);  // so little that everything is an inlier
  for (std::size_t i = 0; i < problem.observations.size(); i += 2) {
    problem.observations[i].pyramid_scale = 1.5;
  }
  problem = Perturbed(problem);
  const BundleSummary summary = AdjustBundle(problem, Camera(), ManyIterations());
  ASSERT_EQ(std::count(summary.is_inlier.begin(), summary.is_inlier.end(), false), 0);
  // What AdjustBundle() promises to minimise, written down independently of it.
  const auto cost = [](const BundleProblem& bundle) {
    double sum = 0.0;
    for (const BundleObservation& o : bundle.observations) {
      const Eigen::Vector3d p =
          bundle.cameras[o.camera].T_map_camera.inverse() * bundle.points[o.point];
      const double u = (525.0 * p.x() / p.z() + 319.5 - o.pixel.x()) / o.pyramid_scale;
      const double v = (525.0 * p.y() / p.z() + 239.5 - o.pixel.y()) / o.pyramid_scale;
      const double depth =
          o.depth_m > 0.0 ? (1.0 / p.z() - 1.0 / o.depth_m) / ObservationNoise().InverseDepthSigma()
                          : 0.0;
      sum += u * u + v * v + depth * depth;
    }
    return 0.5 * sum;  // as Ceres counts
  };
  const double least = cost(problem);
  EXPECT_NEAR(summary.final_cost, least, 1e-6 * least);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double step : {-1e-3, 1e-3}) {
      for (int i = kFixed; i < kCameras; ++i) {
        BundleProblem moved = problem, turned = problem;
        moved.cameras[i].T_map_camera.translation()[axis] += step;
        turned.cameras[i].T_map_camera.linear() *= ExpSo3(step * Eigen::Vector3d::Unit(axis));
        EXPECT_GT(cost(moved), least) << "camera " << i << " " << axis << " " << step;
        EXPECT_GT(cost(turned), least) << "camera " << i << " " << axis << " " << step;
      }
      for (int j = 0; j < kPoints; ++j) {
        BundleProblem moved = problem;
        moved.points[j][axis] += step;
        EXPECT_GT(cost(moved), least) << "point " << j << " " << axis << " " << step;
      }
    }
  }
}

TEST(AdjustBundleTest, OneFixedCameraPlacesAPointByItsDepth) {
  BundleProblem problem;
  problem.cameras.push_back({Rigid3d::Identity(), true});
  problem.points.push_back({0.05, -0.05, 2.3});
  problem.observations.push_back({0, 0, {319.5, 239.5}, 2.0, 1.0});
  AdjustBundle(problem, Camera(), ManyIterations());
  EXPECT_LT((problem.points[0] - Eigen::Vector3d(0.0, 0.0, 2.0)).norm(), 1e-4);
}

TEST(AdjustBundleTest, APointBehindACameraDoesNotPullIt) {
  const BundleProblem truth = ExactProblem();
  BundleProblem problem = Perturbed(truth);
  problem.points.push_back({0.0, 0.0, -2.0});
  const int point = static_cast<int>(problem.points.size()) - 1;
  for (int i = 0; i < kCameras; ++i) {
    problem.observations.push_back({i, point, {320.0, 240.0}, kNan, 1.0});
  }
  const BundleSummary summary = AdjustBundle(problem, Camera(), ManyIterations());
  ExpectNear(problem, truth, 1e-4, 1e-4);
  for (int i = 0; i < kCameras; ++i) {
    EXPECT_FALSE(summary.is_inlier[summary.is_inlier.size() - 1 - i]);
  }
}

TEST(AdjustBundleTest, NothingToDoIsDone) {
  BundleProblem problem;
  EXPECT_TRUE(AdjustBundle(problem, Camera(), {}).is_inlier.empty());
  problem = ExactProblem();
  problem.observations.clear();
  EXPECT_TRUE(AdjustBundle(problem, Camera(), {}).is_inlier.empty());
  ExpectNear(problem, ExactProblem(), 1e-12, 1e-7);  // acos() near 1 is good to 1e-8 only
}

TEST(AdjustBundleTest, TheSameProblemGivesTheSameBytes) {
  BundleProblem start = ExactProblem();
  AddNoise(1.0, start);
  start = Perturbed(start);
  BundleProblem first = start, again = start;
  AdjustBundle(first, Camera(), {});
  AdjustBundle(again, Camera(), {});
  for (int i = 0; i < kCameras; ++i) {
    EXPECT_EQ(first.cameras[i].T_map_camera.matrix(), again.cameras[i].T_map_camera.matrix()) << i;
  }
  EXPECT_EQ(first.points, again.points);
}

}  // namespace
}  // namespace semantic_slam
