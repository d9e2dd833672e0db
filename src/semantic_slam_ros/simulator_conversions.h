#pragma once

#include <string>

#include <nav_msgs/Odometry.h>
#include <semantic_slam/AttitudeThrust.h>
#include <sensor_msgs/Imu.h>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/control/quadrotor_state.h"
#include "semantic_slam/simulation/imu_model.h"
#include "semantic_slam/simulation/simulated_drone.h"

// The simulator's types as messages, and back.

namespace semantic_slam_ros {

// Throws semantic_slam::InputError with one line that names the fault if the message has no stamp,
// or as ToAttitudeCommand() does.
semantic_slam::RelativeAttitudeCommand ToRelativeAttitudeCommand(
    const semantic_slam::AttitudeThrust& msg);

// Without an orientation, which the sensor does not measure. The covariances are those of the
// readings' white noise.
sensor_msgs::Imu ToImu(const semantic_slam::ImuReading& reading,
                       const semantic_slam::ImuOptions& options, double rate_hz,
                       const std::string& frame_id);

// The twist is in the base's axes, as REP-105 wants it.
nav_msgs::Odometry ToOdometry(const semantic_slam::QuadrotorState& state,
                              semantic_slam::Stamp stamp, const std::string& world_frame,
                              const std::string& base_frame);

}  // namespace semantic_slam_ros
