#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/plane_projection/convex_polygon.h"

namespace semantic_slam {

// Whether there is room below an object's top.
enum class Hollowness : std::uint8_t {
  kNo = 0,      // solid from bottom to top
  kPartly = 1,  // open in parts
  kFull = 2,    // open below its top: a table
};

// What was seen of the space below an object's top: square columns of its footprint.
struct SpaceBelow {
  int free_columns = 0;      // something behind was seen through it
  int occupied_columns = 0;  // a part of the object was seen in it
  int unseen_columns = 0;

  SpaceBelow& operator+=(const SpaceBelow& other);
};

struct HollownessOptions {
  double column_m = 0.05;         // side of a column
  double clearance_m = 0.08;      // below the top, that the top's own thickness may take
  double min_room_m = 0.25;       // from the top down to what is seen below, for there to be room
  double min_seen_share = 0.2;    // of the columns, to judge by what was seen
  double full_share = 0.75;       // of the seen columns that are free under a table
  double partly_share = 0.25;     // the same under something that is open in parts
  double unexpected_share = 0.9;  // the same where the class is not known to be hollow

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("column_m", self.column_m, 0.005, 1.0);
    visit("clearance_m", self.clearance_m, 0.0, 1.0);
    visit("min_room_m", self.min_room_m, 0.0, 10.0);
    visit("min_seen_share", self.min_seen_share, 0.0, 1.0);
    visit("full_share", self.full_share, 0.0, 1.0);
    visit("partly_share", self.partly_share, 0.0, self.full_share);
    visit("unexpected_share", self.unexpected_share, 0.0, 1.0);
  }
};

// One depth reading: the straight line from the camera to where it ends.
struct Sight {
  Eigen::Vector3f end_m;
  bool on_object = false;  // it ends on the object that is looked at
};

// Follows the lines of sight through the columns below `top_height_m`, all in one frame with z up.
// Nothing is counted if nothing was seen at least `min_room_m` below the top: under a cup there is
// its table.
SpaceBelow LookBelow(const ConvexPolygon& outline_m, double top_height_m,
                     const Eigen::Vector3f& eye_m, const std::vector<Sight>& sights,
                     const HollownessOptions& options);

// Classes that are known to be hollow are as open as they were seen to be: kFull, kPartly or kNo by
// the share of seen columns that are free, and kPartly as long as too little was seen. Of other
// classes it takes more to believe it, and no more than kPartly: below a screen on its foot it is
// free too.
Hollowness JudgeHollowness(const SpaceBelow& below, bool class_is_hollow,
                           const HollownessOptions& options);

}  // namespace semantic_slam
