#include "semantic_slam/simulation/silhouette.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

const CameraIntrinsics kCamera{64, 48, 50.0, 50.0, 31.5, 23.5, {}};

WorldObject ObjectOf(const Mesh& mesh) {
  WorldObject object;
  object.surfaces.emplace_back();
  object.surfaces.back().mesh = mesh;
  return object;
}

// Of a thin box before the camera, whose z is forward.
int PixelsOf(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& size_m) {
  return SilhouettePixels(ObjectOf(BoxMesh(centre_m, size_m)), Rigid3d::Identity(), kCamera);
}

TEST(SilhouetteTest, CountsThePixelsThatAnObjectCovers) {
  // 0.4 x 0.2 m at 2 m: 10 x 5 pixels, whose edges lie between pixels' centres.
  EXPECT_EQ(PixelsOf({0.0f, 0.02f, 2.0f}, {0.4f, 0.2f, 0.0f}), 50);
}

TEST(SilhouetteTest, CountsEveryPixelOnceHoweverManyFacesCoverIt) {
  const Mesh one = BoxMesh({0.0f, 0.02f, 2.0f}, {0.4f, 0.2f, 0.0f});
  Mesh two = one;
  Append(two, one);
  EXPECT_EQ(SilhouettePixels(ObjectOf(two), Rigid3d::Identity(), kCamera), 50);
}

TEST(SilhouetteTest, GoesOnBeyondTheImage) {
  // One half leaves the image at the right.
  const float right_m = 2.0f * 32.0f / 50.0f;
  EXPECT_EQ(PixelsOf({right_m, 0.02f, 2.0f}, {0.4f, 0.2f, 0.0f}), 50);
}

TEST(SilhouetteTest, EndsAnImageBeyondTheEdges) {
  EXPECT_EQ(PixelsOf({0.0f, 0.0f, 2.0f}, {90.0f, 90.0f, 0.0f}), 9 * 64 * 48);
}

TEST(SilhouetteTest, OfWhatReachesBehindTheCameraTheFrontCounts) {
  // A floor 0.5 m below, from behind the camera to 5 m before it: all of the canvas below the row
  // where it ends, 5 pixels below the middle.
  const int pixels = PixelsOf({0.0f, 0.5f, 0.0f}, {200.0f, 0.0f, 10.0f});
  EXPECT_EQ(pixels, 3 * 64 * (2 * 48 - 29));
}

TEST(SilhouetteTest, NothingIsSeenOfWhatIsBehindTheCamera) {
  EXPECT_EQ(PixelsOf({0.0f, 0.0f, -2.0f}, {0.4f, 0.2f, 0.1f}), 0);
  EXPECT_EQ(SilhouettePixels(WorldObject(), Rigid3d::Identity(), kCamera), 0);
}

}  // namespace
}  // namespace semantic_slam
