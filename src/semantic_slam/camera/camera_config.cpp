#include "semantic_slam/camera/camera_config.h"

#include <Eigen/LU>

#include "semantic_slam/common/check.h"

namespace semantic_slam {
namespace {

CameraIntrinsics ReadIntrinsics(YamlReader group) {
  CameraIntrinsics c;
  c.width_px = group.Require<int>("width_px");
  c.height_px = group.Require<int>("height_px");
  c.fx_px = group.Require<double>("fx_px");
  c.fy_px = group.Require<double>("fy_px");
  c.cx_px = group.Require<double>("cx_px");
  c.cy_px = group.Require<double>("cy_px");
  group.Read("distortion", c.distortion);
  group.Read("readout_s", c.readout_s);
  group.Finish();
  return c;
}

Eigen::Matrix3d ToRotation(const std::vector<double>& rows) {
  if (rows.size() != 9) {
    throw ConfigError("imu/R_camera_imu has " + std::to_string(rows.size()) +
                      " numbers, expected 9 (rows of a rotation)");
  }
  const Eigen::Matrix3d R =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data());
  // 1e-3: hand-written rotations are rounded to a few digits.
  if (!((R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-3 && R.determinant() > 0)) {
    throw ConfigError("imu/R_camera_imu is not a rotation");
  }
  return R;
}

}  // namespace

CameraConfig ReadCameraConfig(YamlReader& file) {
  CameraConfig config;
  config.intrinsics = ReadIntrinsics(file.Group("camera"));
  std::vector<double> rotation_rows{1, 0, 0, 0, 1, 0, 0, 0, 1};
  YamlReader imu = file.Group("imu");
  imu.Read("R_camera_imu", rotation_rows);
  imu.Finish();
  YamlReader dataset = file.Group("dataset");
  dataset.Read("depth_png_factor", config.depth_png_factor);
  dataset.Finish();
  try {
    CheckIntrinsics(config.intrinsics);
    config.R_camera_imu = ToRotation(rotation_rows);
    CheckInRange("dataset/depth_png_factor", config.depth_png_factor, 1.0, 1e6);
  } catch (const ConfigError& e) {
    throw ConfigError(file.path() + ": " + e.what());
  }
  return config;
}

CameraConfig LoadCameraConfig(const std::string& path) {
  YamlReader file(LoadYamlMap(path), path);
  return ReadCameraConfig(file);
}

}  // namespace semantic_slam
