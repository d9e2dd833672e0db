#pragma once

#include <memory>
#include <mutex>
#include <string>

#include <ros/node_handle.h>
#include <semantic_slam/LoadMap.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/localization/trajectory_recorder.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/ground_truth.h"
#include "semantic_slam_ros/map_saver.h"
#include "semantic_slam_ros/node_health.h"
#include "semantic_slam_ros/rgbd_input.h"
#include "semantic_slam_ros/stage_worker.h"
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
  TrackingMapOptions map;
  TrackingLabelOptions labels;
  RgbdInputOptions input;
  TrackingPublisherOptions publisher;
  semantic_slam::ImagePairerOptions pairer;
  semantic_slam::LocalizationOptions localization;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.map);
    visit("", self.labels);
    visit("", self.input);
    visit("", self.publisher);
    visit("pairer", self.pairer);
    semantic_slam::LocalizationOptions::VisitGroups(self.localization, visit);
  }
};

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
  semantic_slam::TrackingStatus Remember(const TrackedFrame& frame);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool OnLoadMap(semantic_slam::LoadMap::Request& request,
                 semantic_slam::LoadMap::Response& response);
  bool OnSetMapping(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  std::string Save(const std::string& folder);
  std::string SaveMap(const std::string& folder) const;
  std::string LoadMap(const std::string& path) const;
  std::shared_ptr<semantic_slam::VisualLocalization> RunningLocalization() const;
  void Diagnose(NodeHealth::Status& status);

  const TrackingNodeOptions options_;
  DropCounter drops_;
  TrackingStage stage_;
  TrackingPublisher publisher_;
  GroundTruth ground_truth_;
  mutable std::mutex mutex_;
  semantic_slam::TrajectoryRecorder recorder_;  // guarded by mutex_
  semantic_slam::TrackedImage last_;            // guarded by mutex_
  std::string camera_frame_;                    // guarded by mutex_
  NodeHealth health_;
  MapSaver saver_;
  MapSaver map_saver_;
  std::unique_ptr<StageWorker<RgbdMessages>> worker_;
  std::unique_ptr<RgbdInput> input_;  // after the worker it feeds
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
  ros::ServiceServer load_map_service_;
  ros::ServiceServer set_mapping_service_;
};

}  // namespace semantic_slam_ros
