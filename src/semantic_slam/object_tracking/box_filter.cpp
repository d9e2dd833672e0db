#include "semantic_slam/object_tracking/box_filter.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace semantic_slam {
namespace {

constexpr double kMinSidePx = 1.0;

Eigen::Vector4d CentreAndSize(const cv::Rect2f& box) {
  const Eigen::Vector4d corner_and_size(box.x, box.y, box.width, box.height);
  return corner_and_size + Eigen::Vector4d(0.5 * box.width, 0.5 * box.height, 0.0, 0.0);
}

}  // namespace

BoxFilter::BoxFilter(const cv::Rect2f& box, const BoxFilterOptions& options) : options_(options) {
  state_.head<4>() = CentreAndSize(box);
  const Eigen::Vector4d scale = Scale();
  covariance_.diagonal().head<4>() = (2.0 * options_.position_weight * scale).cwiseAbs2();
  covariance_.diagonal().tail<4>() = (10.0 * options_.velocity_weight * scale).cwiseAbs2();
}

Eigen::Vector4d BoxFilter::Scale() const {
  const double w = std::max(state_[2], kMinSidePx), h = std::max(state_[3], kMinSidePx);
  return {w, h, w, h};
}

void BoxFilter::Predict(bool keep_size) {
  if (keep_size) state_.tail<2>().setZero();
  const Eigen::Vector4d scale = Scale();
  Covariance F = Covariance::Identity();
  F.topRightCorner<4, 4>().setIdentity();
  state_ = F * state_;
  covariance_ = F * covariance_ * F.transpose();
  covariance_.diagonal().head<4>() += (options_.position_weight * scale).cwiseAbs2();
  covariance_.diagonal().tail<4>() += (options_.velocity_weight * scale).cwiseAbs2();
}

void BoxFilter::Warp(const ImageMotion& motion) {
  Covariance blocks = Covariance::Zero();
  for (int i = 0; i < 8; i += 2) blocks.block<2, 2>(i, i) = motion.leftCols<2>();
  state_ = blocks * state_;
  state_.head<2>() += motion.col(2);
  covariance_ = blocks * covariance_ * blocks.transpose();
}

void BoxFilter::Correct(const cv::Rect2f& box) {
  Eigen::Matrix4d S = covariance_.topLeftCorner<4, 4>();
  S.diagonal() += (options_.position_weight * Scale()).cwiseAbs2();
  // The gain solves K S = P H^T; H picks the first four of the state.
  const Eigen::Matrix<double, 8, 4> K = S.ldlt().solve(covariance_.topRows<4>()).transpose();
  state_ += K * (CentreAndSize(box) - state_.head<4>());
  covariance_ -= K * S * K.transpose();
}

cv::Rect2f BoxFilter::box() const {
  const double w = std::max(state_[2], kMinSidePx), h = std::max(state_[3], kMinSidePx);
  return {static_cast<float>(state_[0] - 0.5 * w), static_cast<float>(state_[1] - 0.5 * h),
          static_cast<float>(w), static_cast<float>(h)};
}

}  // namespace semantic_slam
