#include "semantic_slam/object_mapping/object_geometry.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "semantic_slam/object_mapping/object_shape.h"
#include "testing/box_scene.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr KeyframeId kKeyframe = 7;

// What one view shows of an object, with a keyframe somewhere else than the camera.
std::optional<ObjectObservation> Observe(const BoxScene& scene, int object,
                                         const Rigid3d& T_map_camera,
                                         const Rigid3d& T_map_keyframe) {
  const auto view = scene.Render(T_map_camera, *SmallCamera(), Stamp{1});
  const auto points =
      ExtractObjectPoints(BoxScene::VisibleBox(view, object), view.image, *SmallCamera(), {});
  if (!points) return std::nullopt;
  return MeasureObject(*points, T_map_camera.linear(), kKeyframe,
                       T_map_keyframe.inverse() * T_map_camera, {}, {});
}

std::optional<ObjectShape> ShapeOf(const std::optional<ObjectObservation>& observation,
                                   const Rigid3d& T_map_keyframe) {
  if (!observation) return std::nullopt;
  return FuseObservations({*observation}, [&](KeyframeId) { return T_map_keyframe; });
}

const Rigid3d T_map_keyframe = LookAt({0.5, -1.0, 1.6}, {3.0, 1.0, 0.3});

TEST(ObjectGeometryTest, ATableIsItsTopAndHollowBelow) {
  BoxScene scene;
  const int table = scene.AddTable({2.6, 0.3}, {0.8, 1.2, 0.75}, 0.4);
  const auto observation =
      Observe(scene, table, LookAt({0.4, 0.0, 1.3}, {2.6, 0.3, 0.4}), T_map_keyframe);
  ASSERT_TRUE(observation);
  EXPECT_EQ(observation->keyframe_id, kKeyframe);
  EXPECT_TRUE(observation->complete);
  const auto shape = ShapeOf(observation, T_map_keyframe);
  ASSERT_TRUE(shape);
  // At 2.2 m a pixel is 9 mm across the view, and along it 2 cm of the slanted top: so much may be
  // missing at the edges.
  EXPECT_NEAR(shape->box.size.x(), 1.2, 0.04);
  EXPECT_NEAR(shape->box.size.y(), 0.8, 0.04);
  EXPECT_NEAR((shape->box.centre - Eigen::Vector2d(2.6, 0.3)).norm(), 0.0, 0.03);
  EXPECT_NEAR(Area(shape->outline_m), 0.96, 0.06);
  EXPECT_NEAR(shape->max_height_m, 0.75, 0.005);
  EXPECT_LT(shape->min_height_m, 0.1);  // a foot; the floor's plane takes the lowest centimetres
  EXPECT_EQ(JudgeHollowness(shape->below, true, {}), Hollowness::kFull);
}

TEST(ObjectGeometryTest, ACrateIsSolid) {
  BoxScene scene;
  const int crate = scene.AddCrate({2.6, 0.3}, {0.5, 0.5, 0.6}, 0.2);
  const auto shape =
      ShapeOf(Observe(scene, crate, LookAt({0.4, 0.0, 1.3}, {2.6, 0.3, 0.3}), T_map_keyframe),
              T_map_keyframe);
  ASSERT_TRUE(shape);
  EXPECT_NEAR(Area(shape->outline_m), 0.25, 0.02);  // its top, as for the table
  EXPECT_NEAR(shape->max_height_m, 0.6, 0.005);
  EXPECT_EQ(JudgeHollowness(shape->below, false, {}), Hollowness::kNo);
}

TEST(ObjectGeometryTest, AChairsFootprintIsItsSeat) {
  BoxScene scene;
  const int chair = scene.AddChair({2.2, 0.0}, 2.6);  // its back away from the camera
  const auto shape =
      ShapeOf(Observe(scene, chair, LookAt({0.4, 0.0, 1.2}, {2.2, 0.0, 0.4}), T_map_keyframe),
              T_map_keyframe);
  ASSERT_TRUE(shape);
  EXPECT_NEAR(shape->max_height_m, 0.9, 0.01);
  EXPECT_NEAR(Area(shape->outline_m), 0.45 * 0.45, 0.03);  // 2 cm at one edge, 5 cm at the other
  EXPECT_NE(JudgeHollowness(shape->below, true, {}), Hollowness::kNo);
}

TEST(ObjectGeometryTest, TheCentreIsTheMeanOfThePointsAndNoBetterThanItsCovariance) {
  BoxScene scene;
  const int crate = scene.AddCrate({2.6, 0.3}, {0.4, 0.4, 0.4}, 0.2);
  const auto observation =
      Observe(scene, crate, LookAt({0.4, 0.0, 1.3}, {2.6, 0.3, 0.2}), T_map_keyframe);
  ASSERT_TRUE(observation);
  const Eigen::Vector3d error =
      T_map_keyframe * observation->centre - Eigen::Vector3d(2.6, 0.3, 0.2);
  EXPECT_LT(error.norm(), 0.2);  // the near sides of it: no farther from the middle than they are
  const Eigen::Matrix3d R = T_map_keyframe.linear();
  const Eigen::Matrix3d covariance = R * observation->covariance_m2 * R.transpose();
  EXPECT_LT(error.dot(covariance.inverse() * error), 16.0);  // four sigma
}

TEST(ObjectGeometryTest, WithoutAreaThereIsNothing) {
  ObjectPoints line;
  for (int i = 0; i < 100; ++i) line.object.emplace_back(0.0f, 0.01f * i, 2.0f);
  EXPECT_FALSE(
      MeasureObject(line, LookAt({0, 0, 1}, {1, 0, 1}).linear(), 0, Rigid3d::Identity(), {}, {}));
}

}  // namespace
}  // namespace semantic_slam
