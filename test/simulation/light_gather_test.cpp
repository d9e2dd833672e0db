#include "semantic_slam/simulation/light_gather.h"

#include <gtest/gtest.h>

#include "simulation/world_builder.h"

namespace semantic_slam {
namespace {

const Eigen::Vector3f kAmbient(0.1f, 0.2f, 0.3f), kUp = Eigen::Vector3f::UnitZ();
const std::vector<Reflectance> kGrey{{Eigen::Vector3f::Constant(0.5f), 0.0f},
                                     {Eigen::Vector3f::Constant(0.5f), 1.0f}};

TEST(LightGatherTest, UnderTheOpenSkyAllAmbientLightArrives) {
  const StillScene nothing{World()};
  const GatheredLight light = LightGatherer(nothing, kGrey, kAmbient).Gather({0, 0, 0}, kUp, 1);
  EXPECT_TRUE(light.irradiance.isApprox(kAmbient, 1e-5f));
  EXPECT_EQ(light.in_the_open, 1.0f);
}

TEST(LightGatherTest, InsideOfASolidNothingIsOpen) {
  WorldBuilder builder;
  builder.Add(3, BoxMesh({0, 0, 0}, {1, 1, 1}));
  const StillScene scene(builder.world());
  const GatheredLight light = LightGatherer(scene, kGrey, kAmbient).Gather({0, 0, 0}, kUp, 1);
  EXPECT_EQ(light.in_the_open, 0.0f);
  EXPECT_EQ(light.irradiance.norm(), 0.0f);
}

TEST(LightGatherTest, LittleAmbientLightComesIntoANarrowGap) {
  WorldBuilder builder;
  builder.Add(3, BoxMesh({0, 0, 1.05f}, {20, 20, 2}));  // 5 cm above
  const StillScene scene(builder.world());
  const GatheredLight light = LightGatherer(scene, kGrey, kAmbient).Gather({0, 0, 0}, kUp, 1);
  EXPECT_LT(light.irradiance[2], 0.2f * kAmbient[2]);
}

TEST(LightGatherTest, ShiningSurfacesGiveLight) {
  WorldBuilder builder;
  const int shining = builder.AddMaterial({"plaster", {255, 255, 255}, 1, {0, 0}, 0.0f, 1.0f});
  builder.Add(3, BoxMesh({0, 0, 2.0f}, {200, 200, 2}), shining);  // fills the whole view
  const StillScene scene(builder.world());
  const GatheredLight light =
      LightGatherer(scene, kGrey, Eigen::Vector3f::Zero()).Gather({0, 0, 0}, kUp, 1);
  // Half of its light, for its colour; a ray of 32 may miss it.
  EXPECT_NEAR(light.irradiance[0], 0.5f * kShiningLight, kShiningLight / 32.0f);
}

}  // namespace
}  // namespace semantic_slam
