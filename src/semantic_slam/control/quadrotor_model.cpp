#include "semantic_slam/control/quadrotor_model.h"

#include <cassert>
#include <string>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

bool AllFinite(const QuadrotorState& state) {
  return IsFinite(state.T_world_base) && state.velocity_world_mps.allFinite() &&
         state.angular_velocity_base_radps.allFinite() && state.rotor_speeds_radps.allFinite();
}

void RequireFinite(bool finite, const char* what) {
  if (!finite)
    throw InputError(std::string(what) + " of the quadrotor has a number that is not finite");
}

}  // namespace

struct QuadrotorModel::Derivative {
  Eigen::Vector3d velocity_mps;
  Eigen::Vector3d acceleration_mps2;
  Eigen::Matrix3d rotation_per_s;
  Eigen::Vector3d angular_acceleration_radps2;
  Eigen::Vector4d rotor_acceleration_radps2;

  // Where `state` comes to in `seconds` if nothing changes the derivative.
  QuadrotorState Applied(const QuadrotorState& state, double seconds) const {
    QuadrotorState later = state;
    later.T_world_base.translation() += seconds * velocity_mps;
    later.velocity_world_mps += seconds * acceleration_mps2;
    later.T_world_base.linear() += seconds * rotation_per_s;
    later.angular_velocity_base_radps += seconds * angular_acceleration_radps2;
    later.rotor_speeds_radps += seconds * rotor_acceleration_radps2;
    return later;
  }
};

QuadrotorModel::QuadrotorModel(const QuadrotorParameters& parameters)
    : parameters_(Validated(parameters)), mixer_(parameters) {}

QuadrotorState QuadrotorModel::Hovering(const Rigid3d& T_world_base) const {
  QuadrotorState state;
  state.T_world_base = T_world_base;
  state.rotor_speeds_radps.setConstant(parameters_.hover_rotor_speed_radps());
  return state;
}

Eigen::Vector3d QuadrotorModel::Acceleration(const QuadrotorState& state,
                                             const Eigen::Vector3d& push_world_n) const {
  const Eigen::Matrix3d R_world_base = state.T_world_base.linear();
  const Eigen::Vector3d axis = R_world_base.col(2);
  const Eigen::Vector3d& v = state.velocity_world_mps;
  const Eigen::Vector3d across = v - axis * axis.dot(v);
  // Furrer et al. 2016, eq. 2.5 and 2.7: thrust, and the drag of the blades.
  const Eigen::Vector3d force =
      axis * mixer_.WrenchOf(state.rotor_speeds_radps).thrust_n -
      parameters_.rotor_drag_n_s2_per_m * state.rotor_speeds_radps.cwiseAbs().sum() * across;
  return (force + push_world_n) / parameters_.mass_kg() - Eigen::Vector3d(0, 0, kGravityMps2);
}

Eigen::Vector3d QuadrotorModel::AngularAcceleration(const QuadrotorState& state) const {
  const Eigen::Vector3d& rates = state.angular_velocity_base_radps;
  const Eigen::Vector3d inertia = parameters_.inertia_kg_m2();
  const Eigen::Vector3d momentum = inertia.cwiseProduct(rates);
  const Eigen::Vector3d torque = mixer_.WrenchOf(state.rotor_speeds_radps).torque_nm -
                                 parameters_.rotational_drag_nms * rates - rates.cross(momentum);
  return torque.cwiseQuotient(inertia);
}

QuadrotorModel::Derivative QuadrotorModel::DerivativeOf(const QuadrotorState& state,
                                                        const Eigen::Vector4d& rotor_commands_radps,
                                                        const Eigen::Vector3d& push_world_n) const {
  Derivative derivative;
  derivative.velocity_mps = state.velocity_world_mps;
  derivative.acceleration_mps2 = Acceleration(state, push_world_n);
  derivative.rotation_per_s = state.T_world_base.linear() * Skew(state.angular_velocity_base_radps);
  derivative.angular_acceleration_radps2 = AngularAcceleration(state);
  for (int i = 0; i < 4; ++i) {
    const double gap = rotor_commands_radps[i] - state.rotor_speeds_radps[i];
    derivative.rotor_acceleration_radps2[i] =
        gap /
        (gap > 0.0 ? parameters_.spin_up_time_constant_s : parameters_.slow_down_time_constant_s);
  }
  return derivative;
}

QuadrotorState QuadrotorModel::Step(const QuadrotorState& state,
                                    const Eigen::Vector4d& rotor_commands_radps, double step_s,
                                    const Eigen::Vector3d& push_world_n) const {
  assert(step_s > 0.0);
  RequireFinite(AllFinite(state), "the state");
  RequireFinite(rotor_commands_radps.allFinite(), "a rotor command");
  RequireFinite(push_world_n.allFinite(), "the push");
  const Eigen::Vector4d commands =
      rotor_commands_radps.cwiseMax(0.0).cwiseMin(parameters_.max_rotor_speed_radps);

  const Derivative k1 = DerivativeOf(state, commands, push_world_n);
  const Derivative k2 = DerivativeOf(k1.Applied(state, step_s / 2), commands, push_world_n);
  const Derivative k3 = DerivativeOf(k2.Applied(state, step_s / 2), commands, push_world_n);
  const Derivative k4 = DerivativeOf(k3.Applied(state, step_s), commands, push_world_n);
  QuadrotorState later = k1.Applied(state, step_s / 6);
  later = k2.Applied(later, step_s / 3);
  later = k3.Applied(later, step_s / 3);
  later = k4.Applied(later, step_s / 6);
  later.T_world_base = Orthonormalised(later.T_world_base);
  return later;
}

}  // namespace semantic_slam
