#include "semantic_slam/loop_closing/pose_graph_3d.h"

#include <array>

#include <ceres/ceres.h>
#include <ceres/rotation.h>

namespace semantic_slam {
namespace {

// A pose's change in its own frame: rotation vector, then translation. T = T_start * change.
using ChangeBlock = std::array<double, 6>;

template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

// A rigid motion as Ceres differentiates it.
template <typename T>
struct Motion {
  Eigen::Quaternion<T> q;
  Vector3<T> t;

  static Motion FromBlock(const T* block) {
    Motion m;
    T q[4];
    ceres::AngleAxisToQuaternion(block, q);
    m.q = Eigen::Quaternion<T>(q[0], q[1], q[2], q[3]);
    m.t = Vector3<T>(block[3], block[4], block[5]);
    return m;
  }
  static Motion FromPose(const Rigid3d& pose) {
    return {Eigen::Quaterniond(pose.linear()).cast<T>(), pose.translation().cast<T>()};
  }
  Motion operator*(const Motion& other) const { return {q * other.q, t + q * other.t}; }
  Motion Inverse() const { return {q.conjugate(), -(q.conjugate() * t)}; }
};

// [rotation / sigma, translation / sigma] of T_a_b^-1 T_a^-1 T_b.
class RelativePoseError {
 public:
  RelativePoseError(const RelativePose& edge, const PoseGraph3d& graph,
                    const PoseGraphOptions& options)
      : T_map_a_(graph.poses[edge.a]),
        T_map_b_(graph.poses[edge.b]),
        T_b_a_(edge.T_a_b.inverse()),
        rotation_weight_(edge.weight / options.rotation_sigma_rad),
        translation_weight_(edge.weight / options.translation_sigma_m) {}

  template <typename T>
  bool operator()(const T* change_a, const T* change_b, T* residuals) const {
    const auto a = Motion<T>::FromPose(T_map_a_) * Motion<T>::FromBlock(change_a);
    const auto b = Motion<T>::FromPose(T_map_b_) * Motion<T>::FromBlock(change_b);
    const auto error = Motion<T>::FromPose(T_b_a_) * (a.Inverse() * b);
    const T q[4] = {error.q.w(), error.q.x(), error.q.y(), error.q.z()};
    ceres::QuaternionToAngleAxis(q, residuals);
    for (int i = 0; i < 3; ++i) {
      residuals[i] *= T(rotation_weight_);
      residuals[3 + i] = T(translation_weight_) * error.t[i];
    }
    return true;
  }

 private:
  const Rigid3d T_map_a_, T_map_b_, T_b_a_;
  const double rotation_weight_, translation_weight_;
};

Rigid3d ToPose(const ChangeBlock& block) {
  Rigid3d T = Rigid3d::Identity();
  T.linear() = ExpSo3(Eigen::Map<const Eigen::Vector3d>(block.data()));
  T.translation() = Eigen::Map<const Eigen::Vector3d>(block.data() + 3);
  return T;
}

}  // namespace

void OptimizePoseGraph(PoseGraph3d& graph, const PoseGraphOptions& options) {
  std::vector<ChangeBlock> changes(graph.poses.size(), ChangeBlock{});
  ceres::Problem problem;
  for (const RelativePose& edge : graph.edges) {
    using Cost = ceres::AutoDiffCostFunction<RelativePoseError, 6, 6, 6>;
    problem.AddResidualBlock(new Cost(new RelativePoseError(edge, graph, options)), nullptr,
                             changes[edge.a].data(), changes[edge.b].data());
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (graph.fixed[i] && problem.HasParameterBlock(changes[i].data())) {
      problem.SetParameterBlockConstant(changes[i].data());
    }
  }
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.num_threads = 1;
  solver.max_num_iterations = options.max_iterations;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (!graph.fixed[i]) graph.poses[i] = Orthonormalised(graph.poses[i] * ToPose(changes[i]));
  }
}

}  // namespace semantic_slam
