#include "semantic_slam/submaps/grid_slam_options.h"

namespace semantic_slam {

void ReadGridSlamOptions(YamlReader& file, GridSlamOptions& options) {
  GridSlamOptions::VisitGroups(
      options, [&](const char* name, auto& group) { file.ReadOptions(name, group); });
}

}  // namespace semantic_slam
