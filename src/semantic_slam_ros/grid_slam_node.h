#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_broadcaster.h>

#include "semantic_slam/common/throttle.h"
#include "semantic_slam/scan/scan_builder.h"
#include "semantic_slam/submaps/grid_mapper.h"
#include "semantic_slam_ros/counted_joiner.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/graph_input.h"
#include "semantic_slam_ros/map_saver.h"
#include "semantic_slam_ros/node_health.h"
#include "semantic_slam_ros/rgbd_input.h"
#include "semantic_slam_ros/stage_worker.h"

namespace semantic_slam_ros {

struct GridSlamNodeOptions {
  std::string map_source = "visual";  // who says where the camera is: tracking
  std::string map_frame = "map";
  std::string scan_frame = "camera_level";  // the camera's place, level; see publish_tf
  bool publish_tf = true;                   // the image's frame -> scan_frame, at every scan
  int queue_size = 2;         // images waiting for their turn; the oldest goes when another comes
  double min_period_s = 0.1;  // between two images that are looked at, by their stamps
  double map_period_s = 1.0;  // between two publications of the map, by the wall's clock
  std::string output_directory;  // where the map is written on shutdown; empty: nowhere

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("map_source", self.map_source);
    visit("map_frame", self.map_frame);
    visit("scan_frame", self.scan_frame);
    visit("publish_tf", self.publish_tf);
    visit("queue_size", self.queue_size, 1, 1000);
    visit("min_period_s", self.min_period_s, 0.0, 3600.0);
    visit("map_period_s", self.map_period_s, 0.1, 600.0);
    visit("output_directory", self.output_directory);
  }
};

// Everything that grid_slam_node reads from its private parameters.
struct GridSlamNodeParameters {
  GridSlamNodeOptions node;
  RgbdInputOptions input;
  semantic_slam::ImagePairerOptions pairer;
  semantic_slam::PoseJoinerOptions pose_joiner;
  semantic_slam::GridSlamOptions grid_slam;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.input);
    visit("pairer", self.pairer);
    visit("pose_joiner", self.pose_joiner);
    semantic_slam::GridSlamOptions::VisitGroups(self.grid_slam, visit);
  }
};

// Wires ScanBuilder and GridMapper to topics; docs/ros_api.md lists them. Callbacks sort pointers,
// move submaps and render the map; decoding images, scans and entering them happen on a thread of
// its own.
class GridSlamNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  GridSlamNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

  // Works off what is waiting and writes the map.
  ~GridSlamNode();

 private:
  using Joiner = CountedJoiner<RgbdMessages>;

  GridSlamNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
               const GridSlamNodeParameters& parameters);

  void OnPair(RgbdMessages messages);
  void OnTracked(const semantic_slam::TrackedImage& image);
  void OnGraph(const semantic_slam::KeyframeGraph& graph);
  void Push(std::vector<Joiner::Joined> joined);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  // On the worker's thread.
  void Process(const Joiner::Joined& joined);
  void FollowCalibration(const RgbdMessages& messages);
  void PublishScan(const semantic_slam::PlanarScan& scan, const Joiner::Joined& joined);
  void Enter(const semantic_slam::PlanarScan& scan, const semantic_slam::TrackedImage& image);

  void PublishMap();
  std::string Save(const std::string& folder);
  void Diagnose(NodeHealth::Status& status);

  const GridSlamNodeOptions options_;
  const semantic_slam::ScanBuilderOptions scan_options_;
  DropCounter drops_;
  Joiner joiner_;                     // for the spinning thread
  semantic_slam::Throttle throttle_;  // for the spinning thread

  std::shared_ptr<const semantic_slam::CameraIntrinsics> intrinsics_;  // for the worker's thread
  std::unique_ptr<const semantic_slam::ScanBuilder> scan_builder_;     // likewise
  tf2_ros::TransformBroadcaster tf_broadcaster_;                       // likewise

  std::mutex mutex_;
  semantic_slam::GridMapper mapper_;  // guarded by mutex_
  std::int64_t entered_ = 0;          // guarded by mutex_
  std::uint64_t published_ = 0;       // GridMapper::changes() of the last published map

  const ros::Publisher scan_pub_;
  const ros::Publisher map_pub_;
  const ros::Publisher metadata_pub_;
  NodeHealth health_;
  MapSaver saver_;
  std::unique_ptr<StageWorker<Joiner::Joined>> worker_;
  std::unique_ptr<GraphInput> graph_input_;  // after the worker they feed
  std::unique_ptr<RgbdInput> rgbd_input_;
  ros::WallTimer map_timer_;
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
};

}  // namespace semantic_slam_ros
