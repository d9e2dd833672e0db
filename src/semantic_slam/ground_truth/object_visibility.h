#pragma once

#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/ground_truth/surface_labels.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// When an object counts as seen in an image: a share of its surface is in the image, within the
// depth camera's range, and nothing stands before it.
struct VisibilityOptions {
  double min_depth_m = 0.4;
  double max_depth_m = 4.0;
  double min_share = 0.3;  // of the object's surface, its back included
  double period_s = 0.5;   // between the poses that are looked from

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("min_depth_m", self.min_depth_m, 0.0, self.max_depth_m);
    visit("max_depth_m", self.max_depth_m, 0.1, 100.0);
    visit("min_share", self.min_share, 0.01, 1.0);
    visit("period_s", self.period_s, 0.0, 3600.0);
  }
};

// For each of the world's objects, in their order, how many poses it is seen from; 0 for those that
// move. What is behind the object's own front counts as seen, what moves stands before nothing.
//
//   T_world_camera  of the optical frame
std::vector<int> CountViews(const World& world, const SurfaceLabels& surfaces,
                            const Trajectory& T_world_camera, const CameraModel& camera,
                            const VisibilityOptions& options);

}  // namespace semantic_slam
