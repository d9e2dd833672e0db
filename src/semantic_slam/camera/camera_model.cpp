#include "semantic_slam/camera/camera_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <opencv2/calib3d.hpp>

#include "semantic_slam/common/check.h"

namespace semantic_slam {
namespace {

constexpr int kMaxImageSidePx = 16384;

cv::Matx33d CameraMatrix(const CameraIntrinsics& c) {
  return {c.fx_px, 0.0, c.cx_px, 0.0, c.fy_px, c.cy_px, 0.0, 0.0, 1.0};
}

bool IsUndistorted(const CameraIntrinsics& c) {
  return std::all_of(c.distortion.begin(), c.distortion.end(), [](double k) { return k == 0.0; });
}

}  // namespace

bool operator==(const CameraIntrinsics& a, const CameraIntrinsics& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.fx_px == b.fx_px &&
         a.fy_px == b.fy_px && a.cx_px == b.cx_px && a.cy_px == b.cy_px &&
         a.distortion == b.distortion && a.readout_s == b.readout_s;
}

void CheckIntrinsics(const CameraIntrinsics& c) {
  CheckInRange("camera width_px", c.width_px, 8, kMaxImageSidePx);
  CheckInRange("camera height_px", c.height_px, 8, kMaxImageSidePx);
  CheckInRange("camera fx_px", c.fx_px, 1.0, 1e5);
  CheckInRange("camera fy_px", c.fy_px, 1.0, 1e5);
  // The principal point of a cropped image may lie outside, but not far.
  CheckInRange("camera cx_px", c.cx_px, -1.0 * c.width_px, 2.0 * c.width_px);
  CheckInRange("camera cy_px", c.cy_px, -1.0 * c.height_px, 2.0 * c.height_px);
  CheckInRange("camera readout_s", c.readout_s, -0.1, 0.1);
  const std::size_t n = c.distortion.size();
  if (n != 0 && n != 4 && n != 5 && n != 8) {
    throw ConfigError("camera distortion has " + std::to_string(n) +
                      " coefficients, expected 0, 4, 5 or 8 (k1 k2 p1 p2 [k3 [k4 k5 k6]])");
  }
  for (const double k : c.distortion) CheckInRange("camera distortion coefficient", k, -1e3, 1e3);
}

CameraModel::CameraModel(const CameraIntrinsics& intrinsics) : intrinsics_(intrinsics) {
  CheckIntrinsics(intrinsics_);
  BuildRays();
}

void CameraModel::BuildRays() {
  const CameraIntrinsics& c = intrinsics_;
  std::vector<cv::Point2d> pixels;
  pixels.reserve(static_cast<std::size_t>(c.width_px) * c.height_px);
  for (int v = 0; v < c.height_px; ++v) {
    for (int u = 0; u < c.width_px; ++u) pixels.emplace_back(u, v);
  }
  std::vector<cv::Point2d> rays;
  if (IsUndistorted(c)) {
    for (const auto& p : pixels) {
      rays.emplace_back((p.x - c.cx_px) / c.fx_px, (p.y - c.cy_px) / c.fy_px);
    }
  } else {
    // Far more than OpenCV's default of 5 iterations: strong k1..k3 need them in the corners.
    const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 1e-9);
    cv::undistortPoints(pixels, rays, CameraMatrix(c), c.distortion, cv::noArray(), cv::noArray(),
                        until);
  }
  rays_.resize(rays.size());
  float left = std::numeric_limits<float>::max(), top = left;
  float right = std::numeric_limits<float>::lowest(), bottom = right;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    rays_[i] = Eigen::Vector2f(rays[i].x, rays[i].y);
    const auto u = static_cast<float>(rays[i].x * c.fx_px + c.cx_px);
    const auto v = static_cast<float>(rays[i].y * c.fy_px + c.cy_px);
    left = std::min(left, u), right = std::max(right, u);
    top = std::min(top, v), bottom = std::max(bottom, v);
  }
  undistorted_bounds_ = cv::Rect2f(left, top, right - left, bottom - top);
}

Eigen::Vector2d CameraModel::ProjectRaw(const Eigen::Vector3d& p_camera) const {
  if (IsUndistorted(intrinsics_)) return Project(p_camera);
  const std::vector<cv::Point3d> point{{p_camera.x(), p_camera.y(), p_camera.z()}};
  std::vector<cv::Point2d> pixel;
  const cv::Vec3d zero(0.0, 0.0, 0.0);
  cv::projectPoints(point, zero, zero, CameraMatrix(intrinsics_), intrinsics_.distortion, pixel);
  return {pixel[0].x, pixel[0].y};
}

Eigen::Vector2f CameraModel::Undistort(const Eigen::Vector2f& raw) const {
  const float u = std::clamp(raw.x(), 0.0f, static_cast<float>(intrinsics_.width_px - 1));
  const float v = std::clamp(raw.y(), 0.0f, static_cast<float>(intrinsics_.height_px - 1));
  const int u0 = std::min(static_cast<int>(u), intrinsics_.width_px - 2);
  const int v0 = std::min(static_cast<int>(v), intrinsics_.height_px - 2);
  const float du = u - static_cast<float>(u0), dv = v - static_cast<float>(v0);
  const Eigen::Vector2f top = (1.0f - du) * Ray(u0, v0) + du * Ray(u0 + 1, v0);
  const Eigen::Vector2f bottom = (1.0f - du) * Ray(u0, v0 + 1) + du * Ray(u0 + 1, v0 + 1);
  const Eigen::Vector2f ray = (1.0f - dv) * top + dv * bottom;
  return {static_cast<float>(ray.x() * intrinsics_.fx_px + intrinsics_.cx_px),
          static_cast<float>(ray.y() * intrinsics_.fy_px + intrinsics_.cy_px)};
}

}  // namespace semantic_slam
