#pragma once

#include <vector>

#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

// The pieces of a mesh that share no corner, such as the six faces of a box. Triangles that cannot
// be drawn are left out: without area, with a corner that does not exist or is not finite.
std::vector<Mesh> ConnectedParts(const Mesh& mesh);

// Whether all of `part` lies in one plane and is lit as one. Precondition: it has triangles.
bool IsFlat(const Mesh& part);

// The same surface in triangles none of whose edges is longer than `max_edge_m` (or, at the worst,
// an eighth of that before). No gaps come about between them.
Mesh Refined(Mesh part, float max_edge_m);

}  // namespace semantic_slam
