#include "semantic_slam/simulation/light_grid.h"

#include <gtest/gtest.h>

#include "semantic_slam/simulation/mesh_parts.h"

namespace semantic_slam {
namespace {

// In the plane z = 1, facing up.
Mesh Table() {
  return QuadMesh({0.0f, 0.5f, 1.0f}, {1.0f, 0, 0}, {0, -0.5f, 0});
}

LightSample Grey(float value, float reliance = 1.0f) {
  return reliance * LightSample(value, value, value, 1.0f);
}

TEST(LightGridTest, CoversARectangleEvenly) {
  const LightGrid grid(Table(), 0.1f);
  EXPECT_EQ(std::max(grid.columns(), grid.rows()), 11);
  EXPECT_EQ(std::min(grid.columns(), grid.rows()), 6);
  const std::vector<LightSite> sites = grid.Sites(Table());
  ASSERT_EQ(sites.size(), grid.samples().size());
  for (const LightSite& site : sites) {
    EXPECT_NEAR(site.normal.z(), 1.0f, 1e-6f);
    EXPECT_NEAR(site.position_m.z(), 1.0f, 1e-6f);
    EXPECT_GE(site.position_m.x(), 0.004f);  // a little inside of the rim
    EXPECT_LE(site.position_m.x(), 0.996f);
  }
}

TEST(LightGridTest, InterpolatesBetweenSamples) {
  LightGrid grid(Table(), 0.1f);
  const std::vector<LightSite> sites = grid.Sites(Table());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    grid.samples()[i] = Grey(sites[i].position_m.x());
  }
  // 0.006: sites at the rim are 5 mm inside of it.
  for (const float x : {0.0f, 0.23f, 0.5f, 0.77f, 1.0f}) {
    EXPECT_NEAR(grid.At({x, 0.21f, 1.0f}).x(), x, 0.006f) << x;
  }
}

TEST(LightGridTest, WhatCannotBeReliedOnDoesNotCount) {
  LightGrid grid(Table(), 0.1f);
  const std::vector<LightSite> sites = grid.Sites(Table());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const bool below_a_wall = sites[i].position_m.x() > 0.55f;
    grid.samples()[i] = below_a_wall ? Grey(0.0f, 1e-3f) : Grey(1.0f);
  }
  // Half way to the dark: its weight is a thousandth.
  EXPECT_NEAR(grid.At({0.55f, 0.25f, 1.0f}).x(), 1.0f, 2e-3f);
  EXPECT_NEAR(grid.At({0.8f, 0.25f, 1.0f}).x(), 0.0f, 1e-6f);
}

TEST(LightGridTest, SitesLieOnADiscAndAllAroundEachOfItsPoints) {
  const float radius_m = 0.4f;
  const std::vector<Mesh> parts =
      ConnectedParts(CylinderMesh({0, 0, 0}, radius_m, radius_m, 1.0f, 32));
  for (const Mesh& part : parts) {
    if (!IsFlat(part)) continue;
    LightGrid grid(part, 0.1f);
    const std::vector<LightSite> sites = grid.Sites(part);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      if (sites[i].normal.isZero()) continue;
      EXPECT_LE(sites[i].position_m.head<2>().norm(), radius_m);
      grid.samples()[i] = Grey(1.0f);
    }
    for (const Eigen::Vector3f& p : part.positions_m) EXPECT_NEAR(grid.At(p).x(), 1.0f, 1e-5f);
  }
}

TEST(LightGridTest, SmoothingKeepsWhatIsEvenAndEvensOutTheRest) {
  std::vector<LightSample> samples(25, Grey(0.5f));
  Smooth(samples.data(), 5, 5);
  for (const LightSample& sample : samples) EXPECT_NEAR(sample[0], 0.5f, 1e-6f);
  samples[12] = Grey(1.3f);
  samples[6] = Grey(9.0f, 0.0f);
  Smooth(samples.data(), 5, 5);
  // Weight 4 of 15: one of the neighbours at the corners, of weight 1, counts for nothing.
  EXPECT_NEAR(samples[12][0], 0.5f + 0.8f * 4.0f / 15.0f, 1e-6f);
  EXPECT_EQ(samples[6][3], 0.0f);
}

}  // namespace
}  // namespace semantic_slam
