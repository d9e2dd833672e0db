#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/plane_projection/hollowness.h"

namespace semantic_slam {

using ObjectId = std::int64_t;

struct LabelProbability {
  LabelId label = kUnknownLabel;
  float probability = 0.0f;
};

// One object of the object map, everything in the map frame (z up).
struct MapObject {
  ObjectId id = 0;                       // never used again
  std::vector<LabelProbability> labels;  // by descending probability; their sum is at most 1
  Eigen::Vector3d position_m;            // mean of the centre, thesis eq. (3.25)
  Eigen::Matrix3d position_covariance_m2;
  Rigid3d T_map_box = Rigid3d::Identity();  // centre and axes of the oriented box; its z is up
  Eigen::Vector3d box_size_m;               // edge lengths along the box's own axes
  double min_height_m = 0.0;                // lowest point
  double max_height_m = 0.0;                // highest point
  Hollowness hollow = Hollowness::kNo;
  std::vector<Eigen::Vector2d> footprint_m;  // convex outline on the floor, counter-clockwise
  int observations = 0;                      // images that it was seen in
  Stamp last_seen;
};

// The objects of one map, by ascending id.
struct ObjectMap {
  Stamp stamp;  // the newest image in it
  int map_id = 0;
  std::uint64_t revision = 0;  // of the keyframe graph that the positions follow
  std::uint64_t vocabulary_hash = 0;
  std::vector<MapObject> objects;
};

}  // namespace semantic_slam
