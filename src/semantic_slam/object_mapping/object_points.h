#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"

namespace semantic_slam {

struct ObjectPointsOptions {
  int max_points = 2000;         // read per box: of larger boxes some rows and columns only
  int min_points = 30;           // an object with fewer is none
  double max_depth_m = 5.0;      // farther readings are too noisy
  double cluster_gap_m = 0.05;   // points farther apart do not belong together, thesis eq. (3.22)
  double surround_share = 0.15;  // of a box's size: how far around it background is looked for
  double min_plane_share = 0.3;  // of the surroundings' points, that make a plane background
  double plane_tolerance_m = 0.01;     // points nearer to such a plane are on it
  double depth_noise_per_m2 = 0.003;   // added to the tolerance, times depth squared [m^2]
  double min_foreground_share = 0.25;  // of a box's points: never take more away as background
  double max_depth_to_size = 1.5;      // an object is no deeper than this times its width or height
  double min_extent_share = 0.6;       // of a box's width and height, that its object must span
  int border_px = 3;                   // a box this near to the image's edge may be cut off

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_points", self.max_points, 100, 1000000);
    visit("min_points", self.min_points, 4, 1000000);
    visit("max_depth_m", self.max_depth_m, 0.1, 100.0);
    visit("cluster_gap_m", self.cluster_gap_m, 0.001, 10.0);
    visit("surround_share", self.surround_share, 0.0, 2.0);
    visit("min_plane_share", self.min_plane_share, 0.01, 1.0);
    visit("plane_tolerance_m", self.plane_tolerance_m, 1e-4, 1.0);
    visit("depth_noise_per_m2", self.depth_noise_per_m2, 0.0, 1.0);
    visit("min_foreground_share", self.min_foreground_share, 0.0, 1.0);
    visit("max_depth_to_size", self.max_depth_to_size, 0.1, 100.0);
    visit("min_extent_share", self.min_extent_share, 0.0, 1.0);
    visit("border_px", self.border_px, 0, 1000);
  }
};

// The depth readings in an object's box, in the optical frame [m].
struct ObjectPoints {
  std::vector<Eigen::Vector3f> object;
  std::vector<Eigen::Vector3f> others;  // background, what stands before it, specks
  bool complete = true;  // the box does not touch the image's edge, so the object is all in view
};

// Finds an object's points in its box, thesis section 3.4.1:
//
// 1. Readings in the box, from a grid of pixels, and some around it.
// 2. Background removal. What goes on around the box is not the object: up to three planes that
// hold
//    most of the surroundings (the floor, a wall, the desk that a cup stands on) are taken out of
//    the box, unless too little would be left (a keyboard lies too flat on its desk to be told
//    apart). Then what is far behind the nearest surface in the middle of the box.
// 3. Euclidean clustering, eq. (3.22); the largest cluster is the object.
//
// The part of the box outside of the image is left out. nullopt if too few points are left.
// Stateless. Precondition: image and camera fit, see CheckRgbdImage(); the box is finite.
std::optional<ObjectPoints> ExtractObjectPoints(const cv::Rect2f& box, const RgbdImage& image,
                                                const CameraModel& camera,
                                                const ObjectPointsOptions& options);

}  // namespace semantic_slam
