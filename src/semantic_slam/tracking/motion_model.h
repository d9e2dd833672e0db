#pragma once

#include "semantic_slam/camera/camera_twist.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// The mean velocity on the way from one pose to the next, in the axes of the second; zero unless
// 0 < seconds.
CameraTwist MeanTwist(const Rigid3d& T_previous_last, double seconds);

// Constant velocity, thesis eq. (3.4) without control input: the motion between the last two images,
// stretched to the time that has passed since. Cameras drop images, so equal steps cannot be assumed.
class MotionModel {
 public:
  // The camera moved by T_previous_last between the two stamps.
  void Update(Stamp previous, Stamp last, const Rigid3d& T_previous_last);

  // Expected motion T_last_now from `last` to `now`: identity if nothing is known, or if so much
  // time has passed that the old velocity says nothing.
  Rigid3d Predict(Stamp last, Stamp now) const;

  // The velocity that Predict() expects, in the camera's axes; zero where that is the identity.
  CameraTwist Twist(Stamp last, Stamp now) const;

  void Reset() { has_velocity_ = false; }

 private:
  static constexpr double kMaxHorizonS = 0.5;

  bool has_velocity_ = false;
  double interval_s_ = 0.0;
  Rigid3d T_previous_last_ = Rigid3d::Identity();
};

}  // namespace semantic_slam
