#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/worlds/building.h"

namespace semantic_slam {

// Where a piece stands that fills a hole in a wall, and how large it is.
struct FittedPiece {
  Rigid3d T_world_object;
  Eigen::Vector3f size_m;
};

// A door, or the frame of a passage, with its casing; it opens to the site's room. Preconditions:
// the hole is in the building, the site is one of the hole's.
FittedPiece FitDoor(const Building& building, const WallOpening& hole, const WallSite& site);

// A window, seen from the site's room. Preconditions as above.
FittedPiece FitWindow(const Building& building, const WallOpening& hole, const WallSite& site);

}  // namespace semantic_slam
