#pragma once

#include "semantic_slam/common/options.h"
#include "semantic_slam/scan/scan_builder.h"
#include "semantic_slam/scan_matching/scan_inserter.h"
#include "semantic_slam/scan_matching/scan_matcher.h"
#include "semantic_slam/submaps/active_submaps.h"

namespace semantic_slam {

struct GridMapperOptions {
  double min_motion_m = 0.05;  // a scan counts if the camera moved so far since the last one,
  double min_turn_deg = 2.0;   // or turned so far
  // Whether scans are matched to the submaps before they are entered. Tracking's poses are better
  // than what a narrow scan tells, so the default is not to; see docs/pipeline.md.
  bool match_scans = false;
  double follow_threshold_m = 0.02;  // corrections of the keyframes that move no wall farther wait
  int max_submaps = 200;             // beyond, the one that would be missed least is forgotten
  double max_distance_m = 100.0;     // from the map's origin; scans from beyond are left out

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("min_motion_m", self.min_motion_m, 0.0, 10.0);
    visit("min_turn_deg", self.min_turn_deg, 0.0, 360.0);
    visit("match_scans", self.match_scans);
    visit("follow_threshold_m", self.follow_threshold_m, 0.0, 10.0);
    visit("max_submaps", self.max_submaps, 3, 100000);
    visit("max_distance_m", self.max_distance_m, 1.0, 1000.0);
  }
};

// The options of every stage from the depth image to the map, in the groups that configuration
// files use.
struct GridSlamOptions {
  ScanBuilderOptions scan;
  ScanInserterOptions scan_inserter;
  ScanMatcherOptions scan_matcher;
  CorrelativeMatcherOptions correlative_matcher;
  CeresMatcherOptions ceres_matcher;
  SubmapsOptions submaps;
  GridMapperOptions grid_mapper;

  // Calls visit_group(name, group) for each.
  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("scan", self.scan);
    visit_group("scan_inserter", self.scan_inserter);
    visit_group("scan_matcher", self.scan_matcher);
    visit_group("correlative_matcher", self.correlative_matcher);
    visit_group("ceres_matcher", self.ceres_matcher);
    visit_group("submaps", self.submaps);
    visit_group("grid_mapper", self.grid_mapper);
  }
};

}  // namespace semantic_slam
