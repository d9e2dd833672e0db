#pragma once

#include "semantic_slam/common/options.h"

namespace semantic_slam {

struct TrackerOptions {
  double depth_sigma_at_1m_m = 0.02;  // of the depth sensor; grows with depth squared
  double max_point_depth_m =
      4.0;                       // features farther away become map points only where few are near
  int min_initial_points = 100;  // features with depth that a new map needs
  int min_inliers = 15;          // fewer, and the camera counts as lost
  int min_relocalization_inliers = 30;
  int relocalization_keyframes = 20;  // tried per lost image: half that look like it, half by turns
  double search_radius_px = 15.0;     // about the predicted pixel; doubled at the second try
  int max_local_keyframes = 60;       // whose points are looked for in each image
  int max_keyframe_gap = 30;          // images after which a keyframe is wanted anyhow
  double min_tracked_ratio = 0.6;  // a keyframe is wanted when an image shows less than this share
                                   // of the map points that were seen right after the last keyframe
  double new_map_after_s = 1.0;    // lost in sight of enough features for so long, a new map begins
  int max_dormant_keyframes = 2000;  // of maps that were lost and not found again
  int min_new_points =
      100;  // nearest features per keyframe that become points whatever their depth

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("depth_sigma_at_1m_m", self.depth_sigma_at_1m_m, 1e-4, 1.0);
    visit("max_point_depth_m", self.max_point_depth_m, 0.5, 100.0);
    visit("min_initial_points", self.min_initial_points, 20, 10000);
    visit("min_inliers", self.min_inliers, 6, 1000);
    visit("min_relocalization_inliers", self.min_relocalization_inliers, 6, 1000);
    visit("relocalization_keyframes", self.relocalization_keyframes, 1, 1000);
    visit("search_radius_px", self.search_radius_px, 2.0, 200.0);
    visit("max_local_keyframes", self.max_local_keyframes, 1, 1000);
    visit("max_keyframe_gap", self.max_keyframe_gap, 1, 10000);
    visit("min_tracked_ratio", self.min_tracked_ratio, 0.1, 1.0);
    visit("new_map_after_s", self.new_map_after_s, 0.0, 1e6);
    visit("max_dormant_keyframes", self.max_dormant_keyframes, 0, 100000);
    visit("min_new_points", self.min_new_points, 0, 10000);
  }
};

}  // namespace semantic_slam
