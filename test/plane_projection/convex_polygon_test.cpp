#include "semantic_slam/plane_projection/convex_polygon.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

const ConvexPolygon kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

std::vector<Eigen::Vector2d> RandomPoints(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(random);
    points.emplace_back(x, coordinate(random));
  }
  return points;
}

TEST(ConvexHullTest, ASquareWithPointsInsideAndOnItsSides) {
  std::vector<Eigen::Vector2d> points = kSquare;
  points.insert(points.end(), {{1, 1}, {1, 0}, {2, 1}, {0.5, 1.9}, {0, 0}, {2, 2}});
  EXPECT_EQ(ConvexHull(points), kSquare);
}

TEST(ConvexHullTest, HoldsAllPointsAndOnlyTurnsLeft) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto points = RandomPoints(200, seed);
    const ConvexPolygon hull = ConvexHull(points);
    ASSERT_GE(hull.size(), 3u);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Eigen::Vector2d a = hull[i], b = hull[(i + 1) % hull.size()],
                            c = hull[(i + 2) % hull.size()];
      EXPECT_GT((b - a).x() * (c - b).y() - (b - a).y() * (c - b).x(), 0.0);
      EXPECT_NE(std::find(points.begin(), points.end(), a), points.end());
    }
    for (const Eigen::Vector2d& p : points) EXPECT_TRUE(Contains(hull, p));
  }
}

TEST(ConvexHullTest, WithoutAreaThereIsNone) {
  EXPECT_TRUE(ConvexHull({}).empty());
  EXPECT_TRUE(ConvexHull({{1, 1}, {1, 1}, {1, 1}}).empty());
  EXPECT_TRUE(ConvexHull({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).empty());
  EXPECT_TRUE(ConvexHull({{0, 1}, {0, 2}, {0, 3}}).empty());
  EXPECT_TRUE(
      ConvexHull({{0.1, 0.3}, {0.2, 0.6}, {0.7, 2.1}, {0.9, 2.7}}).empty());  // but for rounding
}

TEST(ConvexPolygonTest, AreaAndContents) {
  EXPECT_DOUBLE_EQ(Area(kSquare), 4.0);
  EXPECT_DOUBLE_EQ(Area({}), 0.0);
  EXPECT_TRUE(Contains(kSquare, {1, 1}));
  EXPECT_TRUE(Contains(kSquare, {0, 1}));
  EXPECT_FALSE(Contains(kSquare, {-0.1, 1}));
  EXPECT_FALSE(Contains({}, {0, 0}));
  EXPECT_DOUBLE_EQ(Support(kSquare, {1, 1}), 4.0);
}

TEST(ConvexPolygonTest, Intersections) {
  EXPECT_DOUBLE_EQ(Area(Intersection(kSquare, {{1, 1}, {3, 1}, {3, 3}, {1, 3}})), 1.0);
  EXPECT_DOUBLE_EQ(Area(Intersection(kSquare, kSquare)), 4.0);
  // A square turned by 45 degrees about the same centre, half diagonal 1.2: an octagon.
  const ConvexPolygon turned{{2.2, 1}, {1, 2.2}, {-0.2, 1}, {1, -0.2}};
  EXPECT_NEAR(Area(Intersection(kSquare, turned)), 2.88 - 4 * 0.04, 1e-12);
  EXPECT_TRUE(Intersection(kSquare, {{5, 5}, {6, 5}, {5, 6}}).empty());
  EXPECT_TRUE(Intersection(kSquare, {}).empty());
  EXPECT_TRUE(Intersection({}, kSquare).empty());
}

TEST(ConvexPolygonTest, ClippingByAHalfPlane) {
  EXPECT_DOUBLE_EQ(Area(ClippedByHalfPlane(kSquare, {1, 0}, 0.5)), 1.0);
  EXPECT_EQ(ClippedByHalfPlane(kSquare, {1, 0}, 5.0), kSquare);
  EXPECT_TRUE(ClippedByHalfPlane(kSquare, {1, 0}, -1.0).empty());
}

TEST(ConvexPolygonTest, SimplifyingDropsFlatCornersOnly) {
  const ConvexPolygon dented{{0, 0}, {1, -0.001}, {2, 0}, {2.05, 1}, {2, 2}, {0, 2}};
  const ConvexPolygon expected{{0, 0}, {2, 0}, {2.05, 1}, {2, 2}, {0, 2}};
  EXPECT_EQ(Simplified(dented, 0.01), expected);
  EXPECT_EQ(Simplified(kSquare, 10.0).size(), 3u);  // never less than a triangle
  EXPECT_TRUE(Simplified({}, 0.01).empty());
}

TEST(MinimumAreaRectangleTest, IsTheRectangleItself) {
  for (const double yaw : {0.0, 0.3, 1.2, -0.7, 1.5}) {
    const Eigen::Vector2d x(std::cos(yaw), std::sin(yaw)), y(-x.y(), x.x()), centre(3, -2);
    const ConvexPolygon corners{centre - 0.6 * x - 0.2 * y, centre + 0.6 * x - 0.2 * y,
                                centre + 0.6 * x + 0.2 * y, centre - 0.6 * x + 0.2 * y};
    const Rectangle rectangle = MinimumAreaRectangle(corners);
    EXPECT_NEAR((rectangle.centre - centre).norm(), 0.0, 1e-12);
    EXPECT_NEAR(rectangle.size.x(), 1.2, 1e-12);
    EXPECT_NEAR(rectangle.size.y(), 0.4, 1e-12);
    EXPECT_NEAR(rectangle.yaw_rad, yaw, 1e-12);
  }
}

TEST(MinimumAreaRectangleTest, NoTurnedRectangleIsSmaller) {
  const ConvexPolygon hull = ConvexHull(RandomPoints(30, 7));
  const Rectangle best = MinimumAreaRectangle(hull);
  for (int i = 0; i < 180; ++i) {
    const double yaw = i * M_PI / 180;
    const Eigen::Vector2d x(std::cos(yaw), std::sin(yaw)), y(-x.y(), x.x());
    const double area =
        (Support(hull, x) + Support(hull, -x)) * (Support(hull, y) + Support(hull, -y));
    EXPECT_GE(area, best.size.prod() - 1e-12);
  }
}

}  // namespace
}  // namespace semantic_slam
