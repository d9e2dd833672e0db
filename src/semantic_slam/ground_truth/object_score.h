#pragma once

#include <cstddef>
#include <vector>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/evaluation/trajectory_error.h"
#include "semantic_slam/object_mapping/map_object.h"

namespace semantic_slam {

struct ObjectScoreOptions {
  // An estimated object may stand for a true one if their centres are so near, or their boxes share
  // so much of the smaller one.
  double max_distance_m = 0.5;
  double min_overlap = 0.3;
  double other_class_m = 0.5;  // a match of another class costs so much more distance

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_distance_m", self.max_distance_m, 0.0, 10.0);
    visit("min_overlap", self.min_overlap, 0.01, 1.0);
    visit("other_class_m", self.other_class_m, 0.0, 10.0);
  }
};

// An object that is in the world and in the map. Indices into the two lists.
struct ObjectMatch {
  std::size_t truth = 0;
  std::size_t estimate = 0;
  bool right_class = false;
  // Seen from above: of the position, which is the mean of what was seen of an object, from the
  // true middle, and between the middles of the boxes.
  double position_error_m = 0.0;
  double box_error_m = 0.0;
  double height_error_m = 0.0;  // of the highest point
  double size_error_m = 0.0;    // mean over length and width of the box
};

struct ObjectScore {
  std::size_t expected = 0;          // true objects that the map should hold
  std::vector<ObjectMatch> matches;  // of those, by the true ones' order
  std::vector<std::size_t> missed;   // the rest of them, indices into the true ones
  std::vector<std::size_t> extra;    // estimated objects that are none of the world's

  std::size_t right_class() const;
  ErrorStatistics position_m() const;
  ErrorStatistics box_m() const;
  ErrorStatistics height_m() const;
  ErrorStatistics size_m() const;
};

// Matches objects one to one at the least total distance. All true objects take part, so that one
// that was not expected is no extra one; the score is of those that `is_expected` says.
//
//   truth        in the world frame
//   estimate     in the map frame, which lies at T_world_map
//   is_expected  parallel to `truth`
//
// Throws ConfigError if an option is out of range.
ObjectScore ScoreObjects(const std::vector<MapObject>& truth,
                         const std::vector<MapObject>& estimate, const Rigid3d& T_world_map,
                         const std::vector<bool>& is_expected,
                         const ObjectScoreOptions& options = {});

// The object of a map that lies at T_world_map, in the world frame. What tilt there is between the
// two moves the object, but leaves it upright.
MapObject InWorld(const MapObject& object, const Rigid3d& T_world_map);

}  // namespace semantic_slam
