#include <random>

#include <benchmark/benchmark.h>

#include "semantic_slam/local_mapping/bundle_adjustment.h"

namespace semantic_slam {
namespace {

// As many cameras as local mapping takes by default, along 4 m, before a wall of points: each sees
// those in its image, with 1 px of noise. Arguments: cameras that move, cameras that are fixed,
// points.
BundleProblem Wall(int moving, int fixed, int points, const CameraModel& camera) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x_m(-3.5, 3.5), y_m(-1.2, 1.2), z_m(2.0, 3.5);
  std::normal_distribution<double> noise;
  BundleProblem problem;
  const int cameras = moving + fixed;
  for (int i = 0; i < cameras; ++i) {
    const Rigid3d T_map_camera(Eigen::Translation3d(4.0 * i / cameras - 2.0, 0.0, 0.0));
    problem.cameras.push_back({T_map_camera, i >= moving});
  }
  for (int j = 0; j < points; ++j) {
    problem.points.emplace_back(x_m(random), y_m(random), z_m(random));
    for (int i = 0; i < cameras; ++i) {
      const Eigen::Vector3d p = problem.cameras[i].T_map_camera.inverse() * problem.points[j];
      const Eigen::Vector2d pixel = camera.Project(p);
      if (!camera.undistorted_bounds().contains(cv::Point2d(pixel.x(), pixel.y()))) continue;
      const double inverse_depth =
          1.0 / p.z() + ObservationNoise().InverseDepthSigma() * noise(random);
      problem.observations.push_back(
          {i, j, pixel + Eigen::Vector2d(noise(random), noise(random)), 1.0 / inverse_depth, 1.0});
    }
  }
  for (int i = 0; i < moving; ++i) {
    problem.cameras[i].T_map_camera.translation() += 0.01 * Eigen::Vector3d(1.0, -1.0, 1.0);
  }
  return problem;
}

void BM_AdjustBundle(benchmark::State& state) {
  const CameraModel camera({640, 480, 525.0, 525.0, 319.5, 239.5, {}});
  const BundleProblem start =
      Wall(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)),
           static_cast<int>(state.range(2)), camera);
  for (auto _ : state) {
    state.PauseTiming();
    BundleProblem problem = start;
    state.ResumeTiming();
    benchmark::DoNotOptimize(AdjustBundle(problem, camera, BundleOptions()));
  }
  state.counters["observations"] = static_cast<double>(start.observations.size());
}
BENCHMARK(BM_AdjustBundle)
    ->ArgNames({"moving", "fixed", "points"})
    ->Args({5, 5, 500})
    ->Args({15, 25, 2000})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace semantic_slam
