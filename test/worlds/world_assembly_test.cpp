#include "semantic_slam/worlds/world_assembly.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam {
namespace {

Rigid3d At(double x, double y, double z = 0.0) {
  return Rigid3d(Eigen::Translation3d(x, y, z));
}

TEST(WorldAssemblyTest, NumbersObjectsInTheirOrder) {
  WorldAssembly assembly("test", SmallVocabulary());
  assembly.Add("a", MakeFurniture("table"), At(1, 0));
  assembly.Add("b", MakeFurniture("chair"), At(2, 0));
  const World world = assembly.Finish();
  EXPECT_EQ(world.name, "test");
  EXPECT_EQ(world.vocabulary_hash, SmallVocabulary().hash());
  ASSERT_EQ(world.objects.size(), 2u);
  EXPECT_EQ(world.objects[0].instance, 1);
  EXPECT_EQ(world.objects[1].instance, 2);
  EXPECT_EQ(world.objects[1].name, "b");
  EXPECT_EQ(world.objects[1].label, 3);
  EXPECT_FALSE(world.objects[1].is_structure);
  EXPECT_TRUE(world.objects[1].T_world_object.isApprox(At(2, 0)));
}

TEST(WorldAssemblyTest, EqualMaterialsAreThereOnce) {
  WorldAssembly assembly("test", SmallVocabulary());
  assembly.Add("a", MakeFurniture("chair"), At(0, 0));
  const std::size_t of_one = assembly.Finish().materials.size();
  assembly.Add("b", MakeFurniture("chair"), At(1, 0));
  EXPECT_EQ(assembly.Finish().materials.size(), of_one);
  FurnitureRequest red;
  red.materials["seat"] = MakeMaterial("fabric", {255, 0, 0});
  assembly.Add("c", MakeFurniture("chair", red), At(2, 0));
  EXPECT_EQ(assembly.Finish().materials.size(), of_one + 1);
}

TEST(WorldAssemblyTest, RoomsAreStructure) {
  Building building(0.1);
  Room room;
  room.name = "hall";
  room.area_m = {Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 3)};
  building.AddRoom(room);
  const std::vector<LabelClass> classes{
      {0, "unknown", {}}, {1, "wall", {}}, {2, "floor", {}}, {22, "ceiling", {}}};
  WorldAssembly assembly("test", LabelVocabulary(classes));
  assembly.AddBuilding(building);
  const World world = assembly.Finish();
  ASSERT_EQ(world.objects.size(), 3u);
  EXPECT_EQ(world.objects[0].name, "hall/floor");
  EXPECT_EQ(world.objects[0].label, 2);
  for (const WorldObject& object : world.objects) EXPECT_TRUE(object.is_structure);
  EXPECT_NEAR(world.bounds_m.max().z(), 2.7, 1e-6);
}

TEST(WorldAssemblyTest, LampsShineWhereTheyHang) {
  WorldAssembly assembly("test", SmallVocabulary());
  assembly.Add("lamp", MakeFurniture("ceiling_lamp"), At(3, 4, 2.4));
  const World world = assembly.Finish();
  ASSERT_EQ(world.lights.size(), 1u);
  EXPECT_NEAR(world.lights[0].centre_m.x(), 3.0, 1e-9);
  EXPECT_LT(world.lights[0].centre_m.z(), 2.4);
}

TEST(WorldAssemblyTest, BoundsLeaveOutWhatWalks) {
  WorldAssembly assembly("test", SmallVocabulary());
  assembly.Add("table", MakeFurniture("table"), At(0, 0));
  assembly.Add("walker", MakeFurniture("chair"), At(0, 0), Walk({{50, 0}, {60, 0}}, 1.0));
  const World world = assembly.Finish();
  EXPECT_LT(world.bounds_m.max().x(), 1.0);
  EXPECT_TRUE(world.objects[1].IsMoving());
  EXPECT_NEAR(world.objects[1].Pose(2.0).translation().x(), 52.0, 1e-9);
}

TEST(WorldAssemblyTest, FindsNames) {
  WorldAssembly assembly("test", SmallVocabulary());
  EXPECT_EQ(assembly.FreeName("chair"), "chair_1");
  assembly.Add("chair_1", MakeFurniture("chair"), At(0, 0));
  EXPECT_EQ(assembly.FreeName("chair"), "chair_2");
  EXPECT_NE(assembly.Find("chair_1"), nullptr);
  EXPECT_EQ(assembly.Find("chair_2"), nullptr);
}

TEST(WorldAssemblyTest, RefusesByName) {
  WorldAssembly assembly("test", SmallVocabulary());
  assembly.Add("a", MakeFurniture("chair"), At(0, 0));
  EXPECT_EQ(MessageOf<ConfigError>([&] { assembly.Add("a", MakeFurniture("chair"), At(1, 0)); }),
            "two things are called a");
  EXPECT_EQ(MessageOf<ConfigError>([&] { assembly.Add("b", MakeFurniture("sofa"), At(1, 0)); }),
            "the vocabulary has no label sofa");
}

TEST(WorldAssemblyTest, TopOfATable) {
  WorldAssembly assembly("test", SmallVocabulary());
  const WorldObject& table = assembly.Add("table", MakeFurniture("table"), At(5, 5));
  EXPECT_NEAR(TopAt(table, {0, 0}).value(), 0.75, 1e-6);
  EXPECT_FALSE(TopAt(table, {3, 0}).has_value());
}

}  // namespace
}  // namespace semantic_slam
