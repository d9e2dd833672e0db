#include "semantic_slam/simulation/imu_model.h"

#include <cassert>
#include <cmath>

#include "semantic_slam/common/options.h"
#include "semantic_slam/control/quadrotor_parameters.h"

namespace semantic_slam {

ImuModel::ImuModel(const ImuOptions& options, const Rigid3d& T_base_imu)
    : options_(Validated(options)),
      T_base_imu_(T_base_imu),
      random_(HashOf({static_cast<std::uint64_t>(options.seed)})),
      gyroscope_{options.gyroscope_noise_radps_per_sqrt_hz, options.gyroscope_walk_radps_per_sqrt_s,
                 options.gyroscope_bias_radps * GaussianVector()},
      accelerometer_{options.accelerometer_noise_mps2_per_sqrt_hz,
                     options.accelerometer_walk_mps2_per_sqrt_s,
                     options.accelerometer_bias_mps2 * GaussianVector()} {}

ImuReading ImuModel::Measure(Stamp stamp, const QuadrotorState& before, const QuadrotorState& now,
                             double seconds) {
  assert(seconds > 0.0);
  const Eigen::Vector3d gravity_world(0.0, 0.0, -kGravityMps2);
  const Eigen::Vector3d acceleration_world = (VelocityOfImu(now) - VelocityOfImu(before)) / seconds;
  const Eigen::Matrix3d R_imu_base = T_base_imu_.linear().transpose();
  const Eigen::Matrix3d R_imu_world = R_imu_base * now.T_world_base.linear().transpose();
  ImuReading reading;
  reading.stamp = stamp;
  reading.angular_velocity_radps = R_imu_base * now.angular_velocity_base_radps;
  reading.specific_force_mps2 = R_imu_world * (acceleration_world - gravity_world);
  if (!options_.noise) return reading;
  reading.angular_velocity_radps += Disturb(gyroscope_, seconds);
  reading.specific_force_mps2 += Disturb(accelerometer_, seconds);
  return reading;
}

// In the world frame; the imu goes round the centre of mass when the quadrotor turns.
Eigen::Vector3d ImuModel::VelocityOfImu(const QuadrotorState& state) const {
  return state.velocity_world_mps +
         state.T_world_base.linear() *
             state.angular_velocity_base_radps.cross(T_base_imu_.translation());
}

Eigen::Vector3d ImuModel::GaussianVector() {
  const double x = random_.Gaussian(), y = random_.Gaussian(), z = random_.Gaussian();
  return {x, y, z};
}

Eigen::Vector3d ImuModel::Disturb(Disturbance& disturbance, double seconds) {
  const double root_s = std::sqrt(seconds);
  disturbance.bias += disturbance.walk_per_sqrt_s * root_s * GaussianVector();
  return disturbance.bias + disturbance.noise_per_sqrt_hz / root_s * GaussianVector();
}

}  // namespace semantic_slam
