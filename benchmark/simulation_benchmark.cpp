#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "semantic_slam/worlds/world_file.h"

namespace semantic_slam {
namespace {

const std::string kConfig = SEMANTIC_SLAM_SOURCE_DIR "/config/";

std::shared_ptr<const World> Load(const std::string& name) {
  return std::make_shared<World>(LoadWorld(kConfig + "worlds/" + name + ".yaml",
                                           LabelVocabulary::Load(kConfig + "labels.yaml")));
}

// Turns round at a place of the world, `step` of 36 steps.
Rigid3d PoseAt(const Eigen::Vector3d& at_m, int step) {
  Rigid3d T_base_camera = Rigid3d::Identity();
  T_base_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Rigid3d T_world_base = Rigid3d::Identity();
  T_world_base.translation() = at_m;
  T_world_base.linear() =
      Eigen::AngleAxisd(2.0 * M_PI * step / 36.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return T_world_base * T_base_camera;
}

// Painting textures, building the ray casting structures and finding the light.
void BM_BuildRenderer(benchmark::State& state, const char* name) {
  const std::shared_ptr<const World> world = Load(name);
  for (auto _ : state) benchmark::DoNotOptimize(SceneRenderer(world));
}
BENCHMARK_CAPTURE(BM_BuildRenderer, home, "home")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(BM_BuildRenderer, office, "office")->Unit(benchmark::kMillisecond)->UseRealTime();

// One image of 640 x 480 with shadows and noise, on all cores; MeasureProcessCPUTime: the sum of
// what they spend.
void BM_Capture(benchmark::State& state, const char* name, const Eigen::Vector3d& at_m) {
  const auto renderer = std::make_shared<SceneRenderer>(Load(name));
  const SimulatedCamera camera(renderer,
                               LoadCameraConfig(kConfig + "simulated_d455.yaml").intrinsics);
  int step = 0;
  for (auto _ : state) {
    const double time_s = step / 30.0;
    benchmark::DoNotOptimize(
        camera.Capture(PoseAt(at_m, step), Stamp::FromSeconds(time_s), time_s));
    ++step;
  }
}
BENCHMARK_CAPTURE(BM_Capture, home, "home", Eigen::Vector3d(3.0, 3.2, 1.3))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(72)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(BM_Capture, office, "office", Eigen::Vector3d(3.0, 2.0, 1.3))
    ->Unit(benchmark::kMillisecond)
    ->Iterations(72)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

// What the sensor's noise takes of that.
void BM_Noise(benchmark::State& state) {
  const cv::Mat colour(480, 640, CV_8UC3, cv::Scalar::all(120));
  const cv::Mat depth_m(480, 640, CV_32FC1, cv::Scalar(2.0));
  const cv::Mat incidence(480, 640, CV_32FC1, cv::Scalar(0.8));
  const DepthNoise depth_noise({}, 384.0);
  const ColourNoise colour_noise({});
  for (auto _ : state) {
    benchmark::DoNotOptimize(colour_noise.Apply(colour, Stamp{1}));
    benchmark::DoNotOptimize(depth_noise.Apply(depth_m, incidence, Stamp{1}));
  }
}
BENCHMARK(BM_Noise)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace semantic_slam
