#include "semantic_slam/worlds/looks.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr LabelId kChair = 3, kTable = 4;

WorldObject ObjectOf(LabelId label, float size_m, int material) {
  WorldObject object;
  object.label = label;
  object.surfaces.push_back({BoxMesh({0, 0, 0.5f}, {size_m, 1, 1}), material, {}});
  return object;
}

std::vector<int> Looks(std::vector<WorldObject> objects) {
  World world;
  world.objects = std::move(objects);
  return LooksOf(world);
}

TEST(LooksTest, TwinsHaveTheSameWhereverTheyStand) {
  WorldObject turned = ObjectOf(kChair, 1, 0);
  turned.T_world_object = Rigid3d(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));
  turned.name = "chair_2";
  EXPECT_EQ(Looks({ObjectOf(kChair, 1, 0), ObjectOf(kChair, 2, 0), turned}),
            (std::vector<int>{1, 2, 1}));
}

TEST(LooksTest, ShapeMaterialAndLabelTellObjectsApart) {
  WorldObject more = ObjectOf(kChair, 1, 0);
  more.surfaces.push_back(more.surfaces.front());
  EXPECT_EQ(Looks({ObjectOf(kChair, 1, 0), ObjectOf(kChair, 2, 0), ObjectOf(kChair, 1, 1),
                   ObjectOf(kTable, 1, 0), more}),
            (std::vector<int>{1, 2, 3, 4, 5}));
}

TEST(LooksTest, AnEmptyWorldHasNone) {
  EXPECT_TRUE(Looks({}).empty());
}

}  // namespace
}  // namespace semantic_slam
