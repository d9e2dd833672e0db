#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace semantic_slam {

struct BoxFilterOptions {
  double position_weight = 0.05;     // standard deviation of centre and size, per width and height
  double velocity_weight = 0.00625;  // the same of their change per image

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("position_weight", self.position_weight, 1e-4, 10.0);
    visit("velocity_weight", self.velocity_weight, 1e-5, 10.0);
  }
};

// A motion of the camera as the image sees it: p' = motion.leftCols(2) * p + motion.col(2) [px].
using ImageMotion = Eigen::Matrix<double, 2, 3>;

// Kalman filter of one box: state [xc yc w h vx vy vw vh] (thesis eq. 3.19), measurement
// [xc yc w h] (eq. 3.20), constant velocity, one step per image. Noise grows with the box's width
// and height as in BoT-SORT (Aharon, Orfaig, Bobrovsky, 2022). Not thread-safe.
class BoxFilter {
 public:
  using State = Eigen::Matrix<double, 8, 1>;
  using Covariance = Eigen::Matrix<double, 8, 8>;

  // Begins at a measured box. Preconditions: options are valid; the box is finite and not empty.
  BoxFilter(const cv::Rect2f& box, const BoxFilterOptions& options);

  // One image on. With `keep_size` the box no longer grows or shrinks: for objects out of sight.
  void Predict(bool keep_size);

  // Moves with the image when the camera has moved (BoT-SORT, eq. 5 and 6).
  void Warp(const ImageMotion& motion);

  // Takes in a measured box. Precondition: finite and not empty.
  void Correct(const cv::Rect2f& box);

  // As filtered, at least a pixel wide and high.
  cv::Rect2f box() const;

  const State& state() const { return state_; }
  const Covariance& covariance() const { return covariance_; }

 private:
  // Width, height, width, height: what noise is proportional to.
  Eigen::Vector4d Scale() const;

  BoxFilterOptions options_;
  State state_ = State::Zero();
  Covariance covariance_ = Covariance::Zero();
};

}  // namespace semantic_slam
