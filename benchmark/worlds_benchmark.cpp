#include <benchmark/benchmark.h>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/worlds/pattern.h"
#include "semantic_slam/worlds/texture.h"

namespace semantic_slam {
namespace {

Material MaterialOf(const std::string& name, const Pattern& pattern) {
  Material material;
  material.pattern = name;
  if (pattern.extent == Pattern::Extent::kPicture) material.picture_size_m = {0.8f, 0.6f};
  return material;
}

// One texture of every pattern, with its smaller copies.
void BM_PaintEveryPattern(benchmark::State& state) {
  std::size_t bytes = 0;
  for (auto _ : state) {
    bytes = 0;
    for (const auto& [name, pattern] : Patterns()) {
      bytes += Texture(MaterialOf(name, pattern)).SizeInBytes();
    }
  }
  state.counters["patterns"] = static_cast<double>(Patterns().size());
  state.counters["MB"] = static_cast<double>(bytes) * 1e-6;
}
BENCHMARK(BM_PaintEveryPattern)->Unit(benchmark::kMillisecond);

// What a renderer asks for: neighbouring places along a surface, 1 to 4 m away. Argument: 0 for a
// picture, 1 for what repeats.
void BM_SampleTexture(benchmark::State& state) {
  const std::string name = state.range(0) == 0 ? "poster" : "brick";
  const Texture texture(MaterialOf(name, Patterns().at(name)));
  RandomStream random(1);
  cv::Vec3f sum = cv::Vec3f::all(0.0f);
  for (auto _ : state) {
    const auto y_m = static_cast<float>(random.Uniform());
    const auto footprint_m = static_cast<float>(0.0025 + 0.0075 * random.Uniform());
    for (int i = 0; i < 640; ++i) sum += texture.Sample(0.004f * i - 0.5f, y_m, footprint_m);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(640 * state.iterations());
}
BENCHMARK(BM_SampleTexture)->Arg(0)->Arg(1);

}  // namespace
}  // namespace semantic_slam
