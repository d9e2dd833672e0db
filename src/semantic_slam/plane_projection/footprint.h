#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/plane_projection/convex_polygon.h"
#include "semantic_slam/plane_projection/top_plane.h"

namespace semantic_slam {

// What an object takes up of the floor plan.
struct Footprint {
  ConvexPolygon outline_m;    // of its top plane, or of all of it where it has none
  ConvexPolygon body_m;       // of all of it, a chair's back and legs too
  double min_height_m = 0.0;  // of all of it
  double max_height_m = 0.0;
};

// Projects an object's points along z onto the map plane, thesis section 3.4.3: the points of its
// top plane, so that a hollow object covers what is below its top. nullopt if the points span no
// area.
//
//   points  of the object, in any frame with z up
std::optional<Footprint> ProjectFootprint(const std::vector<Eigen::Vector3f>& points,
                                          const std::optional<TopPlane>& top);

}  // namespace semantic_slam
