#include "semantic_slam/simulation/light_bake.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "simulation/world_builder.h"

namespace semantic_slam {
namespace {

const std::vector<Reflectance> kGrey{{Eigen::Vector3f::Constant(0.5f), 0.0f}};

// Irradiance (green) on the floor, whose top is at z = 0, below the other things of a world.
class LitFloor {
 public:
  explicit LitFloor(const WorldBuilder& builder, float ambient = 0.0f) : scene_(*builder.Build()) {
    const std::shared_ptr<const World> world = builder.Build();
    BakeLight({world->lights.begin(), world->lights.end()}, Eigen::Vector3f::Constant(ambient),
              kGrey, scene_);
  }

  float At(float x_m, float y_m) const { return PointAt(x_m, y_m).irradiance[1]; }

  const SceneTriangle& TriangleAt(float x_m, float y_m) const {
    return *PointAt(x_m, y_m).triangle;
  }

  const StillScene& scene() const { return scene_; }

 private:
  SurfacePoint PointAt(float x_m, float y_m) const {
    RayPacket packet;
    packet.Clear();
    packet.Set(0, {x_m, y_m, 0.3f}, {0, 0, -1});
    scene_.rays().FindHits(packet, false);
    return scene_.PointAt(packet, 0, {x_m, y_m, 0}, {0, 0, -1});
  }

  StillScene scene_;
};

WorldBuilder RoomWithTable() {
  WorldBuilder builder;
  builder.AddRoom(1, {-2, -2, 0}, {2, 2, 2.5f});
  builder.Add(4, BoxMesh({0, 0, 0.7f}, {1.2f, 0.8f, 0.04f}));
  builder.AddLight({0, 0, 2.4}, 0.5);
  return builder;
}

TEST(LightBakeTest, ItIsDarkerUnderATableAndSoftAtTheEdgeOfItsShadow) {
  const LitFloor floor(RoomWithTable());
  const float under = floor.At(0, 0), beside = floor.At(1.5f, 0);
  EXPECT_LT(under, 0.5f * beside);
  EXPECT_GT(under, 0.0f) << "what walls throw back comes under a table, too";
  const float edge = floor.At(0.85f, 0);  // where the lamp is half hidden: 0.6 m * 2.4 / 1.68
  EXPECT_GT(edge, under + 0.1f);
  EXPECT_LT(edge, beside);
}

TEST(LightBakeTest, AClosedRoomNextToALitOneStaysDark) {
  WorldBuilder builder = RoomWithTable();
  builder.AddRoom(1, {2.1f, -2, 0}, {4, 2, 2.5f});  // they share a wall
  const LitFloor floor(builder);
  EXPECT_GT(floor.At(1.98f, 1.0f), 0.1f);
  EXPECT_EQ(floor.TriangleAt(1.98f, 1.0f).lamps, OnlyLamp(0));
  EXPECT_EQ(floor.TriangleAt(3.0f, 1.0f).lamps, 0u);
  for (float x_m = 2.11f; x_m < 4.0f; x_m += 0.05f) {
    // 2e-3: what solids hide is relied on to a thousandth.
    EXPECT_LT(floor.At(x_m, 1.0f), 2e-3f) << x_m;
  }
}

TEST(LightBakeTest, LightFromEverywhereIsLessInCorners) {
  WorldBuilder builder;
  builder.AddRoom(1, {-2, -2, 0}, {2, 2, 2.5f});
  const LitFloor floor(builder, 0.3f);
  EXPECT_NEAR(floor.At(0, 0), 0.3f, 0.01f);
  EXPECT_LT(floor.At(-1.97f, -1.97f), 0.25f);
  EXPECT_GT(floor.At(-1.97f, -1.97f), 0.02f) << "no black rim";
}

TEST(LightBakeTest, WhatStandsOnTheFloorLeavesNoDarkRimAroundIt) {
  WorldBuilder builder;
  builder.AddRoom(1, {-2, -2, 0}, {2, 2, 2.5f});
  builder.Add(3, BoxMesh({0, 0, 0.01f}, {1, 1, 0.02f}));  // a mat
  builder.AddLight({0, 0, 2.4}, 0.5);
  const LitFloor floor(builder);
  EXPECT_GT(floor.At(0.505f, 0.1f), 0.85f * floor.At(0.7f, 0.1f));
}

TEST(LightBakeTest, IsTheSameOnOneCoreAndTwo) {
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const LitFloor one(RoomWithTable(), 0.1f);
  cv::setNumThreads(2);
  const LitFloor two(RoomWithTable(), 0.1f);
  cv::setNumThreads(threads);
  for (std::size_t i = 0; i < one.scene().grids().size(); ++i) {
    EXPECT_EQ(one.scene().grids()[i].samples(), two.scene().grids()[i].samples());
  }
}

TEST(LightBakeTest, ThereMayBeNothingToLight) {
  StillScene scene{World()};
  BakeLight({}, Eigen::Vector3f::Zero(), {}, scene);
  EXPECT_TRUE(scene.sites().empty());
}

}  // namespace
}  // namespace semantic_slam
