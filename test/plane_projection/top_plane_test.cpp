#include "semantic_slam/plane_projection/top_plane.h"

#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

class PointMaker {
 public:
  // Points on a level board from `low` to `high`, 4 mm of noise in z.
  PointMaker& Board(const Eigen::Vector2f& low, const Eigen::Vector2f& high, float z, int count) {
    for (int i = 0; i < count; ++i) {
      points_.emplace_back(Between(low.x(), high.x()), Between(low.y(), high.y()),
                           z + noise_(random_));
    }
    return *this;
  }

  PointMaker& Wall(const Eigen::Vector3f& low, const Eigen::Vector3f& high, int count) {
    for (int i = 0; i < count; ++i) {
      points_.emplace_back(Between(low.x(), high.x()), Between(low.y(), high.y()),
                           Between(low.z(), high.z()));
    }
    return *this;
  }

  const std::vector<Eigen::Vector3f>& points() const { return points_; }

 private:
  float Between(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }

  std::mt19937 random_{1};
  std::normal_distribution<float> noise_{0.0f, 0.004f};
  std::vector<Eigen::Vector3f> points_;
};

TEST(TopPlaneTest, FindsAChairsSeatBelowItsBack) {
  PointMaker chair;
  chair.Board({0.0f, 0.0f}, {0.45f, 0.45f}, 0.45f, 300)
      .Wall({0.43f, 0.0f, 0.45f}, {0.46f, 0.45f, 0.95f}, 300)
      .Wall({0.0f, 0.0f, 0.0f}, {0.04f, 0.04f, 0.45f}, 40);
  const auto top = FindTopPlane(chair.points(), {});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->height_m, 0.45,
              0.005);  // the mean of 300 readings with 4 mm of noise, and a few of the back
  EXPECT_GT(top->plane.normal.z(), 0.99);
  EXPECT_GE(top->inliers.size(), 300u);
  EXPECT_LT(top->inliers.size(), 340u);  // the back begins there
}

TEST(TopPlaneTest, OfTwoBoardsTheUpperOneIsTheTop) {
  PointMaker shelf;
  shelf.Board({0, 0}, {1, 1}, 0.3f, 500).Board({0, 0}, {1, 1}, 0.8f, 300);
  EXPECT_NEAR(FindTopPlane(shelf.points(), {})->height_m, 0.8, 0.005);
  PointMaker cup_on_table;
  cup_on_table.Board({0, 0}, {1, 1}, 0.7f, 500).Board({0.4f, 0.4f}, {0.5f, 0.5f}, 0.8f, 60);
  EXPECT_NEAR(FindTopPlane(cup_on_table.points(), {})->height_m, 0.7, 0.005);
}

TEST(TopPlaneTest, ASlightlyTiltedTopIsATop) {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 400; ++i) {
    const auto x = static_cast<float>(i % 20) * 0.05f, y = static_cast<float>(i / 20) * 0.05f;
    points.emplace_back(x, y, 0.7f + 0.08f * x);
  }
  const auto top = FindTopPlane(points, {});
  ASSERT_TRUE(top);
  EXPECT_EQ(top->inliers.size(), 400u);
}

TEST(TopPlaneTest, AScreenHasNone) {
  PointMaker screen;
  screen.Wall({0.0f, 0.0f, 0.0f}, {0.02f, 0.6f, 0.4f}, 800);
  EXPECT_FALSE(FindTopPlane(screen.points(), {}));
}

TEST(TopPlaneTest, NorHasNothing) {
  EXPECT_FALSE(FindTopPlane({}, {}));
  EXPECT_FALSE(FindTopPlane({{0, 0, 0}}, {}));
}

}  // namespace
}  // namespace semantic_slam
