#include "semantic_slam/local_mapping/bundle_adjustment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <ceres/ceres.h>

namespace semantic_slam {
namespace {

constexpr double kMinDepthM = 0.05;

// A camera as Ceres sees it: rotation vector of R_camera_map, then t_camera_map.
using CameraBlock = std::array<double, 6>;

CameraBlock ToBlock(const Rigid3d& T_map_camera) {
  const Rigid3d T_camera_map = T_map_camera.inverse();
  const Eigen::AngleAxisd rotation(T_camera_map.linear());
  CameraBlock block;
  Eigen::Map<Eigen::Vector3d>(block.data()) = rotation.angle() * rotation.axis();
  Eigen::Map<Eigen::Vector3d>(block.data() + 3) = T_camera_map.translation();
  return block;
}

Rigid3d FromBlock(const CameraBlock& block) {
  Rigid3d T_camera_map = Rigid3d::Identity();
  T_camera_map.linear() = ExpSo3(Eigen::Map<const Eigen::Vector3d>(block.data()));
  T_camera_map.translation() = Eigen::Map<const Eigen::Vector3d>(block.data() + 3);
  return Orthonormalised(T_camera_map.inverse());
}

// Left Jacobian of SO(3): d(exp(w) p)/dw = -[exp(w) p]x * LeftJacobian(w).
Eigen::Matrix3d LeftJacobian(const Eigen::Vector3d& w) {
  const double angle = w.norm();
  const Eigen::Matrix3d W = Skew(w);
  if (angle < 1e-6) return Eigen::Matrix3d::Identity() + 0.5 * W;
  const double a2 = angle * angle;
  return Eigen::Matrix3d::Identity() + (1.0 - std::cos(angle)) / a2 * W +
         (angle - std::sin(angle)) / (a2 * angle) * W * W;
}

// The point in the camera frame, with derivatives by rotation vector and point.
struct CameraPoint {
  Eigen::Vector3d p;
  Eigen::Matrix3d R_camera_map;
  Eigen::Matrix3d dp_dw;

  CameraPoint(const double* camera, const double* point, bool with_derivative) {
    const Eigen::Map<const Eigen::Vector3d> w(camera), t(camera + 3), p_map(point);
    R_camera_map = ExpSo3(w);
    const Eigen::Vector3d rotated = R_camera_map * p_map;
    p = rotated + t;
    if (with_derivative) dp_dw = -Skew(rotated) * LeftJacobian(w);
  }

  // Chain rule for Rows residuals with derivative J_p by p; Ceres' blocks are row-major.
  template <int Rows>
  void FillJacobians(const Eigen::Matrix<double, Rows, 3>& J_p, double** jacobians) const {
    if (jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, Rows, 6, Eigen::RowMajor>> J(jacobians[0]);
      J.template leftCols<3>() = J_p * dp_dw;
      J.template rightCols<3>() = J_p;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, Rows, 3, Eigen::RowMajor>> J(jacobians[1]);
      J = J_p * R_camera_map;
    }
  }
};

// (projected - measured) / sigma, in pixels.
class PixelCost : public ceres::SizedCostFunction<2, 6, 3> {
 public:
  PixelCost(const CameraIntrinsics& intrinsics, const Eigen::Vector2d& pixel, double sigma)
      : fx_(intrinsics.fx_px / sigma), fy_(intrinsics.fy_px / sigma),
        x_((pixel.x() - intrinsics.cx_px) / intrinsics.fx_px),
        y_((pixel.y() - intrinsics.cy_px) / intrinsics.fy_px) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const CameraPoint c(parameters[0], parameters[1], jacobians != nullptr);
    if (c.p.z() < kMinDepthM) return Vanish(residuals, jacobians);
    const double inverse_z = 1.0 / c.p.z();
    residuals[0] = fx_ * (c.p.x() * inverse_z - x_);
    residuals[1] = fy_ * (c.p.y() * inverse_z - y_);
    if (jacobians == nullptr) return true;
    Eigen::Matrix<double, 2, 3> J_p;
    J_p << fx_ * inverse_z, 0.0, -fx_ * c.p.x() * inverse_z * inverse_z,  //
        0.0, fy_ * inverse_z, -fy_ * c.p.y() * inverse_z * inverse_z;
    c.FillJacobians<2>(J_p, jacobians);
    return true;
  }

 private:
  // A point behind the camera has no pixel: it neither pulls nor stops the others.
  static bool Vanish(double* residuals, double** jacobians) {
    residuals[0] = residuals[1] = 0.0;
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) std::fill_n(jacobians[0], 12, 0.0);
    if (jacobians[1] != nullptr) std::fill_n(jacobians[1], 6, 0.0);
    return true;
  }

  const double fx_, fy_, x_, y_;
};

// (1 / z - 1 / measured) / sigma.
class DepthCost : public ceres::SizedCostFunction<1, 6, 3> {
 public:
  DepthCost(double depth_m, double inverse_depth_sigma)
      : inverse_depth_(1.0 / depth_m), weight_(1.0 / inverse_depth_sigma) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const CameraPoint c(parameters[0], parameters[1], jacobians != nullptr);
    const double z = std::max(c.p.z(), kMinDepthM);
    residuals[0] = weight_ * (1.0 / z - inverse_depth_);
    if (jacobians == nullptr) return true;
    const Eigen::Matrix<double, 1, 3> J_p(0.0, 0.0, -weight_ / (z * z));
    c.FillJacobians<1>(J_p, jacobians);
    return true;
  }

 private:
  const double inverse_depth_, weight_;
};

class BundleSolver {
 public:
  BundleSolver(BundleProblem& bundle, const CameraModel& camera, const BundleOptions& options)
      : bundle_(bundle), camera_(camera), options_(options),
        uses_pixel_(bundle.observations.size(), true), uses_depth_(bundle.observations.size()) {
    for (const BundleCamera& c : bundle.cameras) blocks_.push_back(ToBlock(c.T_map_camera));
    for (std::size_t i = 0; i < bundle.observations.size(); ++i) {
      uses_depth_[i] = bundle.observations[i].depth_m > 0.0;
    }
  }

  BundleSummary Solve() {
    BundleSummary summary;
    const auto first = SolveOnce(options_.robust_iterations, true);
    summary.initial_cost = first.initial_cost;
    Classify();
    summary.final_cost = SolveOnce(options_.final_iterations, false).final_cost;
    Classify();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (!bundle_.cameras[i].fixed) bundle_.cameras[i].T_map_camera = FromBlock(blocks_[i]);
    }
    summary.is_inlier = uses_pixel_;
    return summary;
  }

 private:
  ceres::Solver::Summary SolveOnce(int iterations, bool robust) {
    ceres::Problem::Options problem_options;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::HuberLoss pixel_loss(std::sqrt(kChi2Pixel)), depth_loss(std::sqrt(kChi2Depth));
    ceres::Problem problem(problem_options);
    auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    AddResiduals(problem, *ordering, robust ? &pixel_loss : nullptr,
                 robust ? &depth_loss : nullptr);
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (!problem.HasParameterBlock(blocks_[i].data())) continue;
      ordering->AddElementToGroup(blocks_[i].data(), 1);
      if (bundle_.cameras[i].fixed) problem.SetParameterBlockConstant(blocks_[i].data());
    }
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    solver.linear_solver_ordering = ordering;
    solver.num_threads = 1;
    solver.max_num_iterations = iterations;
    solver.function_tolerance = 1e-5;
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    return summary;
  }

  void AddResiduals(ceres::Problem& problem, ceres::ParameterBlockOrdering& ordering,
                    ceres::LossFunction* pixel_loss, ceres::LossFunction* depth_loss) {
    const CameraIntrinsics& intrinsics = camera_.intrinsics();
    std::vector<bool> is_used(bundle_.points.size(), false);
    for (std::size_t i = 0; i < bundle_.observations.size(); ++i) {
      const BundleObservation& o = bundle_.observations[i];
      double* point = bundle_.points[o.point].data();
      double* camera = blocks_[o.camera].data();
      if (uses_pixel_[i]) {
        problem.AddResidualBlock(
            new PixelCost(intrinsics, o.pixel, options_.noise.PixelSigma(o.pyramid_scale)),
            pixel_loss, camera, point);
      }
      if (uses_depth_[i]) {
        problem.AddResidualBlock(new DepthCost(o.depth_m, options_.noise.InverseDepthSigma()),
                                 depth_loss, camera, point);
      }
      is_used[o.point] = is_used[o.point] || uses_pixel_[i] || uses_depth_[i];
    }
    for (std::size_t p = 0; p < is_used.size(); ++p) {
      if (is_used[p]) ordering.AddElementToGroup(bundle_.points[p].data(), 0);
    }
  }

  void Classify() {
    std::vector<Rigid3d> T_camera_map;
    for (const CameraBlock& block : blocks_) T_camera_map.push_back(FromBlock(block).inverse());
    for (std::size_t i = 0; i < bundle_.observations.size(); ++i) {
      const BundleObservation& o = bundle_.observations[i];
      const Eigen::Vector3d p = T_camera_map[o.camera] * bundle_.points[o.point];
      uses_pixel_[i] = p.z() >= kMinDepthM &&
                       ((camera_.Project(p) - o.pixel) / options_.noise.PixelSigma(o.pyramid_scale))
                               .squaredNorm() <= kChi2Pixel;
      const double depth_error =
          (1.0 / p.z() - 1.0 / o.depth_m) / options_.noise.InverseDepthSigma();
      uses_depth_[i] =
          uses_pixel_[i] && o.depth_m > 0.0 && depth_error * depth_error <= kChi2Depth;
    }
  }

  BundleProblem& bundle_;
  const CameraModel& camera_;
  const BundleOptions& options_;
  std::vector<CameraBlock> blocks_;
  std::vector<bool> uses_pixel_;
  std::vector<bool> uses_depth_;
};

}  // namespace

BundleSummary AdjustBundle(BundleProblem& problem, const CameraModel& camera,
                           const BundleOptions& options) {
  return BundleSolver(problem, camera, options).Solve();
}

}  // namespace semantic_slam
