#pragma once

#include <optional>

#include <Eigen/Core>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/position_controller.h"
#include "semantic_slam/control/velocity_estimator.h"
#include "semantic_slam/control/waypoint_follower.h"

namespace semantic_slam {

// The options of flying by poses, in the groups that configuration files use.
struct WaypointControllerOptions {
  QuadrotorParameters quadrotor;
  PositionControllerOptions position_controller;
  ThrustLimits thrust;
  WaypointFollowerOptions follower;
  VelocityEstimatorOptions velocity_estimator;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("quadrotor", self.quadrotor);
    visit_group("position_controller", self.position_controller);
    visit_group("thrust", self.thrust);
    visit_group("follower", self.follower);
    visit_group("velocity_estimator", self.velocity_estimator);
  }
};

// Where the base is, as somebody measured it.
struct BasePose {
  Stamp stamp;
  Rigid3d T_odom_base = Rigid3d::Identity();         // continuous
  Rigid3d T_map_odom = Rigid3d::Identity();          // jumps when the map is corrected
  std::optional<Eigen::Vector3d> velocity_odom_mps;  // if known better than by the poses
};

// Flies through waypoints by measured poses, some tens per second: estimates the velocity, leads
// the reference, and says which attitude and thrust follow it, thesis section 3.2.3. Waypoints are
// in the map frame, z up. A correction of the map moves the reference with the drone, so that it
// neither jerks nor is the velocity mistaken. Not thread-safe.
class WaypointController {
 public:
  // Poses farther apart [s] have nothing to do with each other: velocity and reference begin anew.
  static constexpr double kMaxGapS = 0.5;

  // Throws ConfigError if an option is out of range.
  explicit WaypointController(const WaypointControllerOptions& options = {});

  // The command at the pose's stamp; its world is the map. Throws InputError, and changes nothing,
  // if a number is not finite or the stamp is not later than the one before.
  AttitudeCommand Update(const BasePose& pose);

  // There is no pose at `stamp`: the command brakes the speed that the drone had and flies level
  // then. Its world is the level frame at the drone's heading.
  AttitudeCommand FlyBlind(Stamp stamp);

  // The waypoints may be changed at any time.
  WaypointFollower& follower() { return follower_; }
  const WaypointFollower& follower() const { return follower_; }
  // From the drone to the waypoint that it flies to; 0 if there is none, or no pose yet.
  double DistanceToGo() const;

 private:
  void Check(const BasePose& pose) const;
  DronePlace PlaceOf(const BasePose& pose) const;
  void Restart(const BasePose& pose);
  void Follow(const BasePose& pose, double step_s);
  Eigen::Vector3d ExpectedAcceleration(const BasePose& pose) const;

  const double mass_kg_;
  VelocityEstimator estimator_;
  WaypointFollower follower_;
  PositionController position_controller_;
  std::optional<BasePose> last_;
  double thrust_n_ = 0.0;  // that was commanded last
  // In the level frame at the drone's heading, as far as known, at blind_stamp_.
  Eigen::Vector3d blind_velocity_mps_ = Eigen::Vector3d::Zero();
  std::optional<Stamp> blind_stamp_;
};

}  // namespace semantic_slam
