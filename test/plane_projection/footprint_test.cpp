#include "semantic_slam/plane_projection/footprint.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// A table: a top of 1.2 m x 0.8 m at 0.75 m, and one leg that is splayed outwards.
std::vector<Eigen::Vector3f> Table() {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i <= 24; ++i) {
    for (int j = 0; j <= 16; ++j) points.emplace_back(0.05f * i, 0.05f * j, 0.75f);
  }
  for (int k = 0; k < 14; ++k) points.emplace_back(-0.1f + 0.005f * k, 0.0f, 0.05f * k);
  return points;
}

TEST(FootprintTest, IsWhereTheTopIs) {
  const auto points = Table();
  const auto top = FindTopPlane(points, {});
  ASSERT_TRUE(top);
  const auto footprint = ProjectFootprint(points, top);
  ASSERT_TRUE(footprint);
  // Floats hold a metre to 1e-7.
  EXPECT_NEAR(Area(footprint->outline_m), 1.2 * 0.8, 1e-6);
  EXPECT_NEAR(Area(footprint->body_m), 1.2 * 0.8 + 0.5 * 0.8 * 0.1, 1e-6);
  EXPECT_FLOAT_EQ(footprint->min_height_m, 0.0f);
  EXPECT_FLOAT_EQ(footprint->max_height_m, 0.75f);
}

TEST(FootprintTest, WithoutATopItIsAllOfTheObject) {
  const auto footprint = ProjectFootprint(Table(), std::nullopt);
  ASSERT_TRUE(footprint);
  EXPECT_EQ(footprint->outline_m, footprint->body_m);
}

TEST(FootprintTest, WithoutAreaThereIsNone) {
  EXPECT_FALSE(ProjectFootprint({}, std::nullopt));
  EXPECT_FALSE(ProjectFootprint({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}, std::nullopt));
}

}  // namespace
}  // namespace semantic_slam
