#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/control/attitude_controller.h"
#include "semantic_slam/control/position_controller.h"
#include "semantic_slam/control/quadrotor_parameters.h"
#include "semantic_slam/control/quadrotor_state.h"
#include "semantic_slam/control/waypoint_follower.h"
#include "semantic_slam/simulation/imu_model.h"
#include "semantic_slam/simulation/simulated_drone.h"
#include "semantic_slam/simulation/tour_pilot.h"

namespace semantic_slam {

// What the drone carries, and how often it reads it. The imu is in the camera's housing, with axes
// parallel to the optical frame's, as in a RealSense.
struct SensorMountOptions {
  int image_rate_hz = 30;  // divides the steps per second, as the imu's does
  int imu_rate_hz = 200;
  double camera_x_m = 0.1;  // the camera in the base frame
  double camera_y_m = 0.0;
  double camera_z_m = 0.0;
  double camera_pitch_deg = 0.0;  // positive looks down

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("image_rate_hz", self.image_rate_hz, 1, 1000);
    visit("imu_rate_hz", self.imu_rate_hz, 1, 10000);
    visit("camera_x_m", self.camera_x_m, -1.0, 1.0);
    visit("camera_y_m", self.camera_y_m, -1.0, 1.0);
    visit("camera_z_m", self.camera_z_m, -1.0, 1.0);
    visit("camera_pitch_deg", self.camera_pitch_deg, -90.0, 90.0);
  }
};

// The camera's housing in the base frame: x to where the camera looks, z up.
Rigid3d HousingPose(const SensorMountOptions& mount);

// From the camera's housing (x ahead, z up) to the optical frame (z ahead, y down).
Rigid3d OpticalInHousing();

// The options of a simulated flight, in the groups that configuration files use.
struct SimulatedFlightOptions {
  SensorMountOptions mount;
  SimulatedDroneOptions drone;
  QuadrotorParameters quadrotor;
  AttitudeControllerOptions attitude_controller;
  ImuOptions imu;
  PositionControllerOptions position_controller;  // these three: for a tour by the true pose
  ThrustLimits thrust;
  WaypointFollowerOptions follower;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("mount", self.mount);
    visit("drone", self.drone);
    visit("quadrotor", self.quadrotor);
    visit("attitude_controller", self.attitude_controller);
    visit("imu", self.imu);
    visit("position_controller", self.position_controller);
    visit("thrust", self.thrust);
    visit("follower", self.follower);
  }
};

// A simulated drone with an imu and a camera, from one image to the next. Somebody else steers it
// with Follow(), or it flies a tour by its true pose. Equal calls give equal flights and readings.
// Not thread-safe.
class SimulatedFlight {
 public:
  // Begins at `T_world_base`, which must be level, at `start`, where the first image is due. Throws
  // ConfigError if an option is out of range or a rate does not divide the steps per second.
  SimulatedFlight(const SimulatedFlightOptions& options, const Rigid3d& T_world_base, Stamp start);

  // Flies it by the true pose from now on. Throws InputError if a waypoint is not finite.
  void FlyTour(const std::vector<Waypoint>& waypoints);
  // Whether that has come to its end.
  bool IsTourDone() const { return pilot_ && pilot_->IsDone(); }

  // See SimulatedDrone::Follow().
  void Follow(const RelativeAttitudeCommand& command) { drone_.Follow(command); }

  // Flies on to when the next image is due. Returns the imu's readings until then, the last one at
  // most at that moment.
  std::vector<ImuReading> FlyToNextImage();

  Stamp stamp() const { return drone_.stamp(); }
  const QuadrotorState& state() const { return drone_.state(); }
  Rigid3d T_world_camera() const { return drone_.state().T_world_base * T_base_camera_; }
  // The optical frame, which is the imu's too.
  const Rigid3d& T_base_camera() const { return T_base_camera_; }

 private:
  void Step();

  const SimulatedFlightOptions options_;
  const Rigid3d T_base_camera_;
  const double step_s_;
  const int steps_per_image_;
  const int steps_per_reading_;
  SimulatedDrone drone_;
  ImuModel imu_;
  std::optional<TourPilot> pilot_;
  int steps_since_reading_ = 0;
  QuadrotorState state_at_reading_;
};

}  // namespace semantic_slam
