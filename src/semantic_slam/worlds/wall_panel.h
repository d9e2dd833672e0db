#pragma once

#include <vector>

#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

// A rectangle on a wall as seen from its front: along it from its left end, and up from its foot.
struct WallRectangle {
  float left_m = 0.0f;
  float right_m = 0.0f;
  float bottom_m = 0.0f;
  float top_m = 0.0f;
};

// A wall with holes, closed: its front at x = 0 faces +x, its left end (as seen from the front) is
// at the origin, and from there it runs along +y; its back is at x = -thickness_m. The texture
// runs on around the holes. Precondition: holes lie inside, they may touch the edges.
Mesh WallPanelMesh(float length_m, float height_m, float thickness_m,
                   const std::vector<WallRectangle>& holes);

}  // namespace semantic_slam
