#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "semantic_slam/local_mapping/local_mapper.h"
#include "semantic_slam/loop_closing/full_adjuster.h"
#include "semantic_slam/loop_closing/loop_detector.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/place_recognition/place_index.h"

// What mapping and loop closing cost while a map grows, on synthetic maps.

namespace semantic_slam {
namespace {

constexpr double kStepM = 0.5;        // between keyframes
constexpr double kPointsPerM = 80.0;  // of the wall's length: each keyframe sees some 300
constexpr int kChangedBits = 8;       // by which two views of a point differ, each from the point

std::shared_ptr<const CameraModel> Camera() {
  static const auto kCamera = std::make_shared<const CameraModel>(
      CameraIntrinsics{640, 480, 525.0, 525.0, 319.5, 239.5, {}});
  return kCamera;
}

// A camera that goes along a wall sideways, 3 m before it, with a keyframe every half metre, and 1
// px of noise in what it sees.
class WallMap {
 public:
  explicit WallMap(int keyframes)
      : map(std::vector<float>(8, 1.0f)),
        index(PlaceIndexOptions()),
        length_m_(kStepM * keyframes) {
    std::uniform_real_distribution<double> x_m(-2.0, length_m_ + 2.0), y_m(-1.2, 1.2),
        z_m(2.5, 3.5);
    const int points = static_cast<int>(kPointsPerM * (length_m_ + 4.0));
    for (int i = 0; i < points; ++i) {
      points_.push_back({{x_m(random_), y_m(random_), z_m(random_)}, RandomDescriptor(), kNoPoint});
    }
    std::sort(points_.begin(), points_.end(),
              [](const Point& a, const Point& b) { return a.position.x() < b.position.x(); });
    for (int i = 0; i < keyframes; ++i) AddKeyframe(i);
  }

  KeyframeId last() const { return map.keyframes().rbegin()->first; }

  Map map;
  PlaceIndex index;  // holds all keyframes but the last

 private:
  struct Point {
    Eigen::Vector3d position;
    Descriptor descriptor;
    PointId id;
  };

  Descriptor RandomDescriptor() {
    Descriptor descriptor;
    for (auto& word : descriptor) word = random_();
    return descriptor;
  }

  Descriptor Changed(Descriptor descriptor) {
    for (int i = 0; i < kChangedBits; ++i) {
      const std::uint64_t bit = random_() % 256;
      descriptor[bit / 64] ^= std::uint64_t{1} << (bit % 64);
    }
    return descriptor;
  }

  void AddKeyframe(int number) {
    const Rigid3d T_map_camera(Eigen::Translation3d(kStepM * number, 0.0, 0.0));
    std::vector<Feature> features;
    std::vector<Descriptor> descriptors;
    std::vector<Point*> seen;
    const auto begin =
        std::lower_bound(points_.begin(), points_.end(), kStepM * number - 2.5,
                         [](const Point& point, double x_m) { return point.position.x() < x_m; });
    for (auto it = begin; it != points_.end() && it->position.x() < kStepM * number + 2.5; ++it) {
      const Eigen::Vector3d p = T_map_camera.inverse() * it->position;
      const Eigen::Vector2f pixel =
          (Camera()->Project(p) + Eigen::Vector2d(noise_(random_), noise_(random_))).cast<float>();
      if (!Camera()->undistorted_bounds().contains(cv::Point2f(pixel.x(), pixel.y()))) continue;
      features.push_back({pixel, pixel, pixel, static_cast<float>(p.z()), 0.0f, 0, {}});
      descriptors.push_back(Changed(it->descriptor));
      seen.push_back(&*it);
    }
    const auto frame = std::make_shared<const FrameFeatures>(Stamp{1'000'000'000 * (number + 1LL)},
                                                             std::move(features),
                                                             std::move(descriptors), *Camera());
    const KeyframeId id = map.AddKeyframe(frame, T_map_camera).id;
    for (std::size_t i = 0; i < seen.size(); ++i) Observe(*seen[i], id, static_cast<int>(i));
    map.UpdateCovisibility(id);
    if (number > 0) index.Add(id - 1, map.FindKeyframe(id - 1)->features);
  }

  void Observe(Point& point, KeyframeId keyframe, int feature) {
    if (point.id == kNoPoint) {
      point.id = map.AddPoint(point.position, keyframe, feature).id;
    } else {
      map.AddObservation(point.id, keyframe, feature);
    }
  }

  const double length_m_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> noise_;
  std::vector<Point> points_;  // by ascending x
};

// Kept between benchmarks, one at a time.
WallMap& MapOf(int keyframes) {
  static std::map<int, std::unique_ptr<WallMap>> maps;
  if (maps.count(keyframes) == 0) {
    maps.clear();
    maps[keyframes] = std::make_unique<WallMap>(keyframes);
  }
  return *maps[keyframes];
}

void Describe(const WallMap& wall, benchmark::State& state) {
  state.counters["points"] = static_cast<double>(wall.map.point_count());
}

// All that local mapping does with a new keyframe.
void BM_LocalMapping(benchmark::State& state) {
  WallMap& wall = MapOf(static_cast<int>(state.range(0)));
  LocalMapperOptions options;
  options.redundant_share = 1.0;  // the map stays as it is
  LocalMapper mapper(options, Camera(), wall.map);
  StageTimer timer;
  for (auto _ : state) mapper.Process(wall.last(), timer);
  Describe(wall, state);
}

// A keyframe that closes no loop: the index is asked, and what looks alike is looked at.
void BM_DetectLoop(benchmark::State& state) {
  const WallMap& wall = MapOf(static_cast<int>(state.range(0)));
  const LoopDetector detector(LoopDetectorOptions(), wall.index, wall.map);
  for (auto _ : state) benchmark::DoNotOptimize(detector.Detect(wall.last(), *Camera()));
  Describe(wall, state);
}

// Bundle adjustment of the whole map after a loop; above 400 keyframes it is left out by default.
void BM_AdjustAll(benchmark::State& state) {
  WallMap& wall = MapOf(static_cast<int>(state.range(0)));
  FullAdjusterOptions options;
  options.max_keyframes = 100000;
  FullAdjuster adjuster(options, wall.map);
  for (auto _ : state) {
    FullAdjuster::Work work = adjuster.Copy();
    adjuster.Solve(work, *Camera());
    benchmark::DoNotOptimize(work.points.data());
  }
  Describe(wall, state);
}

// Everything of one size before the next, so that each map is made once.
[[maybe_unused]] const bool kRegistered = [] {
  for (const int keyframes : {50, 100, 200, 400, 1000}) {
    const auto add = [keyframes](const char* name, auto* function) {
      benchmark::RegisterBenchmark(name, function)
          ->ArgName("keyframes")
          ->Arg(keyframes)
          ->Unit(benchmark::kMillisecond);
    };
    add("BM_LocalMapping", BM_LocalMapping);
    add("BM_DetectLoop", BM_DetectLoop);
    add("BM_AdjustAll", BM_AdjustAll);
  }
  return true;
}();

}  // namespace
}  // namespace semantic_slam
