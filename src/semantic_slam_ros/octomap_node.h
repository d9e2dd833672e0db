#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam/octree/semantic_map.h"
#include "semantic_slam_ros/counted_joiner.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/graph_input.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/map_saver.h"
#include "semantic_slam_ros/map_worker.h"
#include "semantic_slam_ros/node_health.h"
#include "semantic_slam_ros/octomap_publisher.h"
#include "semantic_slam_ros/octomap_services.h"

namespace semantic_slam_ros {

struct OctomapNodeOptions {
  int queue_size = 3;  // clouds waiting for their turn; the oldest goes when another comes
  std::string output_directory;  // where the map is written on shutdown; empty: nowhere

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("queue_size", self.queue_size, 1, 1000);
    visit("output_directory", self.output_directory);
  }
};

// Everything that octomap_node reads from its private parameters.
struct OctomapNodeParameters {
  OctomapNodeOptions node;
  LabelOptions labels;
  OctomapPublisherOptions publisher;
  semantic_slam::PoseJoinerOptions pose_joiner;
  semantic_slam::SemanticMapperOptions mapper;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.labels);
    visit("", self.publisher);
    visit("pose_joiner", self.pose_joiner);
    semantic_slam::SemanticMapperOptions::VisitGroups(self.mapper, visit);
  }
};

// Wires SemanticMapper to topics; docs/ros_api.md lists them. Callbacks only sort pointers: reading
// clouds, mapping and publishing happen on a thread of its own, and on another one the map is made
// again when the camera's path was corrected, while the old one goes on.
class OctomapNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  OctomapNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

  // Works off what is waiting and writes the map.
  ~OctomapNode();

 private:
  struct Cloud {
    sensor_msgs::PointCloud2ConstPtr msg;
    std::chrono::steady_clock::time_point received;
  };
  using Joiner = CountedJoiner<Cloud>;
  using MapRebuild = semantic_slam::MapRebuild;

  OctomapNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
              const OctomapNodeParameters& parameters);

  void OnCloud(const sensor_msgs::PointCloud2ConstPtr& msg);
  void OnTracked(const semantic_slam::TrackedImage& image);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  // With map_mutex_ held: begins to make the map again if it should be.
  void StartRebuild();

  // On the rebuilder's thread.
  void Rebuild(MapRebuild& rebuild);

  // On the worker's thread.
  void FollowGraph(const semantic_slam::KeyframeGraph& graph);
  void Insert(const Joiner::Joined& joined);
  void Publish();

  std::string Save(const std::string& folder);
  void Diagnose(NodeHealth::Status& status);

  const OctomapNodeOptions options_;
  const std::shared_ptr<const semantic_slam::LabelVocabulary> vocabulary_;
  DropCounter drops_;
  Joiner joiner_;        // for the spinning thread
  bool paused_ = false;  // for the spinning thread

  std::mutex map_mutex_;
  semantic_slam::SemanticMapper mapper_;  // guarded by map_mutex_
  bool is_rebuilding_ = false;            // guarded by map_mutex_
  std::atomic<bool> stop_rebuilding_{false};
  OctomapPublisher publisher_;  // for the worker's thread

  NodeHealth health_;
  MapSaver saver_;
  OctomapServices services_;
  std::unique_ptr<semantic_slam::Worker<std::shared_ptr<MapRebuild>>> rebuilder_;
  std::unique_ptr<MapWorker<Joiner::Joined>> worker_;  // after the rebuilder that it hands work to
  std::unique_ptr<GraphInput> graph_input_;  // after the worker that it wakes, as what follows
  ros::Subscriber cloud_sub_;
  ros::WallTimer publish_timer_;
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
};

}  // namespace semantic_slam_ros
