#pragma once

#include <cmath>

#include <Eigen/Core>

namespace semantic_slam {

// N unknowns: translation and rotation of the pose, and with 9 the angular velocity.
template <int N>
struct NormalEquations {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  Matrix H = Matrix::Zero();
  Vector b = Vector::Zero();
  double cost = 0.0;

  // One block of residuals `r` with Jacobian `J` under a Huber kernel that bends at chi2 = `bend`.
  template <int Rows>
  void Add(const Eigen::Matrix<double, Rows, 1>& r, const Eigen::Matrix<double, Rows, N>& J,
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

// Adds up what observations ask of the points that they show, each by its 3 x 3 equations, and
// makes of it the equations for the step of the pose that moves the points. A point's Jacobian is
// J = (I, -[p]x[, t [p]x]): six products of 3 x 3 in place of all of J'HJ.
template <int N>
struct PointSums {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();   // of H
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();   // of H [p]x
  Eigen::Matrix3d K = Eigen::Matrix3d::Zero();   // of -[p]x H [p]x
  Eigen::Vector3d b = Eigen::Vector3d::Zero();   // of b
  Eigen::Vector3d c = Eigen::Vector3d::Zero();   // of p x b
  Eigen::Matrix3d tM = Eigen::Matrix3d::Zero();  // the same, times row times
  Eigen::Matrix3d tK = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d ttK = Eigen::Matrix3d::Zero();
  Eigen::Vector3d tc = Eigen::Vector3d::Zero();
  double cost = 0.0;

  void Add(const NormalEquations<3>& point, const Eigen::Vector3d& p, double row_time_s) {
    Eigen::Matrix3d m, k;
    for (int row = 0; row < 3; ++row) m.row(row) = Eigen::Vector3d(point.H.row(row)).cross(p);
    for (int column = 0; column < 3; ++column) k.col(column) = m.col(column).cross(p);
    const Eigen::Vector3d moment = p.cross(point.b);
    H += point.H;
    M += m;
    K += k;
    b += point.b;
    c += moment;
    cost += point.cost;
    if constexpr (N == 9) {
      tM += row_time_s * m;
      tK += row_time_s * k;
      ttK += row_time_s * row_time_s * k;
      tc += row_time_s * moment;
    }
  }

  NormalEquations<N> Equations() const {
    NormalEquations<N> equations;
    equations.cost = cost;
    if constexpr (N == 9) {
      equations.H << H, -M, tM, -M.transpose(), K, -tK, tM.transpose(), -tK, ttK;
      equations.b << b, c, -tc;
    } else {
      equations.H << H, -M, -M.transpose(), K;
      equations.b << b, c;
    }
    return equations;
  }
};

}  // namespace semantic_slam
