#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/control/quadrotor_state.h"

namespace semantic_slam {

// Of the BMI055 in a D455, after its calibration. Densities are those of data sheets: of white
// noise per square root of bandwidth; a bias walks away from where it began with the square root of
// time.
struct ImuOptions {
  bool noise = true;                                  // false: a perfect one
  double gyroscope_noise_radps_per_sqrt_hz = 2.4e-4;  // 0.014 deg/s/sqrt(Hz)
  double gyroscope_bias_radps = 2e-3;                 // standard deviation at switch-on, per axis
  double gyroscope_walk_radps_per_sqrt_s = 2e-5;      // of the bias
  double accelerometer_noise_mps2_per_sqrt_hz = 1.5e-3;  // 150 ug/sqrt(Hz)
  double accelerometer_bias_mps2 = 0.02;             // standard deviation at switch-on, per axis
  double accelerometer_walk_mps2_per_sqrt_s = 3e-4;  // of the bias
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("noise", self.noise);
    visit("gyroscope_noise_radps_per_sqrt_hz", self.gyroscope_noise_radps_per_sqrt_hz, 0.0, 1.0);
    visit("gyroscope_bias_radps", self.gyroscope_bias_radps, 0.0, 1.0);
    visit("gyroscope_walk_radps_per_sqrt_s", self.gyroscope_walk_radps_per_sqrt_s, 0.0, 1.0);
    visit("accelerometer_noise_mps2_per_sqrt_hz", self.accelerometer_noise_mps2_per_sqrt_hz, 0.0,
          1.0);
    visit("accelerometer_bias_mps2", self.accelerometer_bias_mps2, 0.0, 5.0);
    visit("accelerometer_walk_mps2_per_sqrt_s", self.accelerometer_walk_mps2_per_sqrt_s, 0.0, 1.0);
    visit("seed", self.seed, 0, 1000000);
  }
};

// In the imu's axes.
struct ImuReading {
  Stamp stamp;
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();
  // What an accelerometer feels: at rest it points up with 9.81.
  Eigen::Vector3d specific_force_mps2 = Eigen::Vector3d::Zero();
};

// An inertial sensor on a quadrotor. Not thread-safe.
class ImuModel {
 public:
  // Throws ConfigError if an option is out of range.
  ImuModel(const ImuOptions& options, const Rigid3d& T_base_imu);

  // The reading at `stamp`, where the quadrotor is in the state `now`, `seconds` after it was in
  // `before`. The specific force is the mean over that time, as of a sensor whose filter fits its
  // rate. Precondition: seconds > 0.
  ImuReading Measure(Stamp stamp, const QuadrotorState& before, const QuadrotorState& now,
                     double seconds);

 private:
  // White noise on a bias that walks.
  struct Disturbance {
    double noise_per_sqrt_hz;
    double walk_per_sqrt_s;
    Eigen::Vector3d bias;
  };

  Eigen::Vector3d VelocityOfImu(const QuadrotorState& state) const;
  Eigen::Vector3d GaussianVector();
  Eigen::Vector3d Disturb(Disturbance& disturbance, double seconds);

  const ImuOptions options_;
  const Rigid3d T_base_imu_;
  RandomStream random_;
  Disturbance gyroscope_;
  Disturbance accelerometer_;
};

}  // namespace semantic_slam
