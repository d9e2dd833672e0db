#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace semantic_slam {

// Intrinsics of one camera, as in sensor_msgs/CameraInfo with plumb_bob or rational_polynomial.
struct CameraIntrinsics {
  int width_px = 0;
  int height_px = 0;
  double fx_px = 0.0;
  double fy_px = 0.0;
  double cx_px = 0.0;
  double cy_px = 0.0;
  // k1 k2 p1 p2 [k3 [k4 k5 k6]] in OpenCV's order; empty means no distortion.
  std::vector<double> distortion;
  // From the exposure of the first row to that of the last [s]: a rolling shutter. 0: all at once.
  // Negative: from bottom to top, or a recording that is played backwards.
  double readout_s = 0.0;
};

bool operator==(const CameraIntrinsics& a, const CameraIntrinsics& b);

// Throws ConfigError naming the first intrinsic that is not usable (a focal length of zero is what
// drivers send before calibration).
void CheckIntrinsics(const CameraIntrinsics& intrinsics);

// One calibrated camera: pinhole projection, lens distortion, and the table with the ray of every
// raw pixel through which everything 3D goes. Immutable, so safe from any thread.
//
// "Raw" pixels are the sensor's. "Undistorted" pixels are where an ideal pinhole camera with the
// same fx fy cx cy sees the same ray. Pixel (0, 0) is the centre of the top left pixel.
class CameraModel {
 public:
  // Throws ConfigError as CheckIntrinsics() does.
  explicit CameraModel(const CameraIntrinsics& intrinsics);

  const CameraIntrinsics& intrinsics() const { return intrinsics_; }
  int width_px() const { return intrinsics_.width_px; }
  int height_px() const { return intrinsics_.height_px; }
  bool Contains(const cv::Mat& image) const {
    return image.cols == intrinsics_.width_px && image.rows == intrinsics_.height_px;
  }

  // Undistorted pixel of a point in the optical frame (REP-103: z forward, x right, y down).
  // Precondition: p_camera.z() > 0.
  Eigen::Vector2d Project(const Eigen::Vector3d& p_camera) const {
    return {intrinsics_.fx_px * p_camera.x() / p_camera.z() + intrinsics_.cx_px,
            intrinsics_.fy_px * p_camera.y() / p_camera.z() + intrinsics_.cy_px};
  }

  // Raw pixel of a point in the optical frame. Precondition: p_camera.z() > 0.
  Eigen::Vector2d ProjectRaw(const Eigen::Vector3d& p_camera) const;

  // Point on the ray of the undistorted pixel (u, v) at depth z_m along the optical axis.
  Eigen::Vector3d Unproject(double u, double v, double z_m) const {
    return {(u - intrinsics_.cx_px) / intrinsics_.fx_px * z_m,
            (v - intrinsics_.cy_px) / intrinsics_.fy_px * z_m, z_m};
  }

  // Ray of a raw pixel: (x, y) of the point on it with z = 1 m. Multiply by depth for the point,
  // thesis eq. (3.16) with its ERRATA, and with the distortion.
  const Eigen::Vector2f& Ray(int u, int v) const {
    return rays_[static_cast<std::size_t>(v) * intrinsics_.width_px + u];
  }

  // Undistorted pixel of a raw one, between pixel centres too (bilinear in the ray table). Raw
  // coordinates are clamped to the image.
  Eigen::Vector2f Undistort(const Eigen::Vector2f& raw) const;

  // Where a raw row lies in the image: -0.5 the first .. 0.5 the last.
  double RowFraction(double raw_v) const { return raw_v / (intrinsics_.height_px - 1) - 0.5; }

  // The smallest box, in undistorted pixels, that holds the whole undistorted image.
  const cv::Rect2f& undistorted_bounds() const { return undistorted_bounds_; }

 private:
  void BuildRays();

  const CameraIntrinsics intrinsics_;
  std::vector<Eigen::Vector2f> rays_;  // row-major, one per raw pixel
  cv::Rect2f undistorted_bounds_;
};

}  // namespace semantic_slam
