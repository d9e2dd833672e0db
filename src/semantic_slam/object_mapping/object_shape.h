#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/object_mapping/object_geometry.h"
#include "semantic_slam/plane_projection/convex_polygon.h"

namespace semantic_slam {

// An object in the map frame, as all its observations together tell it.
struct ObjectShape {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  ConvexPolygon outline_m;  // footprint
  ConvexPolygon body_m;     // outline of all of it
  Rectangle box;            // the smallest around body_m
  double min_height_m = 0.0;
  double max_height_m = 0.0;
  SpaceBelow below;
};

using KeyframePoseOf = std::function<Rigid3d(KeyframeId)>;  // T_map_keyframe

// Fuses what several images showed of one object. Positions are weighed by their covariances;
// heights and the reach of outlines in every direction are the upper quartile over the
// observations: each shows one side only, and some are wrong. If the object was ever all in view,
// observations of a part of it do not count. nullopt if no outline with an area comes of it.
std::optional<ObjectShape> FuseObservations(const std::vector<ObjectObservation>& observations,
                                            const KeyframePoseOf& keyframe_pose);

// How much of two objects' space is one: of the oriented boxes around them, each made thicker by a
// bit of its size for errors of depth and pose.
struct Overlap {
  double of_union = 0.0;
  double of_smaller = 0.0;
};
Overlap OverlapOf(const ObjectShape& a, const ObjectShape& b);

}  // namespace semantic_slam
