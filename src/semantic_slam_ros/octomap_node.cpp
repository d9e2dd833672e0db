#include "semantic_slam_ros/octomap_node.h"

#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/map_export.h"
#include "semantic_slam/octree/map_picture.h"
#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;
using semantic_slam::KeyframeGraph;
using semantic_slam::SemanticMapper;
using semantic_slam::TrackedImage;
using semantic_slam::WhenFull;

namespace {

constexpr int kCloudQueueSize = 5;
constexpr double kMegabyte = 1048576.0;

}  // namespace

OctomapNode::OctomapNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : OctomapNode(nh, private_nh, ReadParameters<OctomapNodeParameters>(private_nh)) {}

OctomapNode::OctomapNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                         const OctomapNodeParameters& parameters)
    : options_(parameters.node),
      vocabulary_(std::make_shared<const semantic_slam::LabelVocabulary>(
          LoadLabels(private_nh, parameters.labels))),
      joiner_(parameters.pose_joiner, drops_),
      mapper_(parameters.mapper, vocabulary_),
      publisher_(nh, parameters.publisher, *vocabulary_),
      health_(nh, private_nh, "octomap", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      saver_(private_nh, topics::kSaveMap, options_.output_directory,
             [this](const std::string& folder) { return Save(folder); }),
      worker_(std::make_unique<semantic_slam::Worker<Wake>>(1, WhenFull::kDropOldest,
                                                            [this](Wake) { Work(); })),
      graph_input_(std::make_unique<GraphInput>(
          nh, drops_, [this](const TrackedImage& image) { OnTracked(image); },
          [this](KeyframeGraph graph) { OnGraph(std::move(graph)); })) {
  cloud_sub_ = nh.subscribe(topics::kSemanticCloud, kCloudQueueSize, &OctomapNode::OnCloud, this);
  // By the wall's clock: the map must reach who looks at it also while a simulated one stands.
  publish_timer_ = nh.createWallTimer(ros::WallDuration(parameters.publisher.publish_period_s),
                                      [this](const ros::WallTimerEvent&) {
                                        publish_is_due_ = true;
                                        worker_->Push({});
                                      });
  reset_service_ = private_nh.advertiseService(topics::kReset, &OctomapNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &OctomapNode::OnPause, this);
}

OctomapNode::~OctomapNode() {
  publish_timer_.stop();
  cloud_sub_.shutdown();
  graph_input_.reset();
  worker_.reset();
  saver_.SaveOnShutdown();
}

void OctomapNode::OnCloud(const sensor_msgs::PointCloud2ConstPtr& msg) {
  if (paused_ || !HasStamp(msg->header, "semantic cloud", drops_)) return;
  Enqueue(joiner_.AddPayload(ToStamp(msg->header.stamp), {msg, std::chrono::steady_clock::now()}));
}

void OctomapNode::OnTracked(const TrackedImage& image) {
  Enqueue(joiner_.AddTracked(image));
}

void OctomapNode::OnGraph(KeyframeGraph graph) {
  {
    std::lock_guard<std::mutex> lock(waiting_mutex_);
    newest_graph_ = std::move(graph);
  }
  worker_->Push({});
}

void OctomapNode::Enqueue(std::vector<Joiner::Joined> joined) {
  if (joined.empty()) return;
  std::size_t late = 0;
  {
    std::lock_guard<std::mutex> lock(waiting_mutex_);
    for (Joiner::Joined& each : joined) waiting_.push_back(std::move(each));
    for (; waiting_.size() > static_cast<std::size_t>(options_.queue_size); ++late)
      waiting_.pop_front();
  }
  if (late > 0) drops_.AddQuietly("late", late);
  worker_->Push({});
}

void OctomapNode::Work() {
  std::deque<Joiner::Joined> clouds;
  std::optional<KeyframeGraph> graph;
  {
    std::lock_guard<std::mutex> lock(waiting_mutex_);
    clouds.swap(waiting_);
    graph.swap(newest_graph_);
  }
  if (graph) FollowGraph(*graph);
  for (const Joiner::Joined& cloud : clouds) Insert(cloud);
  if (publish_is_due_.exchange(false)) Publish();
}

void OctomapNode::FollowGraph(const KeyframeGraph& graph) {
  std::lock_guard<std::mutex> lock(map_mutex_);
  const std::size_t rebuilds = mapper_.counts().rebuilds;
  try {
    if (!mapper_.FollowGraph(graph)) return;
  } catch (const InputError& e) {
    drops_.Add("bad_keyframes", e.what());
    return;
  }
  if (mapper_.counts().rebuilds > rebuilds) {
    ROS_INFO("the camera's path was corrected: the map was made again from %zu clouds",
             mapper_.clouds().clouds().size());
  } else {
    ROS_WARN("tracking began map %d: the old one is forgotten", mapper_.map_id());
  }
}

void OctomapNode::Insert(const Joiner::Joined& joined) {
  try {
    const semantic_slam::SemanticCloud cloud = ToSemanticCloud(*joined.payload.msg, *vocabulary_);
    std::lock_guard<std::mutex> lock(map_mutex_);
    if (!mapper_.Insert(cloud, joined.image)) {
      drops_.AddQuietly("unknown_keyframe");
      return;
    }
  } catch (const InputError& e) {
    drops_.Add("bad_cloud", e.what());
    return;
  }
  health_.AddLatency(joined.payload.received);
}

void OctomapNode::Publish() {
  {
    std::lock_guard<std::mutex> lock(map_mutex_);
    if (!publisher_.IsDue(mapper_.version())) return;
    publisher_.Collect(mapper_);
  }
  publisher_.Send();
}

bool OctomapNode::OnReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  {
    std::lock_guard<std::mutex> lock(waiting_mutex_);
    waiting_.clear();
  }
  std::lock_guard<std::mutex> lock(map_mutex_);
  mapper_.Reset();
  response.success = true;
  response.message = "the map is forgotten; it begins anew with the next cloud";
  return true;
}

bool OctomapNode::OnPause(std_srvs::SetBool::Request& request,
                          std_srvs::SetBool::Response& response) {
  paused_ = request.data;
  response.success = true;
  response.message = request.data ? "paused: clouds are thrown away" : "mapping goes on";
  return true;
}

std::string OctomapNode::Save(const std::string& folder) {
  std::lock_guard<std::mutex> lock(map_mutex_);
  semantic_slam::WriteMapFiles(folder + "/semantic_map", mapper_.tree(), *vocabulary_);
  semantic_slam::MapPictureOptions picture;
  picture.camera_path_m = mapper_.CameraPath();
  semantic_slam::WriteMapFromAbove(folder + "/map_top.png", mapper_.tree(), *vocabulary_, picture);
  return "the semantic map is in " + folder;
}

void OctomapNode::Diagnose(NodeHealth::Status& status) {
  if (health_.processed() == 0) {
    status.summary(DiagnosticStatus::WARN, "no cloud has been entered yet");
  } else {
    status.summary(DiagnosticStatus::OK, "mapping");
  }
  status.add("clouds", health_.processed());
  std::unique_lock<std::mutex> lock(map_mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;  // it is being worked on; the next message has it
  status.add("map", mapper_.map_id());
  status.add("octree nodes", mapper_.tree().size());
  status.addf("kept clouds [MB]", "%.1f",
              static_cast<double>(mapper_.clouds().bytes()) / kMegabyte);
  status.add("keeps one cloud of", mapper_.clouds().keeps_one_of());
  status.add("rebuilds", mapper_.counts().rebuilds);
}

}  // namespace semantic_slam_ros
