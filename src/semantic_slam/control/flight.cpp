#include "semantic_slam/control/flight.h"

#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/option_groups.h"

namespace semantic_slam {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;

DronePlace PlaceOf(const QuadrotorState& state) {
  return {state.T_world_base.translation(), state.velocity_world_mps,
          Heading(state.T_world_base.linear())};
}

// A quadrotor and all that controls it, step by step. Not thread-safe.
class ClosedLoop {
 public:
  ClosedLoop(const std::vector<Waypoint>& waypoints, const FlightOptions& options)
      : step_s_(1.0 / options.time.steps_per_s),
        model_(options.quadrotor),
        mixer_(options.quadrotor),
        attitude_controller_(options.quadrotor, options.attitude_controller),
        position_controller_(options.quadrotor, options.position_controller, options.thrust),
        follower_(options.follower) {
    Rigid3d T_world_base = Rigid3d::Identity();
    T_world_base.translation() = waypoints.front().position_m;
    T_world_base.rotate(Eigen::AngleAxisd(waypoints.front().yaw_rad, Eigen::Vector3d::UnitZ()));
    state_ = model_.Hovering(T_world_base);
    follower_.Replace(waypoints);
    follower_.StartFrom(PlaceOf(state_));
    reference_ = follower_.Advance(PlaceOf(state_), 0.0);
  }

  bool IsDone() const { return follower_.status().state == FlightState::kDone; }

  FlightSample SampleAt(Stamp stamp) const {
    return {stamp, state_, model_.Acceleration(state_), reference_, follower_.status()};
  }

  void Step() {
    const DronePlace place = PlaceOf(state_);
    reference_ = follower_.Advance(place, step_s_);
    const AttitudeCommand command =
        position_controller_.Compute(reference_, place.position_m, place.velocity_mps, step_s_);
    const BodyWrench wrench = attitude_controller_.Compute(command, state_.T_world_base.linear(),
                                                           state_.angular_velocity_base_radps);
    state_ = model_.Step(state_, mixer_.RotorSpeeds(wrench), step_s_);
  }

 private:
  const double step_s_;
  const QuadrotorModel model_;
  const RotorMixer mixer_;
  const AttitudeController attitude_controller_;
  PositionController position_controller_;
  WaypointFollower follower_;
  QuadrotorState state_;
  FlightReference reference_;
};

void CheckSampling(const FlightTimeOptions& time, int samples_per_s) {
  if (samples_per_s > 0 && time.steps_per_s % samples_per_s == 0) return;
  throw ConfigError("samples per second = " + std::to_string(samples_per_s) +
                    ", but must divide steps_per_s = " + std::to_string(time.steps_per_s));
}

// The stamp of the sample `k` after `start`, to the nearest nanosecond.
Stamp SampleStamp(Stamp start, std::int64_t k, int samples_per_s) {
  return Stamp{start.ns + (k * kNsPerSecond + samples_per_s / 2) / samples_per_s};
}

}  // namespace

void FlyWaypoints(const std::vector<Waypoint>& waypoints, const FlightOptions& options,
                  int samples_per_s, Stamp start,
                  const std::function<void(const FlightSample&)>& on_sample) {
  const FlightTimeOptions& time = ValidatedGroups(options).time;
  CheckSampling(time, samples_per_s);
  if (waypoints.empty()) return;
  ClosedLoop loop(waypoints, options);
  const int steps_per_sample = time.steps_per_s / samples_per_s;
  for (std::int64_t k = 0;; ++k) {
    on_sample(loop.SampleAt(SampleStamp(start, k, samples_per_s)));
    if (loop.IsDone()) return;
    if (static_cast<double>(k) / samples_per_s > time.max_duration_s) {
      throw ConfigError("a flight through " + std::to_string(waypoints.size()) +
                        " waypoints is not over after max_duration_s = " +
                        std::to_string(time.max_duration_s) + " s");
    }
    for (int i = 0; i < steps_per_sample; ++i) loop.Step();
  }
}

std::vector<FlightSample> FlyWaypoints(const std::vector<Waypoint>& waypoints,
                                       const FlightOptions& options, int samples_per_s,
                                       Stamp start) {
  std::vector<FlightSample> samples;
  FlyWaypoints(waypoints, options, samples_per_s, start,
               [&samples](const FlightSample& sample) { samples.push_back(sample); });
  return samples;
}

Trajectory PathOf(const std::vector<FlightSample>& samples) {
  Trajectory path;
  path.reserve(samples.size());
  for (const FlightSample& sample : samples)
    path.push_back({sample.stamp, sample.state.T_world_base});
  return path;
}

}  // namespace semantic_slam
