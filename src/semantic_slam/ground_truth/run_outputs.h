#pragma once

#include <memory>
#include <optional>
#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

// What replay or the nodes have left in a folder, as far as it is there.
struct RunOutputs {
  Trajectory trajectory;                      // trajectory.txt: T_map_camera of the optical frame
  std::unique_ptr<SemanticOcTree> tree;       // semantic_map.ot; nullptr if absent
  std::optional<ObjectMap> objects;           // objects.json
  std::optional<OccupancyMap> grid;           // grid.yaml
  std::optional<OccupancyMap> semantic_grid;  // semantic_grid.yaml: cost in percent
};

// Throws InputError naming the file if the trajectory is missing, without which nobody knows where
// the maps lie, or a file is there but not understood.
RunOutputs ReadRunOutputs(const std::string& folder, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
