#include "semantic_slam/worlds/sdf_world.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

World Furnished(const std::vector<std::string>& names) {
  World world;
  world.name = "small home";
  world.materials.resize(1);
  for (const std::string& name : names) {
    WorldObject object;
    object.instance = static_cast<InstanceId>(world.objects.size() + 1);
    object.name = name;
    object.surfaces = {{BoxMesh({0, 0, 0.5f}, {1, 1, 1}), 0, std::nullopt}};
    world.objects.push_back(object);
  }
  return world;
}

std::string Text(const World& world) {
  return SdfText(world, ModelNames(world), std::nullopt);
}

int CountOf(const std::string& text, const std::string& word) {
  int count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(SdfWorldTest, ModelNamesAreValidAndUnique) {
  EXPECT_EQ(ModelNames(Furnished({"chair", "tea & table::1", "chair", "__lamp", ""})),
            (std::vector<std::string>{"chair__1", "tea___table__1", "chair__3", "object__lamp",
                                      "object"}));
}

// The definition: about the fixed x axis by roll, then y by pitch, then z by yaw.
Eigen::Matrix3d FromRollPitchYaw(const Eigen::Vector3d& rpy_rad) {
  return (Eigen::AngleAxisd(rpy_rad.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy_rad.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy_rad.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

TEST(SdfWorldTest, PosesKeepTheirRotation) {
  for (const double pitch : {-M_PI / 2, -1.0, 0.0, 0.3, M_PI / 2}) {
    for (const double yaw : {-3.0, 0.0, 2.0}) {
      for (const double roll : {-2.5, 0.0, 1.0}) {
        Rigid3d T = Rigid3d::Identity();
        T.linear() = FromRollPitchYaw({roll, pitch, yaw});
        T.translation() << 1, -2, 0.5;
        std::istringstream text(SdfPose(T));
        Eigen::Vector3d position_m, rpy_rad;
        for (double& value : position_m) text >> value;
        for (double& value : rpy_rad) text >> value;
        EXPECT_TRUE(position_m.isApprox(T.translation()));
        // Angles are written with six decimals.
        EXPECT_TRUE(FromRollPitchYaw(rpy_rad).isApprox(T.linear(), 1e-5)) << SdfPose(T);
      }
    }
  }
}

TEST(SdfWorldTest, WhatStandsIsAModelThatIsSeenAndRunInto) {
  const std::string text = Text(Furnished({"chair", "table"}));
  EXPECT_EQ(CountOf(text, "<model name="), 2);
  EXPECT_EQ(CountOf(text, "<static>true</static>"), 2);
  EXPECT_EQ(CountOf(text, "<uri>file://meshes/table.obj</uri>"), 2);
  EXPECT_EQ(CountOf(text, "<collision name="), 2);
  EXPECT_NE(text.find("<world name=\"small_home\">"), std::string::npos);
}

TEST(SdfWorldTest, WhoWalksIsAnActorThatComesBack) {
  World world = Furnished({"table", "anna"});
  world.objects[1].walk.emplace(std::vector<Eigen::Vector2d>{{0, 0}, {2, 0}}, 1.0, 1.0);
  const std::string text = Text(world);
  EXPECT_EQ(CountOf(text, "<actor name=\"anna\">"), 1);
  EXPECT_EQ(CountOf(text, "<collision name="), 1);  // the table's
  // 2 m there, half a turn, 2 m back, half a turn: 10.28 s.
  EXPECT_EQ(CountOf(text, "<time>10.283185</time>"), 1);
  EXPECT_EQ(CountOf(text, "<waypoint>"), 53);  // at most 0.2 s apart
  EXPECT_EQ(CountOf(text, "<pose>0.000000 0.000000 0.000000 0.000000 0.000000 0.000000</pose>"),
            1 + 2);  // the table's, the first and the last of the walk
}

TEST(SdfWorldTest, EveryLampShines) {
  World world = Furnished({"table"});
  world.lights.resize(2);
  world.lights[1].centre_m << 1, 2, 2.4;
  world.lights[1].radiant_rgb = {1.5f, 0.5f, 0.25f};
  const std::string text = Text(world);
  EXPECT_EQ(CountOf(text, "type=\"point\""), 2);
  EXPECT_NE(text.find("<pose>1.000000 2.000000 2.400000 "), std::string::npos);
  EXPECT_NE(text.find("<diffuse>1.000000 0.500000 0.250000 1.000000</diffuse>"), std::string::npos);
}

TEST(SdfWorldTest, TheDroneStandsWhereItIsToldTo) {
  SdfDrone drone{"model://drone", Rigid3d(Eigen::Translation3d(1, 2, 1.5))};
  const World world = Furnished({"table"});
  const std::string text = SdfText(world, ModelNames(world), drone);
  EXPECT_EQ(CountOf(text, "<uri>model://drone</uri>"), 1);
  EXPECT_EQ(CountOf(text, "<pose>1.000000 2.000000 1.500000 "), 1);
}

TEST(SdfWorldTest, SameWorldSameBytes) {
  const World world = Furnished({"a", "b", "c"});
  EXPECT_EQ(Text(world), Text(world));
}

}  // namespace
}  // namespace semantic_slam
