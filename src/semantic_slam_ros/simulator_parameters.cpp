#include "semantic_slam_ros/simulator_parameters.h"

#include <cmath>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

using semantic_slam::ConfigError;
using semantic_slam::Rigid3d;
using semantic_slam::SimulatedFlightOptions;
using semantic_slam::Tour;

bool IsControlled(const ros::NodeHandle& private_nh, const SimulatorNodeOptions& options) {
  if (options.follow == "control") return true;
  if (options.follow == "tour" && !options.tour.empty()) return false;
  throw ConfigError(private_nh.resolveName("follow") + " = " + options.follow +
                    ", but must be control, or tour with a file in ~tour");
}

std::string RequiredFile(const ros::NodeHandle& private_nh, const char* name,
                         const std::string& file) {
  if (!file.empty()) return file;
  throw ConfigError(private_nh.resolveName(name) + " is empty, but must name a file");
}

Tour LoadTourIfNamed(const SimulatorNodeOptions& options) {
  return options.tour.empty() ? Tour() : semantic_slam::LoadTour(options.tour);
}

Rigid3d FlightStart(const SimulatorNodeOptions& options, const Tour& tour) {
  if (!tour.waypoints.empty()) {
    const semantic_slam::Waypoint& first = tour.waypoints.front();
    return Eigen::Translation3d(first.position_m) *
           Eigen::AngleAxisd(first.yaw_rad, Eigen::Vector3d::UnitZ());
  }
  return Eigen::Translation3d(options.start_x_m, options.start_y_m, options.start_z_m) *
         Eigen::AngleAxisd(options.start_yaw_deg * M_PI / 180.0, Eigen::Vector3d::UnitZ());
}

SimulatedFlightOptions FlightOptionsFor(const Tour& tour, SimulatedFlightOptions options) {
  if (tour.max_speed_mps) options.follower.max_speed_mps = *tour.max_speed_mps;
  return options;
}

}  // namespace semantic_slam_ros
