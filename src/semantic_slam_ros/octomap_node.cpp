#include "semantic_slam_ros/octomap_node.h"

#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/map_export.h"
#include "semantic_slam/octree/map_picture.h"
#include "semantic_slam_ros/conversions.h"
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

namespace {

constexpr int kCloudQueueSize = 5;
constexpr double kMegabyte = 1048576.0;

// How often a rebuild runs beside the map before the map waits for it.
constexpr int kRebuildRuns = 5;

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
      services_(private_nh, FrameName(parameters.publisher.map_frame), map_mutex_, mapper_,
                [this] { worker_->Clear(); }),
      rebuilder_(std::make_unique<semantic_slam::Worker<std::shared_ptr<MapRebuild>>>(
          1, semantic_slam::WhenFull::kBlock,
          [this](const std::shared_ptr<MapRebuild>& rebuild) { Rebuild(*rebuild); })),
      worker_(std::make_unique<MapWorker<Joiner::Joined>>(
          options_.queue_size, drops_,
          MapWorker<Joiner::Joined>::Handlers{
              [this](const KeyframeGraph& graph) { FollowGraph(graph); },
              [this](const Joiner::Joined& cloud) { Insert(cloud); }, [this] { Publish(); }})),
      graph_input_(std::make_unique<GraphInput>(
          nh, drops_, [this](const TrackedImage& image) { OnTracked(image); },
          [this](KeyframeGraph graph) { worker_->Follow(std::move(graph)); })) {
  cloud_sub_ = nh.subscribe(topics::kSemanticCloud, kCloudQueueSize, &OctomapNode::OnCloud, this);
  // By the wall's clock: the map must reach who looks at it also while a simulated one stands.
  publish_timer_ = nh.createWallTimer(ros::WallDuration(parameters.publisher.publish_period_s),
                                      [this](const ros::WallTimerEvent&) { worker_->Publish(); });
  reset_service_ = private_nh.advertiseService(topics::kReset, &OctomapNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &OctomapNode::OnPause, this);
}

OctomapNode::~OctomapNode() {
  publish_timer_.stop();
  cloud_sub_.shutdown();
  graph_input_.reset();
  worker_.reset();
  stop_rebuilding_ = true;
  rebuilder_.reset();
  saver_.SaveOnShutdown();
}

void OctomapNode::OnCloud(const sensor_msgs::PointCloud2ConstPtr& msg) {
  if (paused_ || !HasStamp(msg->header, "semantic cloud", drops_)) return;
  worker_->Add(
      joiner_.AddPayload(ToStamp(msg->header.stamp), {msg, std::chrono::steady_clock::now()}));
}

void OctomapNode::OnTracked(const TrackedImage& image) {
  worker_->Add(joiner_.AddTracked(image));
}

void OctomapNode::FollowGraph(const KeyframeGraph& graph) {
  std::lock_guard<std::mutex> lock(map_mutex_);
  try {
    if (mapper_.TakeOver(graph))
      ROS_WARN("tracking began map %d: the old one is forgotten", mapper_.map_id());
  } catch (const InputError& e) {
    drops_.Add("bad_keyframes", e.what());
    return;
  }
  StartRebuild();
}

void OctomapNode::StartRebuild() {
  if (is_rebuilding_ || !mapper_.NeedsRebuild()) return;
  is_rebuilding_ = true;
  rebuilder_->Push(mapper_.BeginRebuild());
}

void OctomapNode::Rebuild(MapRebuild& rebuild) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(map_mutex_, std::defer_lock);
  // Clouds go on coming in. They are entered too, and as fewer come while fewer are entered this
  // ends soon; where they come in faster than that, the last ones with everything else waiting.
  bool is_finished = false;
  for (int run = 0; run < kRebuildRuns && !is_finished; ++run) {
    if (lock.owns_lock()) lock.unlock();
    rebuild.Run(stop_rebuilding_);
    if (stop_rebuilding_) return;
    lock.lock();
    is_finished = mapper_.FinishRebuild(rebuild);
  }
  if (!is_finished) {
    rebuild.Run();
    mapper_.FinishRebuild(rebuild);
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  ROS_INFO("the camera's path was corrected: the map was made again from %zu clouds in %.1f s",
           mapper_.clouds().clouds().size(), taken.count());
  is_rebuilding_ = false;
  StartRebuild();
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
  worker_->Clear();
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
  const semantic_slam::AnchoredClouds& clouds = mapper_.clouds();
  status.addf("kept clouds in memory [MB]", "%.1f",
              static_cast<double>(clouds.memory_bytes()) / kMegabyte);
  status.addf("kept clouds on disk [MB]", "%.1f",
              static_cast<double>(clouds.disk_bytes()) / kMegabyte);
  if (!clouds.disk_error().empty())
    status.mergeSummary(DiagnosticStatus::WARN, clouds.disk_error());
  status.add("rebuilding", is_rebuilding_);
  status.add("keeps one cloud of", mapper_.clouds().keeps_one_of());
  status.add("rebuilds", mapper_.counts().rebuilds);
}

}  // namespace semantic_slam_ros
