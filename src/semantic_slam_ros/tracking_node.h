#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <semantic_slam/SaveMap.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam/localization/trajectory_recorder.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/ground_truth.h"
#include "semantic_slam_ros/rgbd_input.h"
#include "semantic_slam_ros/tracking_publisher.h"
#include "semantic_slam_ros/tracking_stage.h"

namespace semantic_slam_ros {

struct TrackingNodeOptions {
  int queue_size = 2;  // images waiting for tracking; the oldest goes when another comes
  std::string output_directory;  // where the run's results are written on shutdown; empty: nowhere
  std::string ground_truth_frame = "world";  // root of what tf_ground_truth says

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("queue_size", self.queue_size, 1, 1000);
    visit("output_directory", self.output_directory);
    visit("ground_truth_frame", self.ground_truth_frame);
  }
};

// Everything that tracking_node reads from its private parameters.
struct TrackingNodeParameters {
  TrackingNodeOptions node;
  RgbdInputOptions input;
  TrackingPublisherOptions publisher;
  semantic_slam::ImagePairerOptions pairer;
  semantic_slam::LocalizationOptions localization;
};

// Throws ConfigError naming a parameter that is unknown, out of range or of another type.
TrackingNodeParameters ReadTrackingNodeParameters(const ros::NodeHandle& private_nh);

// Wires VisualLocalization to topics; docs/ros_api.md lists them. Callbacks only sort pointers;
// decoding, tracking and publishing happen on one thread of its own behind a bounded queue, local
// mapping on another.
class TrackingNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  TrackingNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

  // Works off what is waiting and writes the run's results.
  ~TrackingNode();

 private:
  TrackingNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
               const TrackingNodeParameters& parameters);

  void Process(const RgbdMessages& messages);
  // Notes the image for /diagnostics and the report. Returns the status before it.
  semantic_slam::TrackingStatus Remember(const TrackedFrame& frame, double latency_ms);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool OnSave(semantic_slam::SaveMap::Request& request, semantic_slam::SaveMap::Response& response);
  void Save(const std::string& folder);
  std::map<std::string, std::size_t> Drops() const;
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  // How tracking went lately, for /diagnostics.
  struct Health {
    semantic_slam::TrackedImage last;
    semantic_slam::DurationHistogram latency;
    std::string camera_frame;
  };

  const TrackingNodeOptions options_;
  DropCounter drops_;
  TrackingStage stage_;
  TrackingPublisher publisher_;
  GroundTruth ground_truth_;
  mutable std::mutex mutex_;
  semantic_slam::TrajectoryRecorder recorder_;  // guarded by mutex_
  Health health_;                               // guarded by mutex_
  diagnostic_updater::Updater diagnostics_;
  ros::WallTimer diagnostics_timer_;
  std::unique_ptr<semantic_slam::Worker<RgbdMessages>> worker_;
  std::unique_ptr<RgbdInput> input_;  // after the worker it feeds
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
  ros::ServiceServer save_service_;
};

}  // namespace semantic_slam_ros
