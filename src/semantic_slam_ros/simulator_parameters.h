#pragma once

#include <string>

#include <ros/node_handle.h>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam/simulation/box_errors.h"
#include "semantic_slam/simulation/label_errors.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "semantic_slam/simulation/simulated_flight.h"
#include "semantic_slam/simulation/visible_boxes.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/lockstep.h"

namespace semantic_slam_ros {

struct SimulatorNodeOptions {
  std::string world;   // file with the world; must be given
  std::string camera;  // file with the camera's calibration; must be given
  std::string tour;  // file with a tour; the drone starts at its first waypoint. Empty: at start_*
  double start_x_m = 0.0;  // in the world
  double start_y_m = 0.0;
  double start_z_m = 1.2;
  double start_yaw_deg = 0.0;
  // Who steers. "control": whoever publishes attitude_thrust. "tour": the simulator, by the true
  // pose.
  std::string follow = "control";
  double rate = 1.0;                 // simulated over real time, at most; 0: as fast as it can
  bool publish_labels = true;        // semantic_image, in place of a segmentation network
  double labels_period_s = 0.2;      // between two of them, by their stamps; 0: every image
  bool publish_detections = true;    // in place of a detection network
  double detections_period_s = 0.2;  // between two of them, by their stamps; 0: every image
  double duration_s = 0.0;           // of the flight, after which the node ends; 0: no end
  bool exit_when_done = false;       // end when the last waypoint was reached
  double exit_delay_s = 2.0;         // after that, of simulated time

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("world", self.world);
    visit("camera", self.camera);
    visit("tour", self.tour);
    visit("start_x_m", self.start_x_m, -1000.0, 1000.0);
    visit("start_y_m", self.start_y_m, -1000.0, 1000.0);
    visit("start_z_m", self.start_z_m, -1000.0, 1000.0);
    visit("start_yaw_deg", self.start_yaw_deg, -360.0, 360.0);
    visit("follow", self.follow);
    visit("rate", self.rate, 0.0, 100.0);
    visit("publish_labels", self.publish_labels);
    visit("labels_period_s", self.labels_period_s, 0.0, 3600.0);
    visit("publish_detections", self.publish_detections);
    visit("detections_period_s", self.detections_period_s, 0.0, 3600.0);
    visit("duration_s", self.duration_s, 0.0, 86400.0);
    visit("exit_when_done", self.exit_when_done);
    visit("exit_delay_s", self.exit_delay_s, 0.0, 3600.0);
  }
};

struct SimulatorFrameOptions {
  std::string world_frame = "world";
  std::string base_frame = "base_link";
  std::string camera_frame = "camera_link";
  std::string optical_frame = "camera_color_optical_frame";
  std::string imu_frame = "camera_imu_optical_frame";

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("world_frame", self.world_frame);
    visit("base_frame", self.base_frame);
    visit("camera_frame", self.camera_frame);
    visit("optical_frame", self.optical_frame);
    visit("imu_frame", self.imu_frame);
  }
};

// Everything that simulator_node reads from its private parameters.
struct SimulatorNodeParameters {
  SimulatorNodeOptions node;
  LockstepOptions lockstep;
  LabelOptions labels;
  SimulatorFrameOptions frames;
  semantic_slam::SimulatedFlightOptions flight;
  semantic_slam::SimulatedCameraOptions camera;
  semantic_slam::LabelErrorOptions label_errors;
  semantic_slam::VisibleBoxesOptions visible_boxes;
  semantic_slam::BoxErrorOptions box_errors;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.lockstep);
    visit("", self.labels);
    visit("", self.frames);
    semantic_slam::SimulatedFlightOptions::VisitGroups(self.flight, visit);
    semantic_slam::SimulatedCameraOptions::VisitGroups(self.camera, visit);
    visit("label_errors", self.label_errors);
    visit("visible_boxes", self.visible_boxes);
    visit("box_errors", self.box_errors);
  }
};

// Whether the drone is controlled from outside; else the simulator flies the tour. Throws
// ConfigError if ~follow is something else, or there is no tour to fly.
bool IsControlled(const ros::NodeHandle& private_nh, const SimulatorNodeOptions& options);

// `file`, or throws ConfigError naming the parameter if it is empty.
std::string RequiredFile(const ros::NodeHandle& private_nh, const char* name,
                         const std::string& file);

// A tour without waypoints if there is no file.
semantic_slam::Tour LoadTourIfNamed(const SimulatorNodeOptions& options);

// T_world_base at the tour's first waypoint, or at start_* for a tour without.
semantic_slam::Rigid3d FlightStart(const SimulatorNodeOptions& options,
                                   const semantic_slam::Tour& tour);

// With the speed that the tour wants.
semantic_slam::SimulatedFlightOptions FlightOptionsFor(
    const semantic_slam::Tour& tour, semantic_slam::SimulatedFlightOptions options);

}  // namespace semantic_slam_ros
