#include "semantic_slam/local_mapping/bundle_adjustment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
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

// exp(w) and the left Jacobian of SO(3): d(exp(w) p)/dw = -[exp(w) p]x * J.
struct RotationTerms {
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();

  void Set(const Eigen::Vector3d& rotation_vector) {
    w = rotation_vector;
    R = ExpSo3(w);
    const double angle = w.norm();
    const Eigen::Matrix3d W = Skew(w);
    J = Eigen::Matrix3d::Identity();
    if (angle < 1e-6) {
      J += 0.5 * W;
    } else {
      const double a2 = angle * angle;
      J += (1.0 - std::cos(angle)) / a2 * W + (angle - std::sin(angle)) / (a2 * angle) * W * W;
    }
  }
};

// How far a point in a camera is from where a feature saw it. All costs have two rows, and with
// that all blocks one shape, for which Ceres has unrolled its Schur complement.
constexpr int kRows = 2;
using PointJacobian = Eigen::Matrix<double, kRows, 3>;

// (projected - measured) / sigma, in pixels.
class PixelError {
 public:
  PixelError(const CameraIntrinsics& intrinsics, const Eigen::Vector2d& pixel, double sigma)
      : fx_(intrinsics.fx_px / sigma),
        fy_(intrinsics.fy_px / sigma),
        x_((pixel.x() - intrinsics.cx_px) / intrinsics.fx_px),
        y_((pixel.y() - intrinsics.cy_px) / intrinsics.fy_px) {}

  void Evaluate(const Eigen::Vector3d& p, double* residuals, PointJacobian& J_p) const {
    if (p.z() < kMinDepthM) {
      // Behind the camera there is no pixel: it neither pulls nor stops the others.
      std::fill_n(residuals, kRows, 0.0);
      J_p.setZero();
      return;
    }
    const double inverse_z = 1.0 / p.z();
    residuals[0] = fx_ * (p.x() * inverse_z - x_);
    residuals[1] = fy_ * (p.y() * inverse_z - y_);
    J_p << fx_ * inverse_z, 0.0, -fx_ * p.x() * inverse_z * inverse_z,  //
        0.0, fy_ * inverse_z, -fy_ * p.y() * inverse_z * inverse_z;
  }

 private:
  double fx_, fy_, x_, y_;
};

// (1 / z - 1 / measured) / sigma, and a row of zeros.
class DepthError {
 public:
  DepthError(double depth_m, double inverse_depth_sigma)
      : inverse_depth_(1.0 / depth_m), weight_(1.0 / inverse_depth_sigma) {}

  void Evaluate(const Eigen::Vector3d& p, double* residuals, PointJacobian& J_p) const {
    const double z = std::max(p.z(), kMinDepthM);
    residuals[0] = weight_ * (1.0 / z - inverse_depth_);
    residuals[1] = 0.0;
    J_p << 0.0, 0.0, -weight_ / (z * z), 0.0, 0.0, 0.0;
  }

 private:
  double inverse_depth_, weight_;
};

// An error as a function of the camera's block and the point. All costs of one camera share the
// terms of its rotation, which are computed once per step instead of once per observation: for one
// thread.
template <typename Error>
class ObservationCost : public ceres::SizedCostFunction<kRows, 6, 3> {
 public:
  ObservationCost(const Error& error, RotationTerms& rotation)
      : error_(error), rotation_(rotation) {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Map<const Eigen::Vector3d> w(parameters[0]), t(parameters[0] + 3);
    const Eigen::Map<const Eigen::Vector3d> p_map(parameters[1]);
    if (w != rotation_.w) rotation_.Set(w);
    const Eigen::Vector3d rotated = rotation_.R * p_map;
    PointJacobian J_p;
    error_.Evaluate(rotated + t, residuals, J_p);
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {  // Ceres' blocks are row-major
      Eigen::Map<Eigen::Matrix<double, kRows, 6, Eigen::RowMajor>> J(jacobians[0]);
      J.leftCols<3>() = -J_p * Skew(rotated) * rotation_.J;
      J.rightCols<3>() = J_p;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, kRows, 3, Eigen::RowMajor>> J(jacobians[1]);
      J = J_p * rotation_.R;
    }
    return true;
  }

 private:
  const Error error_;
  RotationTerms& rotation_;
};

class BundleSolver {
 public:
  BundleSolver(BundleProblem& bundle, const CameraModel& camera, const BundleOptions& options)
      : bundle_(bundle),
        camera_(camera),
        options_(options),
        rotations_(bundle.cameras.size()),
        uses_pixel_(bundle.observations.size(), true),
        uses_depth_(bundle.observations.size()) {
    for (const BundleCamera& c : bundle.cameras) blocks_.push_back(ToBlock(c.T_map_camera));
    MakeCosts();
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
  void MakeCosts() {
    const ObservationNoise& noise = options_.noise;
    for (std::size_t i = 0; i < bundle_.observations.size(); ++i) {
      const BundleObservation& o = bundle_.observations[i];
      RotationTerms& rotation = rotations_[o.camera];
      const PixelError pixel(camera_.intrinsics(), o.pixel, noise.PixelSigma(o.pyramid_scale));
      pixel_costs_.emplace_back(pixel, rotation);
      depth_costs_.emplace_back(DepthError(o.depth_m, noise.InverseDepthSigma()), rotation);
      uses_depth_[i] = o.depth_m > 0.0;
    }
  }

  ceres::Solver::Summary SolveOnce(int iterations, bool robust) {
    ceres::Problem::Options problem_options;
    problem_options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    problem_options.disable_all_safety_checks = true;  // the blocks are ours, and apart
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
    std::vector<bool> is_used(bundle_.points.size(), false);
    for (std::size_t i = 0; i < bundle_.observations.size(); ++i) {
      const BundleObservation& o = bundle_.observations[i];
      double* point = bundle_.points[o.point].data();
      double* camera = blocks_[o.camera].data();
      if (uses_pixel_[i]) problem.AddResidualBlock(&pixel_costs_[i], pixel_loss, camera, point);
      if (uses_depth_[i]) problem.AddResidualBlock(&depth_costs_[i], depth_loss, camera, point);
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
      uses_depth_[i] = uses_pixel_[i] && o.depth_m > 0.0 && depth_error * depth_error <= kChi2Depth;
    }
  }

  BundleProblem& bundle_;
  const CameraModel& camera_;
  const BundleOptions& options_;
  std::vector<CameraBlock> blocks_;
  std::vector<RotationTerms> rotations_;                 // per camera
  std::deque<ObservationCost<PixelError>> pixel_costs_;  // per observation; they cannot move
  std::deque<ObservationCost<DepthError>> depth_costs_;  // per observation
  std::vector<bool> uses_pixel_;
  std::vector<bool> uses_depth_;
};

}  // namespace

BundleSummary AdjustBundle(BundleProblem& problem, const CameraModel& camera,
                           const BundleOptions& options) {
  return BundleSolver(problem, camera, options).Solve();
}

}  // namespace semantic_slam
