#include "tools/grid_stage.h"

#include <utility>

#include "semantic_slam/submaps/occupancy_map_file.h"

namespace semantic_slam {

GridStage::GridStage(const GridSlamOptions& options, std::shared_ptr<const CameraModel> camera,
                     StageTimer& timer)
    : timer_(timer), scan_builder_(options.scan, std::move(camera)), mapper_(options) {}

void GridStage::Process(const RgbdImage& image, const TrackedImage& tracked) {
  PlanarScan scan;
  {
    StageTimer::Scope scope(timer_, "grid.scan");
    scan = scan_builder_.Build(image, tracked.T_map_camera);
  }
  StageTimer::Scope scope(timer_, "grid.insertion");
  ++outcomes_[std::string("scans_") + ToString(mapper_.Insert(scan, tracked))];
}

void GridStage::FollowGraph(const KeyframeGraph& graph) {
  StageTimer::Scope scope(timer_, "grid.follow_graph");
  mapper_.FollowGraph(graph);
}

void GridStage::Write(const std::string& folder) {
  const OccupancyMap map = Render();
  if (!map.cells.empty()) WriteOccupancyMap(folder, map);
}

MappingStage::Counts GridStage::counts() const {
  Counts counts = outcomes_;
  counts["submaps"] = mapper_.submaps();
  return counts;
}

}  // namespace semantic_slam
