#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// Furniture made of boxes in a room of 8 x 8 m with its floor at z = 0: a fixture for tests that
// need exact depth, and to know which pixel shows what. Not thread-safe.
class BoxScene {
 public:
  struct View {
    RgbdImage image;
    cv::Mat objects;  // CV_8UC1: 1 + index of the object that the pixel shows; 0 for the room
  };

  // All return the index of the object. Places are on the floor plan [m], yaw is about z [rad].
  int AddCrate(const Eigen::Vector2d& at, const Eigen::Vector3d& size_m, double yaw_rad,
               double floor_m = 0.0);
  int AddTable(const Eigen::Vector2d& at, const Eigen::Vector3d& size_m,
               double yaw_rad);                             // a board on four legs
  int AddChair(const Eigen::Vector2d& at, double yaw_rad);  // 45 cm square, its seat at 45 cm

  // Depth is exact and reaches everywhere.
  View Render(const Rigid3d& T_world_camera, const CameraModel& camera, Stamp stamp) const;

  // The smallest box around the pixels that show the object; empty if none do.
  static cv::Rect2f VisibleBox(const View& view, int object);

 private:
  struct Part {
    int object;
    Rigid3d T_part_world;
    Eigen::Vector3d half_m;
  };

  void AddPart(int object, const Rigid3d& T_world_object, const Eigen::Vector3d& centre_m,
               const Eigen::Vector3d& size_m);

  std::vector<Part> parts_;
  int objects_ = 0;
};

// The pose of a camera at `eye` that looks at `target`, upright.
Rigid3d LookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

}  // namespace semantic_slam
