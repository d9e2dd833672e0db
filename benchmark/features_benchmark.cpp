#include <benchmark/benchmark.h>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/features/matching.h"
#include "testing/handheld_path.h"
#include "testing/textured_room.h"

namespace semantic_slam {
namespace {

const TexturedRoom& Room() {
  static const TexturedRoom kRoom;
  return kRoom;
}

RgbdImage VgaImage(double t_s) {
  return Room().Render(HandheldPath::T_world_camera(t_s), Stamp::FromSeconds(t_s));
}

// ORB on one VGA image. Argument: max_features.
void BM_ExtractOrb(benchmark::State& state) {
  OrbExtractorOptions options;
  options.max_features = static_cast<int>(state.range(0));
  const OrbExtractor extractor(options);
  cv::Mat grey;
  cv::cvtColor(VgaImage(1.0).colour, grey, cv::COLOR_BGR2GRAY);
  std::size_t features = 0;
  for (auto _ : state) {
    const Keypoints found = extractor.Extract(grey);
    features = found.keypoints.size();
    benchmark::DoNotOptimize(found.descriptors.data());
  }
  state.counters["features"] = static_cast<double>(features);
}
BENCHMARK(BM_ExtractOrb)->Arg(600)->Arg(1200)->Arg(2400)->Unit(benchmark::kMillisecond);

// All that tracking needs of an image: grey, ORB, undistortion, depth and the search grid.
void BM_FrameFeatures(benchmark::State& state) {
  const OrbExtractor extractor{OrbExtractorOptions()};
  const RgbdImage image = VgaImage(1.0);
  for (auto _ : state) {
    const FrameFeatures frame(image, Room().camera(), extractor);
    benchmark::DoNotOptimize(frame.size());
  }
}
BENCHMARK(BM_FrameFeatures)->Unit(benchmark::kMillisecond);

// Every feature of one image against every one of another: what a lost camera pays per keyframe.
void BM_MatchDescriptors(benchmark::State& state) {
  const OrbExtractor extractor{OrbExtractorOptions()};
  const FrameFeatures a(VgaImage(1.0), Room().camera(), extractor);
  const FrameFeatures b(VgaImage(1.2), Room().camera(), extractor);
  std::vector<int> all(a.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  std::size_t matches = 0;
  for (auto _ : state) {
    matches = MatchDescriptors(a, all, b, DescriptorMatchingOptions()).size();
    benchmark::DoNotOptimize(matches);
  }
  state.counters["matches"] = static_cast<double>(matches);
}
BENCHMARK(BM_MatchDescriptors)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace semantic_slam
