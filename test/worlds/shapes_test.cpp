#include "semantic_slam/worlds/shapes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "testing/mesh_checks.h"

namespace semantic_slam {
namespace {

constexpr double kPi = 3.14159265358979;

void ExpectSolid(const Mesh& mesh) {
  EXPECT_EQ(FaultOf(mesh), "");
  EXPECT_EQ(OpenEdgeOf(mesh), "");
  EXPECT_GT(VolumeOf(mesh), 0.0);
}

void ExpectBounds(const Mesh& mesh, const Eigen::Vector3f& low_m, const Eigen::Vector3f& high_m) {
  EXPECT_LT((BoundsOf(mesh).min() - low_m).norm(), 1e-5f) << BoundsOf(mesh).min().transpose();
  EXPECT_LT((BoundsOf(mesh).max() - high_m).norm(), 1e-5f) << BoundsOf(mesh).max().transpose();
}

TEST(ShapesTest, BeamLeansAndTapers) {
  const Mesh beam = BeamMesh({0, 0, 0}, {0.1f, 0, 1}, {0.2f, 0.2f}, {0.1f, 0.1f});
  ExpectSolid(beam);
  ExpectBounds(beam, {-0.1f, -0.1f, 0}, {0.15f, 0.1f, 1});
  EXPECT_NEAR(VolumeOf(beam), (0.04 + 0.02 + 0.01) / 3, 1e-6);  // a frustum
}

TEST(ShapesTest, LimbHasRoundEnds) {
  const Mesh limb = LimbMesh({0, 0, 0}, {1, 0, 0}, 0.1f, 0.1f, 64);
  ExpectSolid(limb);
  // 2 %: the round ends are of eight flat rings each.
  EXPECT_NEAR(VolumeOf(limb), kPi * 0.01 + 4.0 / 3.0 * kPi * 0.001, 0.02 * kPi * 0.01);
  EXPECT_NEAR(BoundsOf(limb).min().x(), -0.1f, 1e-5f);
  EXPECT_NEAR(BoundsOf(limb).max().x(), 1.1f, 1e-5f);
}

TEST(ShapesTest, LimbMayPointDown) {
  ExpectSolid(LimbMesh({0, 0, 1}, {0, 0, 0}, 0.1f, 0.05f));
}

TEST(ShapesTest, RoundedBoxKeepsItsSize) {
  const Mesh box = RoundedBoxMesh({1, 0, 0}, {0.4f, 0.6f, 0.2f}, 0.05f);
  ExpectSolid(box);
  ExpectBounds(box, {0.8f, -0.3f, -0.1f}, {1.2f, 0.3f, 0.1f});
  EXPECT_LT(VolumeOf(box), 0.4 * 0.6 * 0.2);
  EXPECT_GT(VolumeOf(box), 0.9 * 0.4 * 0.6 * 0.2);
}

TEST(ShapesTest, RoundedBoxMayBeABall) {
  const Mesh ball = RoundedBoxMesh(Eigen::Vector3f::Zero(), {0.2f, 0.2f, 0.2f}, 0.1f);
  ExpectSolid(ball);
  EXPECT_NEAR(VolumeOf(ball), 4.0 / 3.0 * kPi * 0.001, 0.05 * 0.0042);  // 6 faces of 6 x 6
}

TEST(ShapesTest, SlabOverARoundedRectangle) {
  const std::vector<Eigen::Vector2f> outline = RoundedRectangle({2, 1}, 0.25f);
  const Mesh slab = SlabMesh(outline, 0.5f, 0.6f);
  ExpectSolid(slab);
  ExpectBounds(slab, {-1, -0.5f, 0.5f}, {1, 0.5f, 0.6f});
  // 1 %: corners of five straight pieces.
  EXPECT_NEAR(VolumeOf(slab), 0.1 * (2 - (4 - kPi) * 0.0625), 0.002);
}

TEST(ShapesTest, SlabOverAnEllipse) {
  const Mesh slab = SlabMesh(EllipseOutline({2, 1}), 0.5f, 0.6f);
  ExpectSolid(slab);
  ExpectBounds(slab, {-1, -0.5f, 0.5f}, {1, 0.5f, 0.6f});
  EXPECT_NEAR(VolumeOf(slab), 0.1 * kPi * 0.5, 0.001);  // forty corners: 0.4 % less
}

TEST(ShapesTest, SheetIsTwiceItsHalfThickness) {
  const auto middle = [](float u, float v) { return Eigen::Vector3f(0, u, 1 - v); };
  const auto half = [](float, float) { return 0.01f; };
  const Mesh sheet = SheetMesh(middle, half, Eigen::Vector3f::UnitX(), 20, 20);
  ExpectSolid(sheet);
  ExpectBounds(sheet, {-0.01f, 0, 0}, {0.01f, 1, 1});
  EXPECT_NEAR(VolumeOf(sheet), 0.02 * 0.95 * 0.95, 1e-4);  // sharp over half a cell at each edge
}

TEST(ShapesTest, PillowIsThickInTheMiddle) {
  const Mesh pillow = PillowMesh({0, 0, 0.1f}, {0.5f, 0.7f, 0.2f});
  ExpectSolid(pillow);
  ExpectBounds(pillow, {-0.25f, -0.35f, 0}, {0.25f, 0.35f, 0.2f});
}

TEST(ShapesTest, LeafGrowsAlongX) {
  const Mesh leaf = LeafMesh(0.3f, 0.1f, 0.1f);
  ExpectSolid(leaf);
  EXPECT_NEAR(BoundsOf(leaf).min().x(), 0.0f, 1e-5f);
  EXPECT_NEAR(BoundsOf(leaf).max().x(), 0.3f, 1e-5f);
  EXPECT_LT(BoundsOf(leaf).sizes().y(), 0.1f + 1e-5f);
  EXPECT_LT(BoundsOf(leaf).min().z(), -0.09f);
}

}  // namespace
}  // namespace semantic_slam
