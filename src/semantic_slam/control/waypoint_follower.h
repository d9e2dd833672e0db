#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/options.h"
#include "semantic_slam/control/flight_reference.h"
#include "semantic_slam/control/quadrotor_state.h"
#include "semantic_slam/control/reference_motion.h"
#include "semantic_slam/control/speed_limits.h"

namespace semantic_slam {

struct WaypointFollowerOptions {
  double max_speed_mps = 0.7;
  double max_acceleration_mps2 = 0.8;
  double max_yaw_rate_radps = 0.7;
  double max_yaw_acceleration_radps2 = 1.5;
  double corner_radius_m = 0.3;     // a waypoint without a hold is passed this near, or nearer
  double corner_yaw_rad = 0.2;      // and with a heading this near to its own
  double reached_distance_m = 0.1;  // another one is reached within this,
  double reached_yaw_rad = 0.1;     // this,
  double reached_speed_mps = 0.1;   // and slower than this
  double max_lag_m = 0.6;           // the reference waits for a drone that is so far behind

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_speed_mps", self.max_speed_mps, 0.01, 20.0);
    visit("max_acceleration_mps2", self.max_acceleration_mps2, 0.01, 20.0);
    visit("max_yaw_rate_radps", self.max_yaw_rate_radps, 0.01, 10.0);
    visit("max_yaw_acceleration_radps2", self.max_yaw_acceleration_radps2, 0.01, 100.0);
    visit("corner_radius_m", self.corner_radius_m, 0.0, 10.0);
    visit("corner_yaw_rad", self.corner_yaw_rad, 0.01, 3.2);
    visit("reached_distance_m", self.reached_distance_m, 0.01, 10.0);
    visit("reached_yaw_rad", self.reached_yaw_rad, 0.01, 3.2);
    visit("reached_speed_mps", self.reached_speed_mps, 0.01, 10.0);
    visit("max_lag_m", self.max_lag_m, 0.05, 100.0);
  }
};

enum class FlightState {
  kIdle,     // there are no waypoints
  kFlying,   // on the way to one
  kHolding,  // at one, for as long as it wants
  kDone,     // at the last one
};

// "idle", "flying", "holding" or "done".
const char* ToString(FlightState state);

struct FlightStatus {
  FlightState state = FlightState::kIdle;
  bool paused = false;
  std::size_t index = 0;  // of the waypoint that is flown to or held
  std::size_t count = 0;  // of all, with those that were reached
};

// Where the drone is, in the frame of the waypoints.
struct DronePlace {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
};

// Leads a reference through a queue of waypoints, thesis section 3.2.3: from where the drone is,
// smoothly, within limits of speed, acceleration and yaw rate, no faster than the drone can follow.
// Without waypoints, after the last one and while paused it stands still. Not thread-safe.
class WaypointFollower {
 public:
  static constexpr std::size_t kMaxWaypoints = 10000;
  static constexpr double kMaxCoordinateM = 1e4;

  // Throws ConfigError if an option is out of range.
  explicit WaypointFollower(const WaypointFollowerOptions& options = {});

  // These throw InputError, and change nothing, if a number is not finite, a coordinate is beyond
  // kMaxCoordinateM, a hold is negative, or the waypoints become more than kMaxWaypoints.
  void Replace(std::vector<Waypoint> waypoints);
  void Append(const Waypoint& waypoint);  // after the last one was reached, it begins a new queue

  void Clear();                 // the drone brakes and stays
  void SetPaused(bool paused);  // it brakes and stays until it may go on

  // The reference begins anew, at the drone; the queue stays as it is.
  void StartFrom(const DronePlace& drone);

  // The drone's frame was corrected, and its pose jumped with it: the reference jumps too, so that
  // nothing pulls at the drone. The waypoints stay.
  void FollowCorrection(const Rigid3d& T_new_old);

  // Moves the reference on by `step_s` and returns it. Precondition: StartFrom() was called, the
  // place is finite, step_s >= 0.
  FlightReference Advance(const DronePlace& drone, double step_s);

  FlightStatus status() const;
  const std::vector<Waypoint>& waypoints() const { return waypoints_; }
  // From the drone to the waypoint that is flown to; 0 if there is none.
  double DistanceToGo(const Eigen::Vector3d& position_m) const;

 private:
  void Plan();
  void StayHere();
  bool IsUnderWay() const { return !waypoints_.empty() && !paused_; }
  bool MayPass(const DronePlace& drone) const;
  bool IsReached(const DronePlace& drone) const;
  void AdvanceQueue(const DronePlace& drone, double step_s);
  void LeaveWaypoint();
  ReferenceTarget Target(const DronePlace& drone) const;
  double SpeedTowards(const Waypoint& waypoint, const Passage& passage) const;
  // In [0, 1]: 0 if the drone is so far behind that the reference waits for it.
  double Patience(const DronePlace& drone) const;

  const WaypointFollowerOptions options_;
  std::vector<Waypoint> waypoints_;
  std::vector<Passage> passages_;  // one per waypoint
  std::size_t index_ = 0;
  FlightState state_ = FlightState::kIdle;
  bool paused_ = false;
  double held_s_ = 0.0;
  ReferenceMotion motion_;
  Waypoint stay_;  // where the reference stays when it is not under way
};

}  // namespace semantic_slam
