#include "semantic_slam/tracking/pose_optimizer.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace semantic_slam {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using RowVector6d = Eigen::Matrix<double, 1, 6>;

constexpr int kRounds = 4;
constexpr int kRobustRounds = 3;  // in the last one only inliers are left
constexpr int kIterationsPerRound = 10;
constexpr double kMinDepthM = 0.05;
// A step must not look better because it throws points behind the camera.
constexpr double kCostBehindCamera = 1e4;

struct NormalEquations {
  Matrix6d H = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  double cost = 0.0;

  // One block of residuals `r` with Jacobian `J` under a Huber kernel that bends at chi2 = `bend`.
  template <int Rows>
  void Add(const Eigen::Matrix<double, Rows, 1>& r, const Eigen::Matrix<double, Rows, 6>& J,
           double bend, bool robust) {
    const double chi2 = r.squaredNorm();
    double weight = 1.0;
    if (robust && chi2 > bend) {
      weight = std::sqrt(bend / chi2);
      cost += 2.0 * std::sqrt(bend * chi2) - bend;
    } else {
      cost += chi2;
    }
    H.noalias() += weight * J.transpose() * J;
    b.noalias() -= weight * J.transpose() * r;
  }
};

class PoseProblem {
 public:
  PoseProblem(const std::vector<PoseObservation>& observations, const CameraModel& camera,
              const ObservationNoise& noise)
      : observations_(observations), camera_(camera), noise_(noise),
        uses_pixel_(observations.size(), true), uses_depth_(observations.size()) {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      uses_depth_[i] = observations[i].depth_m > 0.0;
    }
  }

  // Linearised at T_camera_map for a step d = (translation, rotation): T <- (I + d) T.
  NormalEquations Linearise(const Rigid3d& T_camera_map, bool robust) const {
    NormalEquations equations;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      if (!uses_pixel_[i] && !uses_depth_[i]) continue;
      const Eigen::Vector3d p = T_camera_map * observations_[i].p_map;
      if (p.z() < kMinDepthM) {
        equations.cost += kCostBehindCamera;
        continue;
      }
      Eigen::Matrix<double, 3, 6> dp;
      dp << Eigen::Matrix3d::Identity(), -Skew(p);
      if (uses_pixel_[i]) {
        equations.Add<2>(PixelResidual(i, p), PixelJacobian(i, p) * dp, kChi2Pixel, robust);
      }
      if (uses_depth_[i]) {
        const RowVector6d J =
            -dp.row(2) / (p.z() * p.z() * noise_.InverseDepthSigma());
        equations.Add<1>(DepthResidual(i, p), J, kChi2Depth, robust);
      }
    }
    return equations;
  }

  // Sorts observations into those that fit the pose and those that do not.
  int Classify(const Rigid3d& T_camera_map) {
    int inliers = 0;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      const Eigen::Vector3d p = T_camera_map * observations_[i].p_map;
      const bool in_front = p.z() >= kMinDepthM;
      uses_pixel_[i] = in_front && PixelResidual(i, p).squaredNorm() <= kChi2Pixel;
      uses_depth_[i] = uses_pixel_[i] && observations_[i].depth_m > 0.0 &&
                       DepthResidual(i, p).squaredNorm() <= kChi2Depth;
      inliers += uses_pixel_[i];
    }
    return inliers;
  }

  const std::vector<bool>& inliers() const { return uses_pixel_; }

 private:
  Eigen::Vector2d PixelResidual(std::size_t i, const Eigen::Vector3d& p) const {
    return (camera_.Project(p) - observations_[i].pixel) /
           noise_.PixelSigma(observations_[i].pyramid_scale);
  }

  Eigen::Matrix<double, 2, 3> PixelJacobian(std::size_t i, const Eigen::Vector3d& p) const {
    const double sigma = noise_.PixelSigma(observations_[i].pyramid_scale);
    const double fx = camera_.intrinsics().fx_px / (p.z() * sigma);
    const double fy = camera_.intrinsics().fy_px / (p.z() * sigma);
    Eigen::Matrix<double, 2, 3> J;
    J << fx, 0.0, -fx * p.x() / p.z(), 0.0, fy, -fy * p.y() / p.z();
    return J;
  }

  Eigen::Matrix<double, 1, 1> DepthResidual(std::size_t i, const Eigen::Vector3d& p) const {
    return Eigen::Matrix<double, 1, 1>((1.0 / p.z() - 1.0 / observations_[i].depth_m) /
                                       noise_.InverseDepthSigma());
  }

  const std::vector<PoseObservation>& observations_;
  const CameraModel& camera_;
  const ObservationNoise& noise_;
  std::vector<bool> uses_pixel_;
  std::vector<bool> uses_depth_;
};

Rigid3d Step(const Vector6d& d, const Rigid3d& T_camera_map) {
  Rigid3d step = Rigid3d::Identity();
  step.linear() = ExpSo3(d.tail<3>());
  step.translation() = d.head<3>();
  return step * T_camera_map;
}

Rigid3d Minimise(const PoseProblem& problem, Rigid3d T_camera_map, bool robust) {
  double lambda = 1e-4;
  NormalEquations equations = problem.Linearise(T_camera_map, robust);
  for (int iteration = 0; iteration < kIterationsPerRound; ++iteration) {
    Matrix6d damped = equations.H;
    damped.diagonal() *= 1.0 + lambda;
    damped.diagonal().array() += 1e-9;  // solvable even where nothing was observed
    const Vector6d d = damped.ldlt().solve(equations.b);
    if (!d.allFinite()) break;
    const Rigid3d candidate = Step(d, T_camera_map);
    NormalEquations next = problem.Linearise(candidate, robust);
    if (next.cost <= equations.cost) {
      const double decrease = equations.cost - next.cost;
      T_camera_map = candidate;
      equations = next;
      lambda = std::max(lambda * 0.1, 1e-9);
      if (decrease < 1e-6 * equations.cost || d.norm() < 1e-8) break;
    } else {
      lambda *= 10.0;
      if (lambda > 1e6) break;
    }
  }
  return T_camera_map;
}

}  // namespace

PoseEstimate OptimizePose(const std::vector<PoseObservation>& observations,
                          const Rigid3d& T_map_camera_start, const CameraModel& camera,
                          const ObservationNoise& noise) {
  PoseProblem problem(observations, camera, noise);
  Rigid3d T_camera_map = T_map_camera_start.inverse();
  PoseEstimate estimate;
  for (int round = 0; round < kRounds; ++round) {
    T_camera_map = Minimise(problem, T_camera_map, round < kRobustRounds);
    estimate.inliers = problem.Classify(T_camera_map);
  }
  estimate.T_map_camera = Orthonormalised(T_camera_map.inverse());
  estimate.is_inlier = problem.inliers();
  return estimate;
}

}  // namespace semantic_slam
