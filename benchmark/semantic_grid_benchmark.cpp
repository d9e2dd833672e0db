#include <benchmark/benchmark.h>

#include "semantic_slam/semantic_grid/semantic_grid_builder.h"
#include "semantic_slam/semantic_grid/semantic_grid_picture.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam {
namespace {

// A hall of 40 x 40 m in cells of 5 cm.
OccupancyMap Hall() {
  OccupancyMap map;
  map.resolution_m = 0.05;
  map.width = map.height = 800;
  map.cells.assign(static_cast<std::size_t>(map.width) * map.height, 0);
  return map;
}

// Tables of 1.6 x 0.8 m in rows, each turned otherwise; positions to 5 cm.
ObjectMap Tables(int count) {
  ObjectMap map;
  map.vocabulary_hash = SmallVocabulary().hash();
  for (int i = 0; i < count; ++i) {
    MapObject table;
    table.id = i;
    table.labels = {{4, 0.6f}, {3, 0.2f}, {9, 0.1f}};
    table.position_m = {2.0 + 3.6 * (i % 10), 2.0 + 3.6 * (i / 10), 0.0};
    table.position_covariance_m2 = 0.0025 * Eigen::Matrix3d::Identity();
    table.T_map_box = Eigen::Translation3d(table.position_m) *
                      Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d::UnitZ());
    table.box_size_m = {1.6, 0.8, 0.7};
    map.objects.push_back(table);
  }
  return map;
}

// Argument: objects.
void BM_BuildSemanticGrid(benchmark::State& state) {
  const SemanticGridBuilder builder({}, {}, SmallVocabulary());
  const OccupancyMap map = Hall();
  const ObjectMap objects = Tables(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(builder.Build(map, objects).cost.data());
}
BENCHMARK(BM_BuildSemanticGrid)->Arg(0)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

void BM_DrawSemanticGrid(benchmark::State& state) {
  const SemanticGridBuilder builder({}, {}, SmallVocabulary());
  const OccupancyMap map = Hall();
  const ObjectMap objects = Tables(100);
  const SemanticCells cells = builder.Build(map, objects);
  for (auto _ : state) {
    benchmark::DoNotOptimize(DrawSemanticGrid(cells, map, objects, builder.vocabulary()).data);
  }
}
BENCHMARK(BM_DrawSemanticGrid)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace semantic_slam
