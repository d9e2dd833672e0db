#include "semantic_slam/control/waypoint_controller.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/option_groups.h"

namespace semantic_slam {
namespace {

// How fast a drone without a pose brakes, gently, so that the camera keeps its view: speed decays
// at this rate.
constexpr double kBlindBrakingPerS = 2.0;

}  // namespace

WaypointController::WaypointController(const WaypointControllerOptions& options)
    : mass_kg_(ValidatedGroups(options).quadrotor.mass_kg()),
      estimator_(options.velocity_estimator),
      follower_(options.follower),
      position_controller_(options.quadrotor, options.position_controller, options.thrust),
      thrust_n_(options.quadrotor.hover_thrust_n()) {}

AttitudeCommand WaypointController::Update(const BasePose& pose) {
  Check(pose);
  const double gap_s = last_ ? SecondsBetween(last_->stamp, pose.stamp) : 0.0;
  const double step_s = gap_s <= kMaxGapS ? gap_s : 0.0;
  if (step_s > 0.0) {
    Follow(pose, step_s);
  } else {
    Restart(pose);
  }
  last_ = pose;
  const DronePlace place = PlaceOf(pose);
  const FlightReference reference = follower_.Advance(place, step_s);
  const AttitudeCommand command =
      position_controller_.Compute(reference, place.position_m, place.velocity_mps, step_s);
  thrust_n_ = command.thrust_n;
  blind_stamp_ = pose.stamp;
  blind_velocity_mps_ =
      Eigen::AngleAxisd(-place.yaw_rad, Eigen::Vector3d::UnitZ()) * place.velocity_mps;
  return command;
}

AttitudeCommand WaypointController::FlyBlind(Stamp stamp) {
  if (blind_stamp_) {
    const double step_s = std::clamp(SecondsBetween(*blind_stamp_, stamp), 0.0, kMaxGapS);
    blind_velocity_mps_ *= std::exp(-kBlindBrakingPerS * step_s);
  }
  blind_stamp_ = stamp;
  const AttitudeCommand command =
      position_controller_.Steer(-kBlindBrakingPerS * blind_velocity_mps_);
  thrust_n_ = command.thrust_n;
  return command;
}

double WaypointController::DistanceToGo() const {
  if (!last_) return 0.0;
  return follower_.DistanceToGo((last_->T_map_odom * last_->T_odom_base).translation());
}

void WaypointController::Check(const BasePose& pose) const {
  if (!IsFinite(pose.T_odom_base) || !IsFinite(pose.T_map_odom) ||
      (pose.velocity_odom_mps && !pose.velocity_odom_mps->allFinite())) {
    throw InputError("the pose at " + ToString(pose.stamp) + " s has a number that is not finite");
  }
  if (last_ && pose.stamp <= last_->stamp) {
    throw InputError("the pose at " + ToString(pose.stamp) +
                     " s is not later than the one before, " + ToString(last_->stamp) + " s");
  }
}

DronePlace WaypointController::PlaceOf(const BasePose& pose) const {
  const Rigid3d T_map_base = pose.T_map_odom * pose.T_odom_base;
  return {T_map_base.translation(),
          pose.T_map_odom.linear() * pose.velocity_odom_mps.value_or(estimator_.velocity_mps()),
          Heading(T_map_base.linear())};
}

void WaypointController::Restart(const BasePose& pose) {
  estimator_.Restart(pose.T_odom_base.translation());
  follower_.StartFrom(PlaceOf(pose));
}

void WaypointController::Follow(const BasePose& pose, double step_s) {
  const bool is_continuous =
      estimator_.Update(pose.T_odom_base.translation(), ExpectedAcceleration(pose), step_s);
  if (is_continuous) {
    follower_.FollowCorrection(pose.T_map_odom * last_->T_map_odom.inverse());
  } else {
    follower_.StartFrom(PlaceOf(pose));
  }
}

// What the commanded thrust does along the axis that the base had in between, in the odom frame.
Eigen::Vector3d WaypointController::ExpectedAcceleration(const BasePose& pose) const {
  const Eigen::Vector3d axis =
      0.5 * (last_->T_odom_base.linear().col(2) + pose.T_odom_base.linear().col(2));
  return thrust_n_ / mass_kg_ * axis - Eigen::Vector3d(0.0, 0.0, kGravityMps2);
}

}  // namespace semantic_slam
