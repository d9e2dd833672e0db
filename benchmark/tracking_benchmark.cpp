#include <memory>
#include <random>

#include <benchmark/benchmark.h>

#include "semantic_slam/tracking/pose_optimizer.h"
#include "semantic_slam/tracking/tracker.h"
#include "testing/handheld_path.h"
#include "testing/textured_room.h"

namespace semantic_slam {
namespace {

// The pose of a VGA camera from points 1 to 5 m away with 1 px of noise and 10 % outliers.
// Argument: how many points.
void BM_OptimizePose(benchmark::State& state) {
  const CameraModel camera({640, 480, 525.0, 525.0, 319.5, 239.5, {}});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u_px(0.0, 639.0), v_px(0.0, 479.0), depth_m(1.0, 5.0);
  std::normal_distribution<double> noise_px;
  std::vector<PoseObservation> observations;
  for (int i = 0; i < state.range(0); ++i) {
    const Eigen::Vector2d pixel(u_px(random), v_px(random));
    const double z_m = depth_m(random);
    const Eigen::Vector2d noise(noise_px(random), noise_px(random));
    observations.push_back({camera.Unproject(pixel.x(), pixel.y(), z_m),
                            pixel + (i % 10 == 0 ? 50.0 : 1.0) * noise, z_m, 1.0});
  }
  const Rigid3d T_start = Eigen::Translation3d(0.02, -0.02, 0.02) *
                          Eigen::AngleAxisd(0.02, Eigen::Vector3d(0.6, 0.8, 0.0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(OptimizePose(observations, T_start, camera, ObservationNoise()));
  }
}
BENCHMARK(BM_OptimizePose)->Arg(100)->Arg(500)->Unit(benchmark::kMicrosecond);

// Tracking without feature extraction and without local mapping: a camera going to and fro between
// images that it has seen.
void BM_Track(benchmark::State& state) {
  constexpr int kImages = 8;
  const TexturedRoom room;
  const OrbExtractor extractor{OrbExtractorOptions()};
  const auto features_at = [&](int image, Stamp stamp) {
    const RgbdImage rendered = room.Render(HandheldPath::T_world_camera(image / 30.0), stamp);
    return std::make_shared<const FrameFeatures>(rendered, room.camera(), extractor);
  };
  // All of one stamp: the prediction is then the last pose, on the way there and on the way back.
  std::vector<std::shared_ptr<const FrameFeatures>> frames;
  for (int i = 0; i < kImages; ++i) frames.push_back(features_at(i, Stamp{1}));
  Map map(extractor.scales());
  const PlaceIndex index{PlaceIndexOptions()};
  Tracker tracker(TrackerOptions(), ReadoutOptions(),
                  std::make_shared<const CameraModel>(room.camera()), map, index);
  tracker.Track(frames[0], true);
  int image = 0, step = 1;
  std::int64_t inliers = 0;
  for (auto _ : state) {
    if (image + step < 0 || image + step == kImages) step = -step;
    image += step;
    inliers += tracker.Track(frames[image], false).image.inliers;
  }
  state.counters["inliers"] =
      benchmark::Counter(static_cast<double>(inliers), benchmark::Counter::kAvgIterations);
}
BENCHMARK(BM_Track)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace semantic_slam
