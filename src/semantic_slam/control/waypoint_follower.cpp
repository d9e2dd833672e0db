#include "semantic_slam/control/waypoint_follower.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/control/attitude_command.h"

namespace semantic_slam {
namespace {

constexpr double kApproachGainPerS = 1.2;  // speed per distance, in the last part of the way

void Check(const Waypoint& waypoint) {
  if (!waypoint.position_m.allFinite() || !std::isfinite(waypoint.yaw_rad)) {
    throw InputError("a waypoint has a number that is not finite");
  }
  if (waypoint.position_m.cwiseAbs().maxCoeff() > WaypointFollower::kMaxCoordinateM) {
    throw InputError("a waypoint is farther from the origin than " +
                     std::to_string(static_cast<int>(WaypointFollower::kMaxCoordinateM)) + " m");
  }
  if (!(waypoint.hold_s >= 0.0 && std::isfinite(waypoint.hold_s))) {
    throw InputError("a waypoint's hold is " + std::to_string(waypoint.hold_s) +
                     " s, expected 0 or more");
  }
}

void CheckCount(std::size_t count) {
  if (count <= WaypointFollower::kMaxWaypoints) return;
  throw InputError("there are " + std::to_string(count) + " waypoints, expected at most " +
                   std::to_string(WaypointFollower::kMaxWaypoints));
}

ReferenceLimits MotionLimits(const WaypointFollowerOptions& options) {
  return {options.max_acceleration_mps2, options.max_yaw_rate_radps,
          options.max_yaw_acceleration_radps2};
}

double Turn(double from_yaw_rad, double to_yaw_rad) {
  return std::abs(WrappedAngle(to_yaw_rad - from_yaw_rad));
}

}  // namespace

const char* ToString(FlightState state) {
  switch (state) {
    case FlightState::kIdle:
      return "idle";
    case FlightState::kFlying:
      return "flying";
    case FlightState::kHolding:
      return "holding";
    case FlightState::kDone:
      return "done";
  }
  return "";
}

WaypointFollower::WaypointFollower(const WaypointFollowerOptions& options)
    : options_(Validated(options)), motion_(MotionLimits(options)) {}

void WaypointFollower::Replace(std::vector<Waypoint> waypoints) {
  CheckCount(waypoints.size());
  for (const Waypoint& waypoint : waypoints) Check(waypoint);
  if (waypoints.empty()) StayHere();
  waypoints_ = std::move(waypoints);
  index_ = 0;
  held_s_ = 0.0;
  state_ = waypoints_.empty() ? FlightState::kIdle : FlightState::kFlying;
  Plan();
}

void WaypointFollower::Append(const Waypoint& waypoint) {
  if (state_ == FlightState::kIdle || state_ == FlightState::kDone) return Replace({waypoint});
  CheckCount(waypoints_.size() + 1);
  Check(waypoint);
  waypoints_.push_back(waypoint);
  Plan();
}

void WaypointFollower::Clear() {
  Replace({});
}

void WaypointFollower::SetPaused(bool paused) {
  if (paused && !paused_) StayHere();
  paused_ = paused;
}

void WaypointFollower::StartFrom(const DronePlace& drone) {
  motion_.StartFrom(drone.position_m, drone.velocity_mps, drone.yaw_rad);
  StayHere();
}

void WaypointFollower::FollowCorrection(const Rigid3d& T_new_old) {
  motion_.ChangeFrame(T_new_old);
  stay_.position_m = T_new_old * stay_.position_m;
  stay_.yaw_rad += Heading(T_new_old.linear());
}

void WaypointFollower::Plan() {
  const double acceleration = options_.max_acceleration_mps2;
  passages_ =
      PlanPassages(waypoints_, {options_.corner_radius_m, options_.max_speed_mps, acceleration,
                                ReferenceMotion::kBrakingShare * acceleration});
}

void WaypointFollower::StayHere() {
  stay_.position_m = motion_.StoppingPlace();
  stay_.yaw_rad = motion_.StoppingYaw();
}

FlightReference WaypointFollower::Advance(const DronePlace& drone, double step_s) {
  assert(drone.position_m.allFinite() && drone.velocity_mps.allFinite() && step_s >= 0.0);
  AdvanceQueue(drone, step_s);
  const int steps = static_cast<int>(std::ceil(step_s / ReferenceMotion::kMaxStepS));
  for (int i = 0; i < steps; ++i) motion_.Advance(Target(drone), step_s / steps);
  return motion_.reference();
}

void WaypointFollower::AdvanceQueue(const DronePlace& drone, double step_s) {
  if (!IsUnderWay()) return;
  if (state_ == FlightState::kHolding) {
    held_s_ += step_s;
  } else if (state_ == FlightState::kFlying && MayPass(drone)) {
    LeaveWaypoint();
  } else if (state_ == FlightState::kFlying && IsReached(drone)) {
    state_ = FlightState::kHolding;
    held_s_ = 0.0;
  }
  if (state_ == FlightState::kHolding && held_s_ >= waypoints_[index_].hold_s) LeaveWaypoint();
}

void WaypointFollower::LeaveWaypoint() {
  const bool is_last = index_ + 1 == waypoints_.size();
  if (!is_last) ++index_;
  state_ = is_last ? FlightState::kDone : FlightState::kFlying;
}

bool WaypointFollower::MayPass(const DronePlace& drone) const {
  const Waypoint& waypoint = waypoints_[index_];
  const Passage& passage = passages_[index_];
  const FlightReference& reference = motion_.reference();
  return passage.speed_mps > 0.0 &&
         (waypoint.position_m - reference.position_m).norm() <= passage.radius_m &&
         DistanceToGo(drone.position_m) <= passage.radius_m + options_.reached_distance_m &&
         Turn(reference.yaw_rad, waypoint.yaw_rad) <= options_.corner_yaw_rad;
}

bool WaypointFollower::IsReached(const DronePlace& drone) const {
  return DistanceToGo(drone.position_m) <= options_.reached_distance_m &&
         Turn(drone.yaw_rad, waypoints_[index_].yaw_rad) <= options_.reached_yaw_rad &&
         drone.velocity_mps.norm() <= options_.reached_speed_mps;
}

ReferenceTarget WaypointFollower::Target(const DronePlace& drone) const {
  const bool flying = IsUnderWay() && state_ == FlightState::kFlying;
  const Waypoint& waypoint = IsUnderWay() ? waypoints_[index_] : stay_;
  const double speed = SpeedTowards(waypoint, flying ? passages_[index_] : Passage());
  return {waypoint.position_m, waypoint.yaw_rad, flying ? speed * Patience(drone) : speed};
}

double WaypointFollower::SpeedTowards(const Waypoint& waypoint, const Passage& passage) const {
  const FlightReference& reference = motion_.reference();
  const double deceleration = ReferenceMotion::kBrakingShare * options_.max_acceleration_mps2;
  double distance = (waypoint.position_m - reference.position_m).norm();
  double braking_distance = distance;
  // Within the radius already, but not yet free to go on: then it is a stop.
  if (passage.speed_mps > 0.0 && distance > passage.radius_m) {
    distance -= passage.radius_m;
    braking_distance = distance + std::pow(passage.speed_mps, 2) / (2.0 * deceleration);
  }
  double speed = std::min(options_.max_speed_mps,
                          BrakingSpeed(braking_distance, deceleration, kApproachGainPerS));
  // No faster than the heading can be there, too.
  const double turn = Turn(reference.yaw_rad, waypoint.yaw_rad) - options_.corner_yaw_rad;
  if (turn > 0.0) speed = std::min(speed, distance * options_.max_yaw_rate_radps / turn);
  return speed;
}

double WaypointFollower::Patience(const DronePlace& drone) const {
  const double lag = (motion_.reference().position_m - drone.position_m).norm();
  return std::clamp(2.0 - 2.0 * lag / options_.max_lag_m, 0.0, 1.0);
}

FlightStatus WaypointFollower::status() const {
  return {state_, paused_, index_, waypoints_.size()};
}

double WaypointFollower::DistanceToGo(const Eigen::Vector3d& position_m) const {
  return waypoints_.empty() ? 0.0 : (waypoints_[index_].position_m - position_m).norm();
}

}  // namespace semantic_slam
