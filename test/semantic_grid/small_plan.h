#pragma once

#include <utility>

#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/submaps/occupancy_map.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam {

// A floor plan of 10 x 10 free cells of 10 cm, from (0, 0) m.
inline OccupancyMap FreePlan() {
  OccupancyMap map;
  map.stamp = Stamp{5};
  map.map_id = 1;
  map.revision = 3;
  map.resolution_m = 0.1;
  map.width = map.height = 10;
  map.cells.assign(100, 0);
  return map;
}

// A table of 0.4 x 0.2 m, from (0.2, 0.3) to (0.6, 0.5) m, 0.7 m high; its position is certain.
inline MapObject SmallTable() {
  MapObject table;
  table.id = 1;
  table.labels = {{4, 1.0f}};
  table.position_m = {0.4, 0.4, 0.35};
  table.position_covariance_m2 = Eigen::Matrix3d::Zero();
  table.T_map_box.translation() = table.position_m;
  table.box_size_m = {0.4, 0.2, 0.7};
  table.min_height_m = 0.0;
  table.max_height_m = 0.7;
  table.hollow = Hollowness::kFull;
  table.footprint_m = {{0.2, 0.3}, {0.6, 0.3}, {0.6, 0.5}, {0.2, 0.5}};
  return table;
}

inline ObjectMap ObjectMapOf(std::vector<MapObject> objects) {
  ObjectMap map;
  map.stamp = Stamp{7};
  map.map_id = 2;
  map.revision = 9;
  map.vocabulary_hash = SmallVocabulary().hash();
  map.objects = std::move(objects);
  return map;
}

}  // namespace semantic_slam
