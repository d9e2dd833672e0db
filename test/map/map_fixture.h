#pragma once

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/map/map.h"
#include "testing/small_room.h"

namespace semantic_slam {

inline Rigid3d At(double x_m, double y_m, double z_m) {
  return Rigid3d(Eigen::Translation3d(x_m, y_m, z_m));
}

// Two frames of different content; the tests refer to features by number.
inline const std::shared_ptr<const FrameFeatures>& FrameA() {
  static const auto kFrame = SquaresFeatures(1);
  return kFrame;
}
inline const std::shared_ptr<const FrameFeatures>& FrameB() {
  static const auto kFrame = SquaresFeatures(2);
  return kFrame;
}

class MapTest : public testing::Test {
 protected:
  KeyframeId AddKeyframe(const Rigid3d& T_map_camera = Rigid3d::Identity()) {
    return map_.AddKeyframe(FrameA(), T_map_camera).id;
  }

  // A point that all the keyframes see as feature `feature`.
  PointId AddSharedPoint(const std::vector<KeyframeId>& keyframes, int feature) {
    const PointId id = map_.AddPoint({0.0, 0.0, 2.0}, keyframes.front(), feature).id;
    for (std::size_t i = 1; i < keyframes.size(); ++i) {
      map_.AddObservation(id, keyframes[i], feature);
    }
    return id;
  }

  void AddSharedPoints(const std::vector<KeyframeId>& keyframes, int first_feature, int count) {
    for (int i = 0; i < count; ++i) AddSharedPoint(keyframes, first_feature + i);
  }

  Map map_{SmallExtractor().scales()};
};

}  // namespace semantic_slam
