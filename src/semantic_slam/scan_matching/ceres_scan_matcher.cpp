#include "semantic_slam/scan_matching/ceres_scan_matcher.h"

#include <array>
#include <cmath>

#include <ceres/ceres.h>
#include <ceres/cubic_interpolation.h>

namespace semantic_slam {
namespace {

using PoseParameters = std::array<double, 3>;  // x, y [m], yaw [rad]

// The grid as Ceres' interpolator wants it: rows are y, columns are x, a cell's value lies at its
// index.
class HitProbabilityGrid {
 public:
  enum { DATA_DIMENSION = 1 };
  explicit HitProbabilityGrid(const ProbabilityGrid& grid) : grid_(grid) {}
  void GetValue(int row, int column, double* value) const {
    *value = HitProbability(grid_.At({column, row}));
  }

 private:
  const ProbabilityGrid& grid_;
};

// One residual per hit: how improbable it is that something stands where it ended. Hess et al.,
// eq. (CS), with weights that do not depend on the number of hits.
class FitCost : public ceres::CostFunction {
 public:
  FitCost(const PlanarPoints& points, const ProbabilityGrid& grid, double weight)
      : points_(points),
        grid_(grid),
        interpolator_(grid_),
        resolution_m_(grid.resolution_m()),
        weight_(weight / std::sqrt(static_cast<double>(points.size()))) {
    set_num_residuals(static_cast<int>(points.size()));
    mutable_parameter_block_sizes()->push_back(3);
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const double* pose = parameters[0];
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(pose[2]).toRotationMatrix();
    double* jacobian = jacobians != nullptr ? jacobians[0] : nullptr;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector2d turned = R * points_[i];
      const Eigen::Vector2d cell =
          ((turned + Eigen::Vector2d(pose[0], pose[1])) / resolution_m_).array() - 0.5;
      double probability, d_row, d_column;
      interpolator_.Evaluate(cell.y(), cell.x(), &probability, &d_row, &d_column);
      residuals[i] = weight_ * (1.0 - probability);
      if (jacobian == nullptr) continue;
      const double d_x = -weight_ * d_column / resolution_m_;
      const double d_y = -weight_ * d_row / resolution_m_;
      double* row = jacobian + 3 * i;
      row[0] = d_x;
      row[1] = d_y;
      row[2] = -turned.y() * d_x + turned.x() * d_y;
    }
    return true;
  }

 private:
  const PlanarPoints& points_;
  const HitProbabilityGrid grid_;
  const ceres::BiCubicInterpolator<HitProbabilityGrid> interpolator_;
  const double resolution_m_;
  const double weight_;
};

// Holds the pose where it is expected.
class PriorCost : public ceres::SizedCostFunction<3, 3> {
 public:
  PriorCost(const PoseParameters& expected, double translation_weight, double rotation_weight)
      : expected_(expected), weights_{translation_weight, translation_weight, rotation_weight} {}

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    for (int i = 0; i < 3; ++i) residuals[i] = weights_[i] * (parameters[0][i] - expected_[i]);
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    for (int i = 0; i < 9; ++i) jacobians[0][i] = i % 4 == 0 ? weights_[i / 4] : 0.0;
    return true;
  }

 private:
  const PoseParameters expected_;
  const PoseParameters weights_;
};

PoseParameters ToParameters(const Rigid2d& T) {
  return {T.translation().x(), T.translation().y(), Yaw(T)};
}

double MeanHitProbability(const PlanarPoints& points, const ProbabilityGrid& grid,
                          const Rigid2d& T_grid_scan) {
  double sum = 0.0;
  for (const Eigen::Vector2d& point : points) {
    sum += HitProbability(grid.At(grid.CellAt(T_grid_scan * point)));
  }
  return sum / static_cast<double>(points.size());
}

}  // namespace

CeresScanMatcher::CeresScanMatcher(const CeresMatcherOptions& options)
    : options_(Validated(options)) {}

std::optional<ScanMatch> CeresScanMatcher::Match(const PlanarPoints& points,
                                                 const ProbabilityGrid& grid,
                                                 const Rigid2d& T_grid_scan_expected,
                                                 const Rigid2d& T_grid_scan_start) const {
  if (points.empty()) return std::nullopt;
  PoseParameters expected = ToParameters(T_grid_scan_expected);
  PoseParameters pose = ToParameters(T_grid_scan_start);
  // The same turn as a number near the start's: angles go around.
  expected[2] = pose[2] + std::remainder(expected[2] - pose[2], 2.0 * M_PI);
  ceres::Problem problem;
  problem.AddResidualBlock(new FitCost(points, grid, options_.fit_weight), nullptr, pose.data());
  problem.AddResidualBlock(
      new PriorCost(expected, options_.translation_weight_per_m, options_.rotation_weight_per_rad),
      nullptr, pose.data());
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.max_num_iterations = options_.iterations;
  solver.num_threads = 1;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  ScanMatch match;
  match.T_grid_scan = MakeRigid2d({pose[0], pose[1]}, pose[2]);
  match.score = MeanHitProbability(points, grid, match.T_grid_scan);
  return match;
}

}  // namespace semantic_slam
