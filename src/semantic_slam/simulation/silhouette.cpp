#include "semantic_slam/simulation/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace semantic_slam {
namespace {

constexpr double kNearM = 0.05;

using Corners = std::vector<Eigen::Vector2d>;  // [px], of a convex polygon

// What of a triangle lies before the near plane, as the camera sees it.
void ProjectClipped(const std::array<Eigen::Vector3d, 3>& triangle, const CameraIntrinsics& camera,
                    Corners& corners) {
  corners.clear();
  const auto add = [&](const Eigen::Vector3d& p) {
    corners.emplace_back(camera.fx_px * p.x() / p.z() + camera.cx_px,
                         camera.fy_px * p.y() / p.z() + camera.cy_px);
  };
  for (std::size_t i = 0; i < triangle.size(); ++i) {
    const Eigen::Vector3d &a = triangle[i], &b = triangle[(i + 1) % triangle.size()];
    if (a.z() >= kNearM) add(a);
    if ((a.z() >= kNearM) != (b.z() >= kNearM)) {
      add(a + (kNearM - a.z()) / (b.z() - a.z()) * (b - a));
    }
  }
}

// Sets the pixels of the mask whose centres lie in the polygon. `first`: the pixel at the mask's
// corner.
void Fill(const Corners& corners, const cv::Point& first, cv::Mat& mask) {
  double low = corners[0].y(), high = low;
  for (const Eigen::Vector2d& corner : corners) {
    low = std::min(low, corner.y());
    high = std::max(high, corner.y());
  }
  const int begin = static_cast<int>(std::ceil(std::max(low - first.y, 0.0)));
  const int end = static_cast<int>(std::floor(std::min(high - first.y, mask.rows - 1.0)));
  for (int row = begin; row <= end; ++row) {
    const double v = row + first.y;
    double left = mask.cols, right = -1.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
      if (std::min(a.y(), b.y()) > v || std::max(a.y(), b.y()) < v) continue;
      if (a.y() == b.y()) continue;  // its ends are those of the neighbouring edges
      const double u = a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) - first.x;
      left = std::min(left, u);
      right = std::max(right, u);
    }
    const int from = static_cast<int>(std::ceil(std::max(left, 0.0)));
    const int to = static_cast<int>(std::floor(std::min(right, mask.cols - 1.0)));
    if (from <= to) mask.row(row).colRange(from, to + 1).setTo(1);
  }
}

}  // namespace

int SilhouettePixels(const WorldObject& object, const Rigid3d& T_camera_object,
                     const CameraIntrinsics& intrinsics) {
  cv::Mat mask = cv::Mat::zeros(3 * intrinsics.height_px, 3 * intrinsics.width_px, CV_8U);
  const cv::Point first(-intrinsics.width_px, -intrinsics.height_px);
  Corners corners;
  for (const Surface& surface : object.surfaces) {
    const Mesh& mesh = surface.mesh;
    for (const Eigen::Vector3i& indices : mesh.triangles) {
      std::array<Eigen::Vector3d, 3> triangle;
      for (int i = 0; i < 3; ++i) {
        triangle[i] = T_camera_object * mesh.positions_m[indices[i]].cast<double>();
      }
      ProjectClipped(triangle, intrinsics, corners);
      if (corners.size() >= 3) Fill(corners, first, mask);
    }
  }
  return cv::countNonZero(mask);
}

}  // namespace semantic_slam
