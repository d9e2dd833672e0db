#pragma once

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// The object as a perfect map would hold it, in the world frame: the smallest upright box around
// it, whose centre is its position, the convex outline of all of it, and whether there is room
// below its top: its largest level surface. Its id is its instance. It must have a surface.
MapObject TrueObject(const WorldObject& object, const LabelVocabulary& vocabulary);

// All objects of a world that stand still and are no part of the building.
ObjectMap TrueObjects(const World& world, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
