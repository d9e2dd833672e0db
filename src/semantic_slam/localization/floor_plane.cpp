#include "semantic_slam/localization/floor_plane.h"

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>

namespace semantic_slam {
namespace {

constexpr int kStridePx = 8;
constexpr double kMaxDepthM = 4.0;  // farther readings are too noisy to tell a tilt
constexpr int kTries = 500;
constexpr double kMinHeightM = 0.2;
constexpr double kMinShare = 0.1;
const double kMaxTiltCosine = std::cos(50.0 * M_PI / 180.0);

struct Plane {
  Eigen::Vector3d normal;  // unit, upwards
  double offset;           // normal . p of its points; negative below the camera
};

std::vector<Eigen::Vector3d> Points(const RgbdImage& image, const CameraModel& camera) {
  std::vector<Eigen::Vector3d> points;
  for (int v = 0; v < image.depth_m.rows; v += kStridePx) {
    for (int u = 0; u < image.depth_m.cols; u += kStridePx) {
      const double z = image.depth_m.at<float>(v, u);
      if (!(z > 0.0 && z < kMaxDepthM)) continue;
      const Eigen::Vector2d ray = camera.Ray(u, v).cast<double>();
      points.emplace_back(ray.x() * z, ray.y() * z, z);
    }
  }
  return points;
}

// A centimetre near by, more where depth is noisier.
bool IsOn(const Plane& plane, const Eigen::Vector3d& point) {
  const double noise_m = 0.01 + 0.005 * point.z() * point.z();
  return std::abs(plane.normal.dot(point) - plane.offset) < noise_m;
}

bool IsLevelAndBelow(const Plane& plane, const Eigen::Vector3d& up) {
  return plane.normal.dot(up) >= kMaxTiltCosine && plane.offset <= -kMinHeightM;
}

// The plane through the points, with its normal on the side of `up`.
Plane Through(const Eigen::Vector3d& normal, const Eigen::Vector3d& point,
              const Eigen::Vector3d& up) {
  const Eigen::Vector3d upwards = normal.dot(up) < 0.0 ? Eigen::Vector3d(-normal) : normal;
  return {upwards, upwards.dot(point)};
}

std::vector<Eigen::Vector3d> PointsOn(const Plane& plane,
                                      const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> on;
  for (const Eigen::Vector3d& point : points) {
    if (IsOn(plane, point)) on.push_back(point);
  }
  return on;
}

// Least squares: the direction in which the points spread least.
Plane Fit(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& up) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    spread += (point - mean) * (point - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  return Through(solver.eigenvectors().col(0), mean, up);
}

}  // namespace

std::optional<Eigen::Vector3d> LevelSurfaceNormal(const RgbdImage& image, const CameraModel& camera,
                                                  const Eigen::Vector3d& expected_up_camera) {
  const Eigen::Vector3d up = expected_up_camera.normalized();
  const std::vector<Eigen::Vector3d> points = Points(image, camera);
  if (points.size() < 100) return std::nullopt;
  std::mt19937 random(1);
  std::uniform_int_distribution<std::size_t> pick(0, points.size() - 1);
  std::vector<Eigen::Vector3d> best;
  for (int i = 0; i < kTries; ++i) {
    const Eigen::Vector3d& a = points[pick(random)];
    const Eigen::Vector3d normal = (points[pick(random)] - a).cross(points[pick(random)] - a);
    if (normal.norm() < 1e-4) continue;  // nearly on one line
    const Plane plane = Through(normal.normalized(), a, up);
    if (!IsLevelAndBelow(plane, up)) continue;
    std::vector<Eigen::Vector3d> on = PointsOn(plane, points);
    if (on.size() > best.size()) best = std::move(on);
  }
  if (static_cast<double>(best.size()) < kMinShare * static_cast<double>(points.size())) {
    return std::nullopt;
  }
  const Plane refined = Fit(best, up);
  if (!IsLevelAndBelow(refined, up)) return std::nullopt;
  return refined.normal;
}

}  // namespace semantic_slam
