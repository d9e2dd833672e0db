#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/control/flight_reference.h"

namespace semantic_slam {

// Where a reference shall go to, and how fast it may be on the way.
struct ReferenceTarget {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
  double max_speed_mps = 0.0;  // now
};

struct ReferenceLimits {
  double max_acceleration_mps2 = 1.0;
  double max_yaw_rate_radps = 1.0;
  double max_yaw_acceleration_radps2 = 1.0;
};

// A point with a heading that moves smoothly: its acceleration follows what is wanted with a lag,
// so that the attitude that goes with it does not jump. Not thread-safe.
class ReferenceMotion {
 public:
  // Of the acceleration, to brake with: what is left is for turns, and for the lag.
  static constexpr double kBrakingShare = 0.5;
  static constexpr double kMaxStepS = 0.01;

  explicit ReferenceMotion(const ReferenceLimits& limits) : limits_(limits) {}

  void StartFrom(const Eigen::Vector3d& position_m, const Eigen::Vector3d& velocity_mps,
                 double yaw_rad);

  // Towards the target, `step_s` on. Precondition: step_s is not above kMaxStepS.
  void Advance(const ReferenceTarget& target, double step_s);

  // The frame of the reference is another one now: coordinates in the old one become those in the
  // new.
  void ChangeFrame(const Rigid3d& T_new_old);

  const FlightReference& reference() const { return reference_; }

  // Where it comes to rest if it brakes now.
  Eigen::Vector3d StoppingPlace() const;
  double StoppingYaw() const;

 private:
  void AdvancePosition(const ReferenceTarget& target, double step_s);
  void AdvanceYaw(double target_yaw_rad, double step_s);

  const ReferenceLimits limits_;
  FlightReference reference_;
};

}  // namespace semantic_slam
