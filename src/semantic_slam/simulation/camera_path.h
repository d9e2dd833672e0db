#pragma once

#include <vector>

#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/simulation/imu_model.h"
#include "semantic_slam/simulation/simulated_flight.h"

namespace semantic_slam {

// Where a camera is at each of its images, and what the imu in its housing reads on the way.
struct CameraPath {
  Trajectory T_world_camera;         // of the optical frame
  std::vector<ImuReading> readings;  // in that frame's axes
};

// The drone flies a tour by its true pose; the first image is at `start`. Throws ConfigError if an
// option is out of range or the tour takes longer than half an hour, InputError if a waypoint is
// not finite. A tour without waypoints gives no images.
CameraPath FlyTour(const Tour& tour, const SimulatedFlightOptions& options, Stamp start);

// The camera follows recorded poses, which are interpolated, `image_rate_hz` times a second from
// the first stamp to the last. Throws ConfigError if an option or rate is out of range.
CameraPath FollowTrajectory(const Trajectory& T_world_camera, double image_rate_hz,
                            double imu_rate_hz, const ImuOptions& imu);

}  // namespace semantic_slam
