#include "semantic_slam/local_mapping/triangulation.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr KeyframeId kNewest = 2;

// Three views of the room from places far enough apart, of a sensor that measures no depth. Some
// points tie them together.
class TriangulationTest : public testing::Test {
 protected:
  TriangulationTest() : map_(SmallExtractor().scales()) {
    for (int i = 0; i < 3; ++i) {
      const Rigid3d T = HandheldPath::T_world_camera(3.0 + 0.2 * i);
      truth_.push_back(SmallRoomFeatures(T, Stamp{1'000'000'000LL * (i + 1)}));
      map_.AddKeyframe(WithoutDepth(*truth_.back()), T);
    }
    Tie(map_);
  }

  static void Tie(Map& map) {
    for (int feature = 0; feature < 20; ++feature) {
      const PointId id = map.AddPoint({0, 0, 0}, 0, feature).id;
      for (KeyframeId other = 1; other <= kNewest; ++other) map.AddObservation(id, other, feature);
    }
    map.UpdateCovisibility(kNewest);
  }

  static std::shared_ptr<const FrameFeatures> WithoutDepth(const FrameFeatures& measured) {
    std::vector<Feature> features = measured.features();
    for (Feature& feature : features) feature.depth_m = std::numeric_limits<float>::quiet_NaN();
    return std::make_shared<FrameFeatures>(measured.stamp(), features, measured.descriptors(),
                                           *SmallCamera());
  }

  int Triangulate(const TriangulationOptions& options = {}) {
    return TriangulateWithNeighbours(kNewest, options, *SmallCamera(), ObservationNoise(), map_);
  }

  std::vector<std::shared_ptr<const FrameFeatures>> truth_;  // with depth
  Map map_;
};

TEST_F(TriangulationTest, FindsTheDepthThatTheSensorHidesFromIt) {
  const int made = Triangulate();
  EXPECT_GT(made, 40);  // of about 450 features
  const double baseline_m =
      (map_.KeyframePose(kNewest).translation() - map_.KeyframePose(0).translation()).norm();
  int measured = 0, right = 0;
  map_.ForEachPoint([&](const MapPoint& point) {
    if (point.reference != kNewest) return;  // one of those that tie the views
    ASSERT_EQ(point.observations.size(), 3u);
    const Feature& feature = (*truth_[kNewest])[point.observations[kNewest].feature];
    if (!feature.has_depth()) return;
    const double z = (map_.KeyframePose(kNewest).inverse() * point.position).z();
    const double disparity_px =
        SmallCamera()->intrinsics().fx_px * baseline_m * std::abs(1.0 / z - 1.0 / feature.depth_m);
    ++measured;
    // Two pixels that may each be a pixel off, of their level.
    right += disparity_px < 2.0 * map_.scales()[feature.octave];
  });
  EXPECT_GT(measured, 30);
  EXPECT_GT(right, 0.9 * measured);  // a few are at edges, where depth is another thing's
}

TEST_F(TriangulationTest, WhatMovesIsLeftOut) {
  Keyframe& keyframe = *map_.FindKeyframe(kNewest);
  keyframe.left_out.assign(keyframe.points.size(), true);
  EXPECT_EQ(Triangulate(), 0);
}

TEST_F(TriangulationTest, WithoutParallaxNothingIsSaid) {
  for (const KeyframeId id : {1, 2}) {
    map_.FindKeyframe(id)->T_map_camera.translation() = map_.KeyframePose(0).translation();
  }
  EXPECT_EQ(Triangulate(), 0);
}

TEST_F(TriangulationTest, PointsLieNowhereThatEitherViewContradicts) {
  Triangulate();
  map_.ForEachPoint([&](const MapPoint& point) {
    if (point.reference != kNewest) return;
    for (const Observation& o : point.observations) {
      const Keyframe& keyframe = *map_.FindKeyframe(o.keyframe);
      const Feature& feature = (*keyframe.features)[o.feature];
      const Eigen::Vector3d p = keyframe.T_map_camera.inverse() * point.position;
      ASSERT_GT(p.z(), 0.0);
      const double off_px = (SmallCamera()->Project(p) - feature.pixel.cast<double>()).norm();
      EXPECT_LT(off_px, 2.45 * map_.scales()[feature.octave]);  // sqrt(kChi2Pixel)
    }
  });
}

TEST_F(TriangulationTest, MeasuredDepthThatDisagreesIsBelieved) {
  const int without = Triangulate();
  Map other(map_.scales());
  for (int i = 0; i < 3; ++i) {
    std::vector<Feature> features = truth_[i]->features();
    for (Feature& feature : features) feature.depth_m = 20.0f;  // farther than the room is long
    other.AddKeyframe(std::make_shared<FrameFeatures>(truth_[i]->stamp(), features,
                                                      truth_[i]->descriptors(), *SmallCamera()),
                      map_.KeyframePose(i));
  }
  Tie(other);
  EXPECT_LT(TriangulateWithNeighbours(kNewest, {}, *SmallCamera(), ObservationNoise(), other),
            without / 4);
}

TEST_F(TriangulationTest, TwoViewsAreNotEnough) {
  Keyframe& third = *map_.FindKeyframe(0);
  third.left_out.assign(third.points.size(), true);
  EXPECT_EQ(Triangulate(), 0);
}

TEST_F(TriangulationTest, NoNeighboursNoPoints) {
  TriangulationOptions options;
  options.neighbours = 0;
  EXPECT_EQ(Triangulate(options), 0);
}

}  // namespace
}  // namespace semantic_slam
