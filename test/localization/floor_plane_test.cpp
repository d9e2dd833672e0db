#include "semantic_slam/localization/floor_plane.h"

#include <cmath>

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// A camera 1 m above an endless floor, looking down by `pitch_rad`; a wall `wall_m` ahead of it.
RgbdImage FloorAndWall(double pitch_rad, double wall_m) {
  const auto camera = SmallCamera();
  RgbdImage image = BlankImage(Stamp{1});
  const Eigen::AngleAxisd tilt(-pitch_rad, Eigen::Vector3d::UnitX());
  for (int v = 0; v < image.depth_m.rows; ++v) {
    for (int u = 0; u < image.depth_m.cols; ++u) {
      const Eigen::Vector2f& ray = camera->Ray(u, v);
      // Axes of the camera before it was tilted: y down, z ahead.
      const Eigen::Vector3d level = tilt * Eigen::Vector3d(ray.x(), ray.y(), 1.0);
      const double to_floor = level.y() > 1e-6 ? 1.0 / level.y() : 1e9;
      const double to_wall = level.z() > 1e-6 ? wall_m / level.z() : 1e9;
      image.depth_m.at<float>(v, u) = static_cast<float>(std::min(to_floor, to_wall));
    }
  }
  return image;
}

const Eigen::Vector3d kLevelUp(0.0, -1.0, 0.0);

TEST(FloorPlaneTest, FindsTheFloorBeforeALargerWall) {
  const double pitch_rad = 0.35;
  const auto normal = LevelSurfaceNormal(FloorAndWall(pitch_rad, 3.0), *SmallCamera(), kLevelUp);
  ASSERT_TRUE(normal);
  // Up, seen from a camera that looks down, leans backwards. 1e-3 rad: the foot of the wall is within
  // the noise of the floor and tilts it by 0.03 degrees.
  const Eigen::Vector3d up(0.0, -std::cos(pitch_rad), -std::sin(pitch_rad));
  EXPECT_LT((*normal - up).norm(), 1e-3) << normal->transpose();
}

TEST(FloorPlaneTest, DoesNotTakeAWallForTheFloor) {
  EXPECT_FALSE(LevelSurfaceNormal(FloorAndWall(0.0, 0.5), *SmallCamera(), kLevelUp));
}

TEST(FloorPlaneTest, NeedsDepth) {
  RgbdImage image = FloorAndWall(0.35, 3.0);
  image.depth_m.setTo(std::nanf(""));
  EXPECT_FALSE(LevelSurfaceNormal(image, *SmallCamera(), kLevelUp));
}

}  // namespace
}  // namespace semantic_slam
