#include "semantic_slam/object_mapping/object_points.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "testing/box_scene.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A crate of 40 cm on the floor, a metre before the wall.
class ObjectPointsTest : public testing::Test {
 protected:
  ObjectPointsTest() { crate_ = scene_.AddCrate({2.8, 0.0}, {0.4, 0.4, 0.4}, 0.3); }

  BoxScene::View Look(const Rigid3d& T_world_camera) {
    return scene_.Render(T_world_camera, *SmallCamera(), Stamp{1});
  }

  BoxScene scene_;
  int crate_;
  const Rigid3d T_world_camera_ = LookAt({1.0, 0.2, 1.0}, {2.8, 0.0, 0.2});
};

// Height over the floor and distance from the crate's middle are those of the crate.
void ExpectOnCrate(const ObjectPoints& points, const Rigid3d& T_world_camera) {
  for (const Eigen::Vector3f& p_camera : points.object) {
    const Eigen::Vector3d p = T_world_camera * p_camera.cast<double>();
    EXPECT_GE(p.z(), -1e-4);
    EXPECT_LE(p.z(), 0.4001);
    EXPECT_LE((p.head<2>() - Eigen::Vector2d(2.8, 0.0)).norm(), 0.2 * std::sqrt(2.0) + 1e-4);
  }
}

TEST_F(ObjectPointsTest, FloorAndWallAreLeftOut) {
  const auto view = Look(T_world_camera_);
  const auto points =
      ExtractObjectPoints(BoxScene::VisibleBox(view, crate_), view.image, *SmallCamera(), {});
  ASSERT_TRUE(points);
  EXPECT_TRUE(points->complete);
  EXPECT_GT(points->object.size(), 500u);
  ExpectOnCrate(*points, T_world_camera_);
}

TEST_F(ObjectPointsTest, ALooseBoxFindsTheSameObject) {
  const auto view = Look(T_world_camera_);
  cv::Rect2f box = BoxScene::VisibleBox(view, crate_);
  box = {box.x - 8, box.y - 8, box.width + 16, box.height + 16};
  const auto points = ExtractObjectPoints(box, view.image, *SmallCamera(), {});
  ASSERT_TRUE(points);
  ExpectOnCrate(*points, T_world_camera_);
}

TEST_F(ObjectPointsTest, ACupIsToldFromItsTable) {
  scene_.AddTable({1.0, 2.0}, {0.8, 1.2, 0.75}, 0.0);
  const int cup = scene_.AddCrate({1.0, 2.0}, {0.08, 0.08, 0.1}, 0.0, 0.75);
  const Rigid3d T_world_camera = LookAt({0.0, 2.0, 1.2}, {1.0, 2.0, 0.8});
  const auto view = Look(T_world_camera);
  const auto points =
      ExtractObjectPoints(BoxScene::VisibleBox(view, cup), view.image, *SmallCamera(), {});
  ASSERT_TRUE(points);
  for (const Eigen::Vector3f& p : points->object) {
    // Within the tolerance to the table's plane, 1.4 cm at this distance, readings may go either
    // way.
    EXPECT_GT((T_world_camera * p.cast<double>()).z(), 0.75);
  }
}

TEST_F(ObjectPointsTest, AFlatThingIsNotTakenAwayWithItsTable) {
  scene_.AddTable({1.0, 2.0}, {0.8, 1.2, 0.75}, 0.0);
  const int keyboard = scene_.AddCrate({1.0, 2.0}, {0.15, 0.45, 0.008}, 0.0, 0.75);
  const auto view = Look(LookAt({0.2, 2.0, 1.4}, {1.0, 2.0, 0.75}));
  const auto points =
      ExtractObjectPoints(BoxScene::VisibleBox(view, keyboard), view.image, *SmallCamera(), {});
  ASSERT_TRUE(points);
  EXPECT_GT(points->object.size(), 300u);
}

TEST_F(ObjectPointsTest, ABoxThatReachesTheEdgeIsNotComplete) {
  const auto view = Look(LookAt({1.0, 0.2, 1.0}, {2.8, 1.15, 0.2}));
  const cv::Rect2f box = BoxScene::VisibleBox(view, crate_);
  ASSERT_GT(box.x + box.width, 318.0f);
  const auto points = ExtractObjectPoints(box, view.image, *SmallCamera(), {});
  ASSERT_TRUE(points);
  EXPECT_FALSE(points->complete);
}

TEST_F(ObjectPointsTest, BoxesOffTheImageHaveNoPoints) {
  const auto view = Look(T_world_camera_);
  for (const cv::Rect2f& box :
       {cv::Rect2f(-100, 10, 50, 50), cv::Rect2f(400, 10, 50, 50), cv::Rect2f(10, 300, 50, 50),
        cv::Rect2f(50, 50, 0.2f, 0.2f), cv::Rect2f(-1e38f, -1e38f, 1.0f, 1.0f)}) {
    EXPECT_FALSE(ExtractObjectPoints(box, view.image, *SmallCamera(), {}));
  }
  const cv::Rect2f huge(-3e38f, -3e38f, 3.2e38f, 3.2e38f);
  EXPECT_NO_THROW(ExtractObjectPoints(huge, view.image, *SmallCamera(), {}));
}

TEST_F(ObjectPointsTest, WithoutDepthThereIsNothing) {
  auto view = Look(T_world_camera_);
  const cv::Rect2f box = BoxScene::VisibleBox(view, crate_);
  for (const float nothing : {kNan, 0.0f, -1.0f, std::numeric_limits<float>::infinity(), 50.0f}) {
    view.image.depth_m.setTo(nothing);
    EXPECT_FALSE(ExtractObjectPoints(box, view.image, *SmallCamera(), {}));
  }
}

TEST_F(ObjectPointsTest, WhatDoesNotSpanTheBoxIsNotItsObject) {
  auto view = Look(T_world_camera_);
  const cv::Rect2f box = BoxScene::VisibleBox(view, crate_);
  // A dark front: only the top gives depth.
  cv::Rect front(box);
  front.y += front.height / 3;
  view.image.depth_m(front).setTo(kNan);
  EXPECT_FALSE(ExtractObjectPoints(box, view.image, *SmallCamera(), {}));
}

TEST_F(ObjectPointsTest, TheCostIsBounded) {
  const auto view = Look(T_world_camera_);
  ObjectPointsOptions options;
  options.max_points = 200;
  const auto points = ExtractObjectPoints({0, 0, 320, 240}, view.image, *SmallCamera(), options);
  ASSERT_TRUE(points);
  EXPECT_LE(points->object.size() + points->others.size(), 200u);
}

}  // namespace
}  // namespace semantic_slam
