#include "semantic_slam/semantic_grid/presence_patch.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// Cells of 10 cm from (1, 2) m.
const CellLattice kLattice{0.1, {1.0, 2.0}};

ConvexPolygon Box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

float At(const PresencePatch& patch, int x, int y) {
  if (!patch.cells.contains(cv::Point(x, y))) return 0.0f;
  return patch.probability.at<float>(y - patch.cells.y, x - patch.cells.x);
}

// 1e-5: corners are decimal fractions, probabilities floats.
constexpr float kRounding = 1e-5f;

TEST(PresencePatchTest, CoversWholeCells) {
  const PresencePatch patch = RasterisePresence(Box(1.2, 2.0, 1.4, 2.1), {0.0, 0.0}, kLattice);
  EXPECT_NEAR(At(patch, 2, 0), 1.0f, kRounding);
  EXPECT_NEAR(At(patch, 3, 0), 1.0f, kRounding);
  EXPECT_NEAR(At(patch, 1, 0), 0.0f, kRounding);
  EXPECT_NEAR(At(patch, 4, 0), 0.0f, kRounding);
  EXPECT_NEAR(cv::sum(patch.probability)[0], 2.0, kRounding);
}

TEST(PresencePatchTest, CoversPartsOfCells) {
  const PresencePatch patch = RasterisePresence(Box(1.05, 2.0, 1.13, 2.15), {0.0, 0.0}, kLattice);
  EXPECT_NEAR(At(patch, 0, 0), 0.5f, kRounding);
  EXPECT_NEAR(At(patch, 1, 0), 0.3f, kRounding);
  EXPECT_NEAR(At(patch, 0, 1), 0.25f, kRounding);
  EXPECT_NEAR(At(patch, 1, 1), 0.15f, kRounding);
}

TEST(PresencePatchTest, CellsCountFromTheLatticesOriginAlsoBelowIt) {
  const PresencePatch patch = RasterisePresence(Box(0.7, 1.8, 0.8, 1.9), {0.0, 0.0}, kLattice);
  EXPECT_NEAR(At(patch, -3, -2), 1.0f, kRounding);
  EXPECT_NEAR(cv::sum(patch.probability)[0], 1.0, kRounding);
}

TEST(PresencePatchTest, AreaOfASlantedOutlineIsKept) {
  const ConvexPolygon diamond{{1.5, 2.2}, {1.8, 2.5}, {1.5, 2.8}, {1.2, 2.5}};
  const PresencePatch patch = RasterisePresence(diamond, {0.0, 0.0}, kLattice);
  // 0.18 m^2 are 18 cells; 0.1: edges are sampled four times per cell along y.
  EXPECT_NEAR(cv::sum(patch.probability)[0], 18.0, 0.1);
  EXPECT_NEAR(At(patch, 4, 4), 1.0f, kRounding);
  EXPECT_NEAR(At(patch, 2, 2), 0.0f, kRounding);
}

TEST(PresencePatchTest, UncertaintyBlursTheEdges) {
  const ConvexPolygon box = Box(1.0, 2.0, 2.0, 3.0);
  const PresencePatch patch = RasterisePresence(box, {0.1, 0.0}, kLattice);
  EXPECT_NEAR(At(patch, 5, 5), 1.0f, 1e-3f) << "five standard deviations inside";
  // Either side of the edge: the mean of the normal distribution function over half a standard
  // deviation each is not needed here, only that it is symmetric and falls.
  EXPECT_NEAR(At(patch, 0, 5) + At(patch, -1, 5), 1.0f, 1e-3f);
  EXPECT_GT(At(patch, 0, 5), 0.6f);
  EXPECT_GT(At(patch, -1, 5), At(patch, -2, 5));
  EXPECT_GT(At(patch, -2, 5), 0.0f);
  EXPECT_EQ(At(patch, -4, 5), 0.0f) << "beyond three standard deviations";
  EXPECT_NEAR(At(patch, 5, 0), 1.0f, 1e-3f) << "y is certain";
  EXPECT_EQ(At(patch, 5, -1), 0.0f);
  // 1e-3: the kernel is normalised, sums are of floats.
  EXPECT_NEAR(cv::sum(patch.probability)[0], 100.0, 1e-3);
}

TEST(PresencePatchTest, NoOutlineCoversNothing) {
  EXPECT_TRUE(RasterisePresence({}, {0.1, 0.1}, kLattice).cells.empty());
}

}  // namespace
}  // namespace semantic_slam
