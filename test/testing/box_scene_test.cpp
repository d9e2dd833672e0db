#include "testing/box_scene.h"

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

TEST(BoxSceneTest, DepthIsWhereTheCrateIs) {
  BoxScene scene;
  const int crate = scene.AddCrate({2.0, 0.0}, {0.4, 0.4, 0.4}, 0.0);
  const Rigid3d T_world_camera = LookAt({0.0, 0.0, 0.2}, {2.0, 0.0, 0.2});
  const auto view = scene.Render(T_world_camera, *SmallCamera(), Stamp{1});
  // The centre of the image is between four pixels, all on the crate's front; floats of 1.8.
  EXPECT_NEAR(view.image.depth_m.at<float>(120, 160), 1.8, 1e-5);
  EXPECT_NEAR(view.image.depth_m.at<float>(10, 10), 4.0, 1e-5);  // the wall
  const cv::Rect2f box = BoxScene::VisibleBox(view, crate);
  const double half_px = 0.2 / 1.8 * 260.0;
  EXPECT_NEAR(box.x, 159.5 - half_px, 1.0);  // whole pixels
  EXPECT_NEAR(box.x + box.width, 159.5 + half_px, 1.0);
  EXPECT_TRUE(BoxScene::VisibleBox(view, crate + 1).empty());
}

TEST(BoxSceneTest, UnderATableOneSeesTheFloor) {
  BoxScene scene;
  const int table = scene.AddTable({2.0, 0.0}, {0.8, 1.2, 0.75}, 0.0);
  const auto view =
      scene.Render(LookAt({0.0, 0.0, 1.2}, {2.0, 0.0, 0.4}), *SmallCamera(), Stamp{1});
  const cv::Rect2f box = BoxScene::VisibleBox(view, table);
  const cv::Mat inside = view.objects(cv::Rect(box));
  const int on_table = cv::countNonZero(inside == table + 1);
  EXPECT_GT(on_table, 0.2 * inside.total());
  EXPECT_LT(on_table, 0.8 * inside.total());
}

TEST(LookAtTest, TheTargetIsInTheMiddleAndUpIsUp) {
  const Rigid3d T = LookAt({1.0, 2.0, 1.5}, {3.0, 1.0, 0.5});
  const Eigen::Vector3d target = T.inverse() * Eigen::Vector3d(3.0, 1.0, 0.5);
  EXPECT_NEAR(target.head<2>().norm(), 0.0, 1e-12);
  EXPECT_GT(target.z(), 0.0);
  EXPECT_NEAR(T.linear().determinant(), 1.0, 1e-12);
  EXPECT_LT(T.linear()(2, 1), 0.0);  // the image's y axis points down
}

}  // namespace
}  // namespace semantic_slam
