#pragma once

#include <memory>
#include <string>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/scan/scan_builder.h"
#include "semantic_slam/submaps/grid_mapper.h"
#include "semantic_slam/submaps/grid_slam_options.h"
#include "tools/mapping_stage.h"

namespace semantic_slam {

// Thesis section 3.4.2: planar scans, submaps, the floor plan. Leaves grid.pgm and grid.yaml.
class GridStage : public MappingStage {
 public:
  // Throws ConfigError as its parts do. `timer` must outlive this.
  GridStage(const GridSlamOptions& options, std::shared_ptr<const CameraModel> camera,
            StageTimer& timer);

  const char* name() const override { return "grid"; }
  void Process(const RgbdImage& image, const TrackedImage& tracked) override;
  void FollowGraph(const KeyframeGraph& graph) override;
  void Write(const std::string& folder) override;
  Counts counts() const override;

  OccupancyMap Render() const { return mapper_.Render(); }

 private:
  StageTimer& timer_;
  const ScanBuilder scan_builder_;
  GridMapper mapper_;
  Counts outcomes_;  // of the scans
};

}  // namespace semantic_slam
