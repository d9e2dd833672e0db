#include "semantic_slam/tracking/motion_model.h"

namespace semantic_slam {

CameraTwist MeanTwist(const Rigid3d& T_previous_last, double seconds) {
  if (!(seconds > 0.0)) return {};
  const Eigen::AngleAxisd rotation(T_previous_last.linear());
  return {T_previous_last.linear().transpose() * T_previous_last.translation() / seconds,
          rotation.angle() / seconds * rotation.axis()};
}

void MotionModel::Update(Stamp previous, Stamp last, const Rigid3d& T_previous_last) {
  interval_s_ = SecondsBetween(previous, last);
  T_previous_last_ = T_previous_last;
  has_velocity_ = interval_s_ > 0.0 && interval_s_ <= kMaxHorizonS;
}

Rigid3d MotionModel::Predict(Stamp last, Stamp now) const {
  const double ahead_s = SecondsBetween(last, now);
  if (!has_velocity_ || !(ahead_s > 0.0 && ahead_s <= kMaxHorizonS)) return Rigid3d::Identity();
  const double stretch = ahead_s / interval_s_;
  const Eigen::AngleAxisd rotation(T_previous_last_.linear());
  Rigid3d motion = Rigid3d::Identity();
  motion.linear() =
      Eigen::AngleAxisd(rotation.angle() * stretch, rotation.axis()).toRotationMatrix();
  motion.translation() = T_previous_last_.translation() * stretch;
  return motion;
}

CameraTwist MotionModel::Twist(Stamp last, Stamp now) const {
  return MeanTwist(Predict(last, now), SecondsBetween(last, now));
}

}  // namespace semantic_slam
