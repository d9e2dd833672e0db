#include "semantic_slam/simulation/camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/interpolation.h"

namespace semantic_slam {
namespace {

constexpr double kMaxTourS = 1800.0;
// Recorded poses have noise, which velocities must not be made of.
constexpr double kVelocitySpanS = 0.1;

Stamp After(Stamp stamp, double seconds) {
  return {stamp.ns + static_cast<std::int64_t>(std::llround(seconds * 1e9))};
}

// Recorded poses at any time; before the first and after the last it stands still.
class PathSampler {
 public:
  explicit PathSampler(const Trajectory& poses) : poses_(poses) {}

  Rigid3d Pose(Stamp stamp) const {
    const auto next = std::upper_bound(
        poses_.begin(), poses_.end(), stamp,
        [](Stamp value, const StampedPose& stamped) { return value < stamped.stamp; });
    if (next == poses_.begin()) return next->pose;
    const auto last = std::prev(next);
    if (next == poses_.end()) return last->pose;
    return Interpolated(
        last->pose, next->pose,
        SecondsBetween(last->stamp, stamp) / SecondsBetween(last->stamp, next->stamp));
  }

  // As if the camera were the drone's base.
  QuadrotorState State(Stamp stamp) const {
    const Rigid3d before = Pose(After(stamp, -0.5 * kVelocitySpanS));
    const Rigid3d after = Pose(After(stamp, 0.5 * kVelocitySpanS));
    const Eigen::AngleAxisd turn(before.linear().transpose() * after.linear());
    QuadrotorState state;
    state.T_world_base = Pose(stamp);
    state.velocity_world_mps = (after.translation() - before.translation()) / kVelocitySpanS;
    state.angular_velocity_base_radps = turn.angle() / kVelocitySpanS * turn.axis();
    return state;
  }

 private:
  const Trajectory& poses_;
};

// Stamps `rate_hz` times a second from the first to the last.
std::vector<Stamp> Stamps(const Trajectory& poses, double rate_hz) {
  std::vector<Stamp> stamps;
  for (Stamp stamp = poses.front().stamp; stamp <= poses.back().stamp;) {
    stamps.push_back(stamp);
    stamp = After(poses.front().stamp, static_cast<double>(stamps.size()) / rate_hz);
  }
  return stamps;
}

}  // namespace

CameraPath FlyTour(const Tour& tour, const SimulatedFlightOptions& options, Stamp start) {
  CameraPath path;
  if (tour.waypoints.empty()) return path;
  SimulatedFlightOptions flight_options = options;
  if (tour.max_speed_mps) flight_options.follower.max_speed_mps = *tour.max_speed_mps;
  const Waypoint& first = tour.waypoints.front();
  const Rigid3d T_world_base = Eigen::Translation3d(first.position_m) *
                               Rigid3d(Eigen::AngleAxisd(first.yaw_rad, Eigen::Vector3d::UnitZ()));
  SimulatedFlight flight(flight_options, T_world_base, start);
  flight.FlyTour(tour.waypoints);
  path.T_world_camera.push_back({flight.stamp(), flight.T_world_camera()});
  while (!flight.IsTourDone()) {
    const std::vector<ImuReading> readings = flight.FlyToNextImage();
    path.readings.insert(path.readings.end(), readings.begin(), readings.end());
    path.T_world_camera.push_back({flight.stamp(), flight.T_world_camera()});
    if (SecondsBetween(start, flight.stamp()) > kMaxTourS) {
      throw ConfigError("the tour takes longer than " + std::to_string(std::lround(kMaxTourS)) +
                        " s");
    }
  }
  return path;
}

CameraPath FollowTrajectory(const Trajectory& T_world_camera, double image_rate_hz,
                            double imu_rate_hz, const ImuOptions& imu) {
  CheckInRange("image_rate_hz", image_rate_hz, 0.01, 1000.0);
  CheckInRange("imu_rate_hz", imu_rate_hz, 1.0, 10000.0);
  ImuModel model(imu, Rigid3d::Identity());
  CameraPath path;
  if (T_world_camera.empty()) return path;
  const PathSampler sampler(T_world_camera);
  for (const Stamp stamp : Stamps(T_world_camera, image_rate_hz)) {
    path.T_world_camera.push_back({stamp, sampler.Pose(stamp)});
  }
  std::vector<Stamp> stamps = Stamps(T_world_camera, imu_rate_hz);
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    path.readings.push_back(model.Measure(stamps[i], sampler.State(stamps[i - 1]),
                                          sampler.State(stamps[i]),
                                          SecondsBetween(stamps[i - 1], stamps[i])));
  }
  return path;
}

}  // namespace semantic_slam
