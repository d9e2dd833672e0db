#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <ros/node_handle.h>
#include <semantic_slam/Query.h>
#include <semantic_slam/TrackedObjectArray.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp_joiner.h"
#include "semantic_slam/object_mapping/object_mapper.h"
#include "semantic_slam_ros/counted_joiner.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/graph_input.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/map_saver.h"
#include "semantic_slam_ros/map_worker.h"
#include "semantic_slam_ros/node_health.h"
#include "semantic_slam_ros/object_markers.h"
#include "semantic_slam_ros/rgbd_input.h"

namespace semantic_slam_ros {

struct ObjectMappingNodeOptions {
  int queue_size = 3;           // images waiting for their turn; the oldest goes when another comes
  int max_waiting_images = 30;  // images that wait for their tracks; the oldest goes likewise
  double publish_period_s = 0.5;  // of the wall's clock, between two object maps while they change
  std::string map_frame = "map";
  std::string output_directory;  // where the map is written on shutdown; empty: nowhere

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("queue_size", self.queue_size, 1, 1000);
    visit("max_waiting_images", self.max_waiting_images, 1, 1000);
    visit("publish_period_s", self.publish_period_s, 0.05, 60.0);
    visit("map_frame", self.map_frame);
    visit("output_directory", self.output_directory);
  }
};

// Everything that object_mapping_node reads from its private parameters.
struct ObjectMappingNodeParameters {
  ObjectMappingNodeOptions node;
  LabelOptions labels;
  RgbdInputOptions input;
  semantic_slam::ImagePairerOptions pairer;
  semantic_slam::PoseJoinerOptions pose_joiner;
  semantic_slam::ObjectMappingOptions mapping;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.labels);
    visit("", self.input);
    visit("pairer", self.pairer);
    visit("pose_joiner", self.pose_joiner);
    semantic_slam::ObjectMappingOptions::VisitGroups(self.mapping, visit);
  }
};

// Wires ObjectMapper to topics; docs/ros_api.md lists them. Callbacks only sort pointers: decoding,
// mapping and publishing happen on a thread of its own.
class ObjectMappingNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  ObjectMappingNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

  // Works off what is waiting and writes the map.
  ~ObjectMappingNode();

 private:
  // The images of a moment and the objects that were tracked in them; then with their pose.
  using ImageJoiner =
      semantic_slam::StampJoiner<RgbdMessages, semantic_slam::TrackedObjectArrayConstPtr>;
  using PoseJoiner = CountedJoiner<ImageJoiner::Joined>;

  ObjectMappingNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                    const ObjectMappingNodeParameters& parameters);

  void OnImages(RgbdMessages messages);
  void OnTracks(const semantic_slam::TrackedObjectArrayConstPtr& msg);
  void OnTracked(const semantic_slam::TrackedImage& image);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool OnQuery(semantic_slam::Query::Request& request, semantic_slam::Query::Response& response);
  void Join(std::optional<ImageJoiner::Joined> joined);

  // On the worker's thread.
  void FollowGraph(const semantic_slam::KeyframeGraph& graph);
  void Observe(const PoseJoiner::Joined& joined);
  void Publish();
  std::shared_ptr<const semantic_slam::CameraModel> CameraFor(const RgbdMessages& messages);

  semantic_slam::ObjectMap Objects() const;
  std::string Save(const std::string& folder) const;
  void Diagnose(NodeHealth::Status& status) const;

  const ObjectMappingNodeOptions options_;
  const std::shared_ptr<const semantic_slam::LabelVocabulary> vocabulary_;
  DropCounter drops_;

  // For the spinning thread.
  ImageJoiner image_joiner_;
  std::size_t counted_unjoined_ = 0;  // what of the joiner's count is in drops_ already
  PoseJoiner pose_joiner_;
  bool paused_ = false;

  mutable std::mutex map_mutex_;
  semantic_slam::ObjectMapper mapper_;  // guarded by map_mutex_
  std::atomic<bool> changed_{true};     // since the map was published last

  // For the worker's thread.
  std::shared_ptr<const semantic_slam::CameraIntrinsics> intrinsics_;
  std::shared_ptr<const semantic_slam::CameraModel> camera_;  // of intrinsics_
  ObjectMarkers markers_;
  const ros::Publisher objects_pub_;
  const ros::Publisher markers_pub_;

  NodeHealth health_;
  MapSaver saver_;
  std::unique_ptr<MapWorker<PoseJoiner::Joined>> worker_;
  std::unique_ptr<GraphInput> graph_input_;  // after the worker that it wakes, as what follows
  std::unique_ptr<RgbdInput> input_;
  ros::Subscriber tracks_sub_;
  ros::WallTimer publish_timer_;
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
  ros::ServiceServer query_service_;
};

}  // namespace semantic_slam_ros
