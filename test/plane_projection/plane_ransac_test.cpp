#include "semantic_slam/plane_projection/plane_ransac.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// `on` points near z = 0.1 x + 0.5 and `off` points anywhere in a cube of 2 m.
std::vector<Eigen::Vector3f> TiltedPlane(int on, int off, float noise_m) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
  std::normal_distribution<float> noise(0.0f, noise_m);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < on; ++i) {
    const float x = anywhere(random), y = anywhere(random);
    points.emplace_back(x, y, 0.1f * x + 0.5f + noise(random));
  }
  for (int i = 0; i < off; ++i) {
    points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
  }
  return points;
}

const Eigen::Vector3d kNormal = Eigen::Vector3d(-0.1, 0.0, 1.0).normalized();

TEST(PlaneRansacTest, FindsThePlaneAmongHalfAsManyOthers) {
  PlaneConstraint constraint;
  constraint.axis = Eigen::Vector3d::UnitZ();
  const auto fit = FitPlane(TiltedPlane(400, 200, 0.005f), 100, constraint);
  ASSERT_TRUE(fit);
  // 400 points with 5 mm of noise fix the normal to under a milliradian; others pull at it.
  EXPECT_LT((fit->plane.normal - kNormal).norm(), 0.005);
  EXPECT_NEAR(fit->plane.SignedDistance({0.0, 0.0, 0.5}), 0.0, 0.002);
  EXPECT_NEAR(fit->plane.SignedDistance({0.0, 0.0, 1.5}), kNormal.z(), 0.005);  // above is positive
  EXPECT_GE(fit->inliers.size(), 395u);                                         // four sigma
  EXPECT_LT(fit->inliers.size(), 420u);  // of 200 anywhere, 2 % lie within 2 cm
  EXPECT_TRUE(std::is_sorted(fit->inliers.begin(), fit->inliers.end()));
}

TEST(PlaneRansacTest, AnAxisRulesOutOtherPlanes) {
  const auto points = TiltedPlane(400, 0, 0.002f);
  PlaneConstraint constraint;
  constraint.axis = Eigen::Vector3d::UnitX();
  constraint.max_tilt_rad = 0.5;
  EXPECT_FALSE(FitPlane(points, 300, constraint));
  constraint.axis.reset();
  EXPECT_TRUE(FitPlane(points, 300, constraint));
}

TEST(PlaneRansacTest, TooFewPointsMakeNoPlane) {
  const PlaneConstraint constraint;
  EXPECT_FALSE(FitPlane({}, 3, constraint));
  EXPECT_FALSE(FitPlane({{0, 0, 0}, {1, 0, 0}}, 0, constraint));
  EXPECT_FALSE(FitPlane(TiltedPlane(50, 0, 0.0f), 51, constraint));
  const std::vector<Eigen::Vector3f> one_place(100, Eigen::Vector3f(1, 2, 3));
  EXPECT_FALSE(FitPlane(one_place, 3, constraint));
}

TEST(PlaneRansacTest, TheSamePointsGiveTheSamePlane) {
  const auto points = TiltedPlane(300, 300, 0.01f);
  const auto a = FitPlane(points, 50, {}), b = FitPlane(points, 50, {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->plane.normal, b->plane.normal);
  EXPECT_EQ(a->inliers, b->inliers);
}

}  // namespace
}  // namespace semantic_slam
