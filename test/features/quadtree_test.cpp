#include "semantic_slam/features/quadtree.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

const cv::Size kVga(640, 480);

cv::KeyPoint Corner(float u, float v, float response) {
  return cv::KeyPoint(cv::Point2f(u, v), 7.0f, -1.0f, response);
}

// Corners all over `area`, no two of the same strength.
std::vector<cv::KeyPoint> RandomCorners(int count, const cv::Rect2f& area, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<cv::KeyPoint> corners;
  for (int i = 0; i < count; ++i) {
    corners.push_back(Corner(area.x + 0.999f * unit(random) * area.width,
                             area.y + 0.999f * unit(random) * area.height, static_cast<float>(i)));
  }
  return corners;
}

bool Same(const std::vector<cv::KeyPoint>& a, const std::vector<cv::KeyPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const cv::KeyPoint& x, const cv::KeyPoint& y) {
                      return x.pt == y.pt && x.response == y.response;
                    });
}

TEST(QuadtreeTest, NothingInNothingOut) {
  EXPECT_TRUE(SpreadByQuadtree({}, kVga, 100).empty());
}

TEST(QuadtreeTest, KeepsTheStrongestCornerOfEachCell) {
  // Two root cells of 50 x 50: the left one is crowded, the right one has a single weak corner.
  const auto spread = SpreadByQuadtree(
      {Corner(10, 10, 5), Corner(11, 10, 9), Corner(12, 11, 7), Corner(90, 40, 1)}, {100, 50}, 2);
  ASSERT_EQ(spread.size(), 2u);
  EXPECT_EQ(spread[0].response, 9.0f);
  EXPECT_EQ(spread[1].response, 1.0f);
}

TEST(QuadtreeTest, KeepsEverythingIfThatIsFewerThanWanted) {
  const auto corners = RandomCorners(50, cv::Rect2f(0, 0, 640, 480), 1);
  EXPECT_EQ(SpreadByQuadtree(corners, kVga, 1000).size(), 50u);
}

TEST(QuadtreeTest, KeepsAboutAsManyAsWanted) {
  const auto corners = RandomCorners(5000, cv::Rect2f(0, 0, 640, 480), 2);
  for (const int wanted : {1, 10, 99, 100, 500, 1200}) {
    const auto spread = SpreadByQuadtree(corners, kVga, wanted);
    EXPECT_GE(static_cast<int>(spread.size()), wanted);
    EXPECT_LE(static_cast<int>(spread.size()), wanted + 2);  // the last split turns one cell into 4
  }
}

TEST(QuadtreeTest, ACrowdDoesNotStarveTheRest) {
  auto corners = RandomCorners(4000, cv::Rect2f(600, 440, 40, 40), 3);
  const auto elsewhere = RandomCorners(1000, cv::Rect2f(0, 0, 640, 480), 4);
  corners.insert(corners.end(), elsewhere.begin(), elsewhere.end());
  for (auto& corner : corners) {  // and the crowd is the stronger
    if (corner.pt.x > 600 && corner.pt.y > 440) corner.response += 1e4f;
  }
  const auto spread = SpreadByQuadtree(corners, kVga, 300);
  for (int v = 0; v < 480; v += 120) {
    for (int u = 0; u < 640; u += 160) {
      const cv::Rect2f tile(static_cast<float>(u), static_cast<float>(v), 160, 120);
      EXPECT_TRUE(std::any_of(spread.begin(), spread.end(), [&](const cv::KeyPoint& corner) {
        return tile.contains(corner.pt);
      })) << tile;
    }
  }
}

TEST(QuadtreeTest, TheOrderOfTheCornersDoesNotMatter) {
  auto corners = RandomCorners(3000, cv::Rect2f(0, 0, 640, 480), 5);
  const auto spread = SpreadByQuadtree(corners, kVga, 400);
  std::shuffle(corners.begin(), corners.end(), std::mt19937(6));
  EXPECT_TRUE(Same(SpreadByQuadtree(corners, kVga, 400), spread));
}

TEST(QuadtreeTest, CornersInTheSamePlaceDoNotSplitForEver) {
  const std::vector<cv::KeyPoint> corners(20, Corner(33.3f, 44.4f, 1.0f));
  EXPECT_EQ(SpreadByQuadtree(corners, kVga, 100).size(), 1u);
}

}  // namespace
}  // namespace semantic_slam
