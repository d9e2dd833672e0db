#include "semantic_slam/worlds/triangle_distance.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// To the triangle of the origin, (2, 0, 0) and (0, 2, 0).
double DistanceFrom(const Eigen::Vector3d& p) {
  return DistanceToTriangle(p, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
}

TEST(TriangleDistanceTest, AboveAndBelowItIsTheHeight) {
  EXPECT_DOUBLE_EQ(DistanceFrom({0.5, 0.5, 3}), 3.0);
  EXPECT_DOUBLE_EQ(DistanceFrom({0.5, 0.5, -3}), 3.0);
  EXPECT_DOUBLE_EQ(DistanceFrom({0.5, 0.5, 0}), 0.0);
}

TEST(TriangleDistanceTest, BesideItIsToTheNearestEdgeOrCorner) {
  EXPECT_DOUBLE_EQ(DistanceFrom({1, -3, 4}), 5.0);
  EXPECT_DOUBLE_EQ(DistanceFrom({-3, -4, 0}), 5.0);
  EXPECT_NEAR(DistanceFrom({2, 2, 0}), std::sqrt(2.0), 1e-12);
}

TEST(TriangleDistanceTest, ItMayBeALineOrAPoint) {
  EXPECT_DOUBLE_EQ(DistanceToTriangle({1, 2, 0}, {0, 0, 0}, {1, 0, 0}, {3, 0, 0}), 2.0);
  EXPECT_DOUBLE_EQ(DistanceToTriangle({1, 2, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}), 2.0);
}

}  // namespace
}  // namespace semantic_slam
