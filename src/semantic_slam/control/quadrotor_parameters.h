#pragma once

#include <cmath>

#include <Eigen/Core>

#include "semantic_slam/common/options.h"

namespace semantic_slam {

constexpr double kGravityMps2 = 9.81;

// What a quadrotor is made of. The defaults are the AscTec Hummingbird's, as Furrer et al. (RotorS,
// a modular Gazebo MAV simulator framework, 2016) give them, with a RealSense D455 under it.
struct QuadrotorParameters {
  double frame_mass_kg = 0.716;
  double payload_mass_kg = 0.1;  // at the centre of mass: the camera
  double inertia_x_kg_m2 = 0.007;
  double inertia_y_kg_m2 = 0.007;
  double inertia_z_kg_m2 = 0.012;
  double arm_length_m = 0.17;                // from the centre of mass to a rotor's axis
  double thrust_constant_n_s2 = 8.54858e-6;  // thrust over squared rotor speed
  double moment_constant_m = 0.016;          // a rotor's drag torque over its thrust
  double max_rotor_speed_radps = 838.0;
  double spin_up_time_constant_s = 0.0125;    // of a motor
  double slow_down_time_constant_s = 0.025;   // likewise
  double rotor_drag_n_s2_per_m = 8.06428e-5;  // per rotor speed and speed across the rotor's axis
  // Torque against body rates. The inflow changes a rotor's thrust when the body turns; that
  // damping is what keeps a tumbling quadrotor's rates finite.
  double rotational_drag_nms = 0.005;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("frame_mass_kg", self.frame_mass_kg, 0.01, 100.0);
    visit("payload_mass_kg", self.payload_mass_kg, 0.0, 100.0);
    visit("inertia_x_kg_m2", self.inertia_x_kg_m2, 1e-5, 100.0);
    visit("inertia_y_kg_m2", self.inertia_y_kg_m2, 1e-5, 100.0);
    visit("inertia_z_kg_m2", self.inertia_z_kg_m2, 1e-5, 100.0);
    visit("arm_length_m", self.arm_length_m, 0.01, 10.0);
    visit("thrust_constant_n_s2", self.thrust_constant_n_s2, 1e-9, 1.0);
    visit("moment_constant_m", self.moment_constant_m, 1e-4, 1.0);
    visit("max_rotor_speed_radps", self.max_rotor_speed_radps, 1.0, 1e5);
    visit("spin_up_time_constant_s", self.spin_up_time_constant_s, 1e-3, 10.0);
    visit("slow_down_time_constant_s", self.slow_down_time_constant_s, 1e-3, 10.0);
    visit("rotor_drag_n_s2_per_m", self.rotor_drag_n_s2_per_m, 0.0, 1.0);
    visit("rotational_drag_nms", self.rotational_drag_nms, 0.0, 10.0);
  }

  double mass_kg() const { return frame_mass_kg + payload_mass_kg; }
  double hover_thrust_n() const { return mass_kg() * kGravityMps2; }
  double max_rotor_thrust_n() const {
    return thrust_constant_n_s2 * max_rotor_speed_radps * max_rotor_speed_radps;
  }
  double max_thrust_n() const { return 4.0 * max_rotor_thrust_n(); }
  double hover_rotor_speed_radps() const {
    return std::sqrt(hover_thrust_n() / (4.0 * thrust_constant_n_s2));
  }
  Eigen::Vector3d inertia_kg_m2() const {
    return {inertia_x_kg_m2, inertia_y_kg_m2, inertia_z_kg_m2};
  }
};

}  // namespace semantic_slam
