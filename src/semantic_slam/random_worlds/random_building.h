#pragma once

#include <string>
#include <vector>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/random_worlds/piece_maker.h"
#include "semantic_slam/random_worlds/world_split.h"
#include "semantic_slam/worlds/building.h"
#include "semantic_slam/worlds/world_assembly.h"

namespace semantic_slam {

// A hole in a wall and what is in it.
struct PlannedOpening {
  enum class Kind { kDoor, kFramedPassage, kPassage, kWindow };
  Kind kind = Kind::kDoor;
  WallOpening hole;
};

// A building of rooms side by side, with its openings cut.
struct PlannedBuilding {
  Building building;
  std::vector<PlannedOpening> openings;
};

// One to four rooms, each with a way to another, windows in outer walls.
PlannedBuilding PlanBuilding(WorldSplit split, RandomStream& random);

// Puts rooms, doors and windows into the world.
void AddBuilding(const PlannedBuilding& plan, PieceMaker& maker, WorldAssembly& assembly);

}  // namespace semantic_slam
