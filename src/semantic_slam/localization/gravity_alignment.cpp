#include "semantic_slam/localization/gravity_alignment.h"

#include <cmath>

#include "semantic_slam/camera/level_frame.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/localization/floor_plane.h"

namespace semantic_slam {
namespace {

constexpr double kStandardGravity = 9.81;
constexpr double kGravityTolerance = 0.2;  // share; hand-held cameras shake
constexpr int kMinReadings = 3;

}  // namespace

Rigid3d StartPoseFromUp(const Eigen::Vector3d& up_camera) {
  if (!up_camera.allFinite() || up_camera.norm() < 1e-6) {
    throw InputError("the direction of gravity is not finite or has length zero");
  }
  Rigid3d T_map_camera = Rigid3d::Identity();
  T_map_camera.linear() = LevelFromCamera(up_camera.normalized());
  return T_map_camera;
}

std::optional<Eigen::Vector3d> MeanAcceleration(const std::vector<AccelerometerReading>& readings,
                                                Stamp stamp, double window_s) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const AccelerometerReading& reading : readings) {
    if (!reading.acceleration_imu.allFinite()) continue;
    if (std::abs(SecondsBetween(stamp, reading.stamp)) > window_s) continue;
    sum += reading.acceleration_imu;
    ++count;
  }
  if (count < kMinReadings) return std::nullopt;
  const Eigen::Vector3d mean = sum / count;
  if (std::abs(mean.norm() - kStandardGravity) > kGravityTolerance * kStandardGravity) {
    return std::nullopt;
  }
  return mean;
}

MapStart FindMapStart(const std::optional<Eigen::Vector3d>& up_by_imu_camera,
                      const RgbdImage& image, const CameraModel& camera,
                      const Rigid3d& T_base_camera) {
  CheckRgbdImage(image, camera);
  const auto upright = [&](const Eigen::Vector3d& up_camera) {
    Rigid3d T_map_base = Rigid3d::Identity();
    T_map_base.linear() =
        StartPoseFromUp(up_camera).linear() * T_base_camera.linear().transpose();
    return T_map_base * T_base_camera;
  };
  if (up_by_imu_camera) return {upright(*up_by_imu_camera), "up from the imu"};
  const Eigen::Vector3d up_if_level = T_base_camera.linear().transpose().col(2);
  if (const auto normal = LevelSurfaceNormal(image, camera, up_if_level)) {
    return {upright(*normal), "up from a level surface in view"};
  }
  return {T_base_camera, "the base is taken to stand level"};
}

}  // namespace semantic_slam
