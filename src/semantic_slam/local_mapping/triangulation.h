#pragma once

#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

struct TriangulationOptions {
  int neighbours = 5;             // keyframes with which the new one is compared; 0: none
  double min_parallax_deg = 1.0;  // between the rays to a point; with less its depth is not known

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("neighbours", self.neighbours, 0, 100);
    visit("min_parallax_deg", self.min_parallax_deg, 0.1, 90.0);
  }
};

// Makes map points of what the depth sensor does not measure, or only roughly: features that show
// no point yet in the new keyframe and in one of those that share most points with it, look alike,
// lie on each other's epipolar lines, and whose rays meet where both pixels, the pyramid's levels
// and depth, where there is any, say so (Mur-Artal et al., ORB-SLAM, 2015, section VI.C). A third
// keyframe must show the point too: two views alone agree on what moves along an epipolar line, and
// on edges that are another one's in each view. Features on what moves are left out. Returns how
// many points were made. Precondition: the keyframe exists, options are valid.
int TriangulateWithNeighbours(KeyframeId keyframe, const TriangulationOptions& options,
                              const CameraModel& camera, const ObservationNoise& noise, Map& map);

}  // namespace semantic_slam
