#pragma once

#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// Writes into `folder` what the maps of a flight should show, in the world frame: objects.json with
// all objects that stand still, floor_plan_flight (.pgm, .yaml) about the height of the flight and
// floor_plan_projection of all that stands about. Throws InputError naming a file that cannot be
// written, or if the world or the trajectory is empty.
void WriteTruthFiles(const std::string& folder, const World& world,
                     const LabelVocabulary& vocabulary, const Trajectory& T_world_camera);

}  // namespace semantic_slam
