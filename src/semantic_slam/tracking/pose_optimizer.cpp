#include "semantic_slam/tracking/pose_optimizer.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "semantic_slam/common/pose_covariance.h"
#include "semantic_slam/tracking/normal_equations.h"

namespace semantic_slam {
namespace {

constexpr int kRounds = 4;
constexpr int kRobustRounds = 3;  // in the last one only inliers are left
constexpr int kIterationsPerRound = 10;
constexpr double kMinDepthM = 0.05;
// A step must not look better because it throws points behind the camera.
constexpr double kCostBehindCamera = 1e4;
// With less the observations leave a part of the pose open.
constexpr double kMinConditioning = 1e-14;
// The mean of a squared normalised residual of a good measurement that passes for an inlier: of a
// chi-square distribution with 2 and 1 degrees of freedom that is cut at kChi2Pixel and kChi2Depth.
constexpr double kMeanChi2Pixel = 1.685;
constexpr double kMeanChi2Depth = 0.759;

struct State {
  Rigid3d T_camera_map = Rigid3d::Identity();
  Eigen::Vector3d turn_radps = Eigen::Vector3d::Zero();
};

class PoseProblem {
 public:
  PoseProblem(const std::vector<PoseObservation>& observations, const CameraModel& camera,
              const ObservationNoise& noise, const std::optional<RollingShutter>& shutter)
      : observations_(observations),
        camera_(camera),
        noise_(noise),
        shutter_(shutter),
        uses_pixel_(observations.size(), true),
        uses_depth_(observations.size()) {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      uses_depth_[i] = observations[i].depth_m > 0.0;
    }
  }

  // Linearised for a step d = (translation, rotation[, turn]): T_camera_map <- (I + d)
  // T_camera_map.
  template <int N>
  NormalEquations<N> Linearise(const State& state, bool robust) const {
    PointSums<N> sums;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      if (!uses_pixel_[i] && !uses_depth_[i]) continue;
      const Eigen::Vector3d p = PointAt(i, state);
      if (p.z() < kMinDepthM) {
        sums.cost += kCostBehindCamera;
        continue;
      }
      NormalEquations<3> point;
      if (uses_pixel_[i]) {
        point.Add<2>(PixelResidual(i, p), PixelJacobian(i, p), kChi2Pixel, robust);
      }
      if (uses_depth_[i]) {
        const Eigen::Matrix<double, 1, 3> J(0.0, 0.0,
                                            -1.0 / (p.z() * p.z() * noise_.InverseDepthSigma()));
        point.Add<1>(DepthResidual(i, p), J, kChi2Depth, robust);
      }
      sums.Add(point, p, N == 9 ? RowTime(i) : 0.0);
    }
    NormalEquations<N> equations = sums.Equations();
    if constexpr (N == 9) AddTurnPrior(state, equations);
    return equations;
  }

  // Sorts observations into those that fit the pose and those that do not.
  int Classify(const State& state) {
    int inliers = 0;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      const Eigen::Vector3d p = PointAt(i, state);
      const bool in_front = p.z() >= kMinDepthM;
      uses_pixel_[i] = in_front && PixelResidual(i, p).squaredNorm() <= kChi2Pixel;
      uses_depth_[i] = uses_pixel_[i] && observations_[i].depth_m > 0.0 &&
                       DepthResidual(i, p).squaredNorm() <= kChi2Depth;
      inliers += uses_pixel_[i];
    }
    return inliers;
  }

  const std::vector<bool>& inliers() const { return uses_pixel_; }

  // See PoseEstimate::covariance. The inverse of the inliers' information, for a step in the
  // camera's axes, and that turned into the map's.
  template <int N>
  Matrix6d Covariance(const State& state) const {
    const NormalEquations<N> equations = Linearise<N>(state, false);
    const Eigen::LDLT<Eigen::Matrix<double, N, N>> factors(equations.H);
    const Eigen::Matrix<double, N, 1> pivots = factors.vectorD();
    if (!(pivots.minCoeff() > kMinConditioning * pivots.maxCoeff())) {
      return Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    const Eigen::Matrix<double, N, N> inverse =
        factors.solve(Eigen::Matrix<double, N, N>::Identity());
    const Matrix6d covariance =
        VarianceFactor(state) * TurnedPoseCovariance(inverse.template topLeftCorner<6, 6>(),
                                                     state.T_camera_map.linear().transpose());
    return 0.5 * (covariance + covariance.transpose());
  }

  // By how much the pixels of the inliers ask for another readout time, whatever that does to the
  // pose. The turn is what the motion so far tells: one fitted to this image would take up the
  // answer.
  ReadoutEvidence Readout(const State& state) const {
    NormalEquations<7> equations;
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      if (!uses_pixel_[i]) continue;
      const State expected{state.T_camera_map, shutter_->twist.angular_velocity_radps};
      const Eigen::Vector3d p = PointAt(i, expected);
      if (p.z() < kMinDepthM) continue;
      Eigen::Matrix<double, 3, 7> dp;
      dp << PointJacobian(p), observations_[i].row_fraction * PointRate(p, expected);
      equations.Add<2>(PixelResidual(i, p), PixelJacobian(i, p) * dp, kChi2Pixel, false);
    }
    equations.H.diagonal().array() += 1e-9;
    const auto& H = equations.H;
    const Vector6d pose_share = H.topLeftCorner<6, 6>().ldlt().solve(H.topRightCorner<6, 1>());
    return {H(6, 6) - pose_share.dot(H.topRightCorner<6, 1>()),
            equations.b(6) - pose_share.dot(equations.b.head<6>())};
  }

 private:
  // By how much the inliers' errors are larger, squared, than the noise that was assumed.
  double VarianceFactor(const State& state) const {
    double sum = 0.0, expected = -6.0;  // as many degrees of freedom went into the pose
    for (std::size_t i = 0; i < observations_.size(); ++i) {
      const Eigen::Vector3d p = PointAt(i, state);
      if (uses_pixel_[i]) sum += PixelResidual(i, p).squaredNorm(), expected += kMeanChi2Pixel;
      if (uses_depth_[i]) sum += DepthResidual(i, p).squaredNorm(), expected += kMeanChi2Depth;
    }
    return expected > 0.0 ? sum / expected : std::numeric_limits<double>::quiet_NaN();
  }

  // How fast a point moves in the camera's frame.
  Eigen::Vector3d PointRate(const Eigen::Vector3d& p, const State& state) const {
    return -state.turn_radps.cross(p) - shutter_->twist.velocity_mps;
  }

  // The point in the camera's frame when its row was exposed.
  Eigen::Vector3d PointAt(std::size_t i, const State& state) const {
    const Eigen::Vector3d p = state.T_camera_map * observations_[i].p_map;
    return shutter_ ? Eigen::Vector3d(p + RowTime(i) * PointRate(p, state)) : p;
  }

  double RowTime(std::size_t i) const {
    return observations_[i].row_fraction * shutter_->readout_s;
  }

  static Eigen::Matrix<double, 3, 6> PointJacobian(const Eigen::Vector3d& p) {
    Eigen::Matrix<double, 3, 6> dp;
    dp << Eigen::Matrix3d::Identity(), -Skew(p);
    return dp;
  }

  void AddTurnPrior(const State& state, NormalEquations<9>& equations) const {
    const Eigen::Vector3d error =
        (state.turn_radps - shutter_->twist.angular_velocity_radps) / shutter_->turn_sigma_radps;
    Eigen::Matrix<double, 3, 9> J = Eigen::Matrix<double, 3, 9>::Zero();
    J.rightCols<3>().diagonal().setConstant(1.0 / shutter_->turn_sigma_radps);
    equations.Add<3>(error, J, 0.0, false);
  }

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
  const std::optional<RollingShutter>& shutter_;
  std::vector<bool> uses_pixel_;
  std::vector<bool> uses_depth_;
};

template <int N>
State Step(const Eigen::Matrix<double, N, 1>& d, const State& state) {
  Rigid3d step = Rigid3d::Identity();
  step.linear() = ExpSo3(d.template segment<3>(3));
  step.translation() = d.template head<3>();
  State next{step * state.T_camera_map, state.turn_radps};
  if constexpr (N == 9) next.turn_radps += d.template tail<3>();
  return next;
}

template <int N>
State Minimise(const PoseProblem& problem, State state, bool robust) {
  double lambda = 1e-4;
  NormalEquations<N> equations = problem.Linearise<N>(state, robust);
  for (int iteration = 0; iteration < kIterationsPerRound; ++iteration) {
    Eigen::Matrix<double, N, N> damped = equations.H;
    damped.diagonal() *= 1.0 + lambda;
    damped.diagonal().array() += 1e-9;  // solvable even where nothing was observed
    const Eigen::Matrix<double, N, 1> d = damped.ldlt().solve(equations.b);
    if (!d.allFinite()) break;
    const State candidate = Step<N>(d, state);
    NormalEquations<N> next = problem.Linearise<N>(candidate, robust);
    if (next.cost <= equations.cost) {
      const double decrease = equations.cost - next.cost;
      state = candidate;
      equations = next;
      lambda = std::max(lambda * 0.1, 1e-9);
      if (decrease < 1e-6 * equations.cost || d.norm() < 1e-8) break;
    } else {
      lambda *= 10.0;
      if (lambda > 1e6) break;
    }
  }
  return state;
}

}  // namespace

PoseEstimate OptimizePose(const std::vector<PoseObservation>& observations,
                          const Rigid3d& T_map_camera_start, const CameraModel& camera,
                          const ObservationNoise& noise,
                          const std::optional<RollingShutter>& shutter) {
  PoseProblem problem(observations, camera, noise, shutter);
  State state{T_map_camera_start.inverse()};
  PoseEstimate estimate;
  if (shutter) {
    estimate.twist = shutter->twist;
    state.turn_radps = shutter->twist.angular_velocity_radps;
  }
  for (int round = 0; round < kRounds; ++round) {
    const bool robust = round < kRobustRounds;
    state = shutter ? Minimise<9>(problem, state, robust) : Minimise<6>(problem, state, robust);
    estimate.inliers = problem.Classify(state);
  }
  estimate.T_map_camera = Orthonormalised(state.T_camera_map.inverse());
  estimate.is_inlier = problem.inliers();
  estimate.covariance = shutter ? problem.Covariance<9>(state) : problem.Covariance<6>(state);
  if (shutter) {
    estimate.twist.angular_velocity_radps = state.turn_radps;
    estimate.readout = problem.Readout(state);
  }
  return estimate;
}

}  // namespace semantic_slam
