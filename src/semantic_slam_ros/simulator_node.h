#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <semantic_slam/AttitudeThrust.h>
#include <semantic_slam/TrackingState.h>
#include <semantic_slam/WaypointStatus.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/throttle.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam/simulation/box_errors.h"
#include "semantic_slam/simulation/label_errors.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "semantic_slam/simulation/simulated_flight.h"
#include "semantic_slam/simulation/visible_boxes.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/lockstep.h"
#include "semantic_slam_ros/node_health.h"
#include "semantic_slam_ros/simulation_pace.h"
#include "semantic_slam_ros/simulator_parameters.h"
#include "semantic_slam_ros/simulator_publisher.h"

namespace semantic_slam_ros {

// A drone with an RGB-D camera in a simulated world, in place of a real one; docs/ros_api.md lists
// its topics. It owns /clock. Time goes on from image to image on a thread of its own, in lockstep
// with tracking and control or by the wall's clock; callbacks only sort messages.
class SimulatorNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  SimulatorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);
  ~SimulatorNode();

 private:
  struct Tick {};  // an image is due

  // For /diagnostics.
  struct Progress {
    std::int64_t images = 0;
    semantic_slam::Stamp stamp;
  };

  SimulatorNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                const SimulatorNodeParameters& parameters);

  std::unique_ptr<semantic_slam::SimulatedFlight> MakeFlight() const;

  // These run on the loop's thread.
  void Work();
  bool Prepare();
  void Restart();
  void ShowImage();
  void ShowNetworks(const semantic_slam::SimulatedImage& image, semantic_slam::Stamp stamp);
  double WorldTime(semantic_slam::Stamp stamp) const;
  void Steer();
  bool IsOver();

  void OnCommand(const semantic_slam::AttitudeThrustConstPtr& msg);
  void OnTracked(const semantic_slam::TrackingStateConstPtr& msg);
  void OnWaypointStatus(const semantic_slam::WaypointStatusConstPtr& msg);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void Diagnose(NodeHealth::Status& status);
  double ImagesPerSecond(const Progress& progress);

  const SimulatorNodeParameters parameters_;
  const bool is_controlled_;  // from outside; else it flies the tour
  const semantic_slam::LabelVocabulary vocabulary_;
  const semantic_slam::Tour tour_;
  const semantic_slam::Rigid3d T_world_start_;
  const std::shared_ptr<const semantic_slam::World> world_;
  const semantic_slam::SimulatedCamera camera_;
  const semantic_slam::VisibleBoxes visible_boxes_;
  const semantic_slam::LabelErrors label_errors_;
  const semantic_slam::BoxErrors box_errors_;
  DropCounter drops_;
  SimulatorPublisher publisher_;
  SimulationPace pace_;
  Lockstep lockstep_;
  std::atomic<bool> is_paused_{false};
  std::atomic<bool> wants_reset_{false};
  std::atomic<bool> is_way_done_{false};  // the controller has come to the last waypoint

  mutable std::mutex mutex_;
  Progress progress_;                                             // guarded by mutex_
  std::vector<semantic_slam::RelativeAttitudeCommand> commands_;  // guarded by mutex_

  // For the loop's thread.
  std::unique_ptr<semantic_slam::SimulatedFlight> flight_;
  semantic_slam::Throttle labels_throttle_;
  semantic_slam::Throttle detections_throttle_;
  bool is_prepared_ = false;
  bool is_under_way_ = false;
  std::optional<semantic_slam::Stamp> done_;

  // For the spinning thread.
  NodeHealth health_;
  Progress diagnosed_;
  std::chrono::steady_clock::time_point diagnosed_at_;
  ros::Subscriber command_sub_;
  ros::Subscriber tracking_sub_;
  ros::Subscriber status_sub_;
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
  semantic_slam::Worker<Tick> loop_;  // last: its thread uses all of the above
};

}  // namespace semantic_slam_ros
