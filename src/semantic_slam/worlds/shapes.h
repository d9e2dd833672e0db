#pragma once

#include <functional>
#include <vector>

#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

// Solids that furniture is made of, beyond the plain ones of mesh.h. All closed.

// A leg or post with horizontal ends: from the rectangle `foot_size_m` about `foot_m` up to
// `head_size_m` about `head_m`. It may lean and taper. Precondition: the head is above the foot.
Mesh BeamMesh(const Eigen::Vector3f& foot_m, const Eigen::Vector3f& head_m,
              const Eigen::Vector2f& foot_size_m, const Eigen::Vector2f& head_size_m);

// A rod with round ends, of any direction; its ends' centres are the two points.
Mesh LimbMesh(const Eigen::Vector3f& from_m, const Eigen::Vector3f& to_m, float from_radius_m,
              float to_radius_m, int sides = 12);

// A box with round edges. Precondition: radius_m is at most half of the smallest edge.
Mesh RoundedBoxMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& size_m, float radius_m);

// A slab between two heights over a convex outline, counter-clockwise as seen from above.
Mesh SlabMesh(const std::vector<Eigen::Vector2f>& outline_m, float bottom_m, float top_m);

// Outline of a rectangle about the origin with round corners.
std::vector<Eigen::Vector2f> RoundedRectangle(const Eigen::Vector2f& size_m, float radius_m);

// Outline of an ellipse about the origin, as long along x and y as `size_m`.
std::vector<Eigen::Vector2f> EllipseOutline(const Eigen::Vector2f& size_m);

// A thin thing that bends, such as a leaf or a curtain. `middle_m(u, v)`, 0 <= u, v <= 1, is its
// middle surface, u to the right and v down as seen from its front; `half_m(u, v)` how far the
// front lies before it along `forward`, and the back behind it. The edges are sharp.
Mesh SheetMesh(const std::function<Eigen::Vector3f(float u, float v)>& middle_m,
               const std::function<float(float u, float v)>& half_m, const Eigen::Vector3f& forward,
               int columns, int rows);

// A stuffed pillow that lies flat: thick in the middle, sharp at the seams.
Mesh PillowMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& size_m);

// A leaf that starts at the origin and grows along x, its upper side to z, and bends down at its
// tip by `droop_m`.
Mesh LeafMesh(float length_m, float width_m, float droop_m);

}  // namespace semantic_slam
