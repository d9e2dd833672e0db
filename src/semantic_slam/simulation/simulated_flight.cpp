#include "semantic_slam/simulation/simulated_flight.h"

#include <cmath>
#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/option_groups.h"

namespace semantic_slam {
namespace {

int StepsBetween(const char* name, int rate_hz, int steps_per_s) {
  if (steps_per_s % rate_hz == 0) return steps_per_s / rate_hz;
  throw ConfigError(std::string("mount/") + name + " = " + std::to_string(rate_hz) +
                    ", but must divide drone/steps_per_s = " + std::to_string(steps_per_s));
}

}  // namespace

Rigid3d HousingPose(const SensorMountOptions& mount) {
  return Eigen::Translation3d(mount.camera_x_m, mount.camera_y_m, mount.camera_z_m) *
         Eigen::AngleAxisd(mount.camera_pitch_deg * M_PI / 180.0, Eigen::Vector3d::UnitY());
}

Rigid3d OpticalInHousing() {
  Rigid3d T_housing_optical = Rigid3d::Identity();
  T_housing_optical.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return T_housing_optical;
}

SimulatedFlight::SimulatedFlight(const SimulatedFlightOptions& options, const Rigid3d& T_world_base,
                                 Stamp start)
    : options_(ValidatedGroups(options)),
      T_base_camera_(HousingPose(options.mount) * OpticalInHousing()),
      step_s_(1.0 / options.drone.steps_per_s),
      steps_per_image_(
          StepsBetween("image_rate_hz", options.mount.image_rate_hz, options.drone.steps_per_s)),
      steps_per_reading_(
          StepsBetween("imu_rate_hz", options.mount.imu_rate_hz, options.drone.steps_per_s)),
      drone_(options.drone, options.quadrotor, options.attitude_controller, T_world_base, start),
      imu_(options.imu, T_base_camera_),
      state_at_reading_(drone_.state()) {}

void SimulatedFlight::FlyTour(const std::vector<Waypoint>& waypoints) {
  pilot_.emplace(waypoints, options_.follower, options_.position_controller, options_.thrust,
                 options_.quadrotor);
}

std::vector<ImuReading> SimulatedFlight::FlyToNextImage() {
  std::vector<ImuReading> readings;
  for (int i = 0; i < steps_per_image_; ++i) {
    Step();
    if (++steps_since_reading_ < steps_per_reading_) continue;
    readings.push_back(
        imu_.Measure(stamp(), state_at_reading_, state(), steps_since_reading_ * step_s_));
    steps_since_reading_ = 0;
    state_at_reading_ = state();
  }
  return readings;
}

void SimulatedFlight::Step() {
  if (pilot_) drone_.Follow(pilot_->Steer(drone_.state(), step_s_));
  drone_.Step();
}

}  // namespace semantic_slam
