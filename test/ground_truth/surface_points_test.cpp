#include "semantic_slam/ground_truth/surface_points.h"

#include <vector>

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"

namespace semantic_slam {
namespace {

TEST(SurfacePointsTest, AreDenseOnASurfaceAndNowhereElse) {
  std::vector<Eigen::Vector3d> points;
  ForEachSurfacePoint(FloorMesh(1.0f, 0.5f), At(2.0, 3.0), 0.1,
                      [&](const Eigen::Vector3d& point) { points.push_back(point); });
  for (double x = 2.0; x <= 3.0; x += 0.05) {
    for (double y = 3.0; y <= 3.5; y += 0.05) {
      double nearest = 1.0;
      for (const Eigen::Vector3d& p : points)
        nearest = std::min(nearest, (p - Eigen::Vector3d(x, y, 0)).norm());
      EXPECT_LT(nearest, 0.1) << x << " " << y;
    }
  }
  for (const Eigen::Vector3d& p : points) {
    EXPECT_TRUE(p.x() > 2.0 && p.x() < 3.0 && p.y() > 3.0 && p.y() < 3.5) << p.transpose();
    EXPECT_NEAR(p.z(), -0.001, 1e-6);  // a millimetre below
  }
}

TEST(SurfacePointsTest, ATriangleHasItsCorners) {
  int found = 0;
  const Eigen::Vector3d a(0, 0, 0), b(0.3, 0, 0), c(0, 0.2, 0.1);
  ForEachTrianglePoint(a, b, c, 10.0, [&](const Eigen::Vector3d& p) {
    found += (p - a).norm() < 1e-9 || (p - b).norm() < 1e-9 || (p - c).norm() < 1e-9;
  });
  EXPECT_GE(found, 3);
}

}  // namespace
}  // namespace semantic_slam
