#pragma once

#include <cstdint>
#include <vector>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/transform.h"
#include "testing/procedural_texture.h"

namespace semantic_slam {

// The same numbers as config/tum_freiburg1.yaml, so that everything made with the room can be read
// with that file.
CameraConfig Freiburg1Camera();

struct TexturedRoomOptions {
  std::uint64_t seed = 1;  // of the pictures on the surfaces, and of the noise
  CameraIntrinsics intrinsics = Freiburg1Camera().intrinsics;
  bool noise = true;  // like a Kinect's; without it depth is exact to the last bit of a float
};

// A furnished room with pictures on every surface, seen by a calibrated RGB-D camera: a fixture for
// tests that need images with known poses and exact depth. A desk with things on it stands before
// the wall at +x. The same seed gives the same bytes. Immutable, so safe from any thread.
//
// World frame: z up, origin on the floor in the middle of the room.
class TexturedRoom {
 public:
  static constexpr double kLengthM = 5.0;  // along x
  static constexpr double kWidthM = 4.0;   // along y
  static constexpr double kHeightM = 2.6;

  explicit TexturedRoom(const TexturedRoomOptions& options = {});

  // What a camera inside the room sees, by casting a ray through the centre of every raw pixel.
  // Depth is NaN where a Kinect gives none: nearer than 0.45 m, beyond 7 m, at grazing incidence.
  // The noise depends on the seed and on `stamp`. About 40 ms for 640 x 480 on one core.
  RgbdImage Render(const Rigid3d& T_world_camera, Stamp stamp) const;

  const CameraModel& camera() const { return camera_; }

 private:
  // A box standing in the room, turned about the vertical; or the room itself, seen from inside.
  struct Box {
    Rigid3d T_world_box;
    Eigen::Vector3f half_m;
    std::vector<Texture> faces;  // -x +x -y +y -z +z
  };
  struct View;  // a box as one camera sees it
  struct Hit;

  void AddBox(const Eigen::Vector3d& centre_m, const Eigen::Vector3d& size_m, double yaw_rad,
              FaceStuff stuff);
  std::vector<View> ViewsFrom(const Rigid3d& T_world_camera) const;
  static Hit Cast(const std::vector<View>& views, const Eigen::Vector3f& ray_camera);
  cv::Vec3f Shade(const Hit& hit, const Eigen::Vector3f& ray_camera) const;
  void AddNoise(RgbdImage& image) const;

  const TexturedRoomOptions options_;
  const CameraModel camera_;
  std::vector<Box> boxes_;  // the room first
};

}  // namespace semantic_slam
