#include "semantic_slam_ros/object_mapping_node.h"

#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <semantic_slam/SemanticObjectArray.h>
#include <visualization_msgs/MarkerArray.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/object_mapping/object_map_file.h"
#include "semantic_slam/object_mapping/object_query.h"
#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/object_conversions.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/query_conditions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;
using semantic_slam::KeyframeGraph;
using semantic_slam::ObjectMap;
using semantic_slam::TrackedImage;

namespace {

// Tracks wait for their images only as long as those wait for each other.
constexpr std::size_t kMaxWaitingResults = 5;
constexpr int kTopicQueueSize = 10;

ObjectMappingNodeOptions Checked(ObjectMappingNodeOptions options) {
  options.map_frame = FrameName(options.map_frame);
  if (options.map_frame.empty()) throw semantic_slam::ConfigError("~map_frame is empty");
  return options;
}

}  // namespace

ObjectMappingNode::ObjectMappingNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : ObjectMappingNode(nh, private_nh, ReadParameters<ObjectMappingNodeParameters>(private_nh)) {}

ObjectMappingNode::ObjectMappingNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                                     const ObjectMappingNodeParameters& parameters)
    : options_(Checked(parameters.node)),
      vocabulary_(std::make_shared<const semantic_slam::LabelVocabulary>(
          LoadLabels(private_nh, parameters.labels))),
      image_joiner_(static_cast<std::size_t>(options_.max_waiting_images), kMaxWaitingResults),
      pose_joiner_(parameters.pose_joiner, drops_),
      mapper_(parameters.mapping, vocabulary_),
      objects_pub_(nh.advertise<semantic_slam::SemanticObjectArray>(topics::kObjects, 1, true)),
      markers_pub_(nh.advertise<visualization_msgs::MarkerArray>(topics::kObjectMarkers, 1, true)),
      health_(nh, private_nh, "object mapping", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      saver_(private_nh, topics::kSaveMap, options_.output_directory,
             [this](const std::string& folder) { return Save(folder); }),
      worker_(std::make_unique<MapWorker<PoseJoiner::Joined>>(
          options_.queue_size, drops_,
          MapWorker<PoseJoiner::Joined>::Handlers{
              [this](const KeyframeGraph& graph) { FollowGraph(graph); },
              [this](const PoseJoiner::Joined& image) { Observe(image); },
              [this] {
                if (changed_.exchange(false)) Publish();
              }})),
      graph_input_(std::make_unique<GraphInput>(
          nh, drops_, [this](const TrackedImage& image) { OnTracked(image); },
          [this](KeyframeGraph graph) { worker_->Follow(std::move(graph)); })),
      input_(std::make_unique<RgbdInput>(
          nh, parameters.input, parameters.pairer, drops_,
          [this](RgbdMessages messages) { OnImages(std::move(messages)); })) {
  tracks_sub_ =
      nh.subscribe(topics::kTrackedObjects, kTopicQueueSize, &ObjectMappingNode::OnTracks, this);
  // By the wall's clock: the map must reach who looks at it also while a simulated one stands.
  publish_timer_ = nh.createWallTimer(ros::WallDuration(options_.publish_period_s),
                                      [this](const ros::WallTimerEvent&) { worker_->Publish(); });
  reset_service_ = private_nh.advertiseService(topics::kReset, &ObjectMappingNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &ObjectMappingNode::OnPause, this);
  query_service_ = private_nh.advertiseService(topics::kQuery, &ObjectMappingNode::OnQuery, this);
}

ObjectMappingNode::~ObjectMappingNode() {
  publish_timer_.stop();
  tracks_sub_.shutdown();
  input_.reset();
  graph_input_.reset();
  worker_.reset();
  saver_.SaveOnShutdown();
}

void ObjectMappingNode::OnImages(RgbdMessages messages) {
  const semantic_slam::Stamp stamp = messages.stamp;
  Join(image_joiner_.AddSource(stamp, std::move(messages)));
}

void ObjectMappingNode::OnTracks(const semantic_slam::TrackedObjectArrayConstPtr& msg) {
  if (paused_ || !HasStamp(msg->header, "tracked objects", drops_)) return;
  Join(image_joiner_.AddResult(ToStamp(msg->header.stamp), msg));
}

void ObjectMappingNode::Join(std::optional<ImageJoiner::Joined> joined) {
  const std::size_t unjoined = image_joiner_.unjoined_results();
  if (unjoined > counted_unjoined_) drops_.AddQuietly("no_images", unjoined - counted_unjoined_);
  counted_unjoined_ = unjoined;
  if (!joined) return;
  const semantic_slam::Stamp stamp = joined->source.stamp;
  worker_->Add(pose_joiner_.AddPayload(stamp, std::move(*joined)));
}

void ObjectMappingNode::OnTracked(const TrackedImage& image) {
  worker_->Add(pose_joiner_.AddTracked(image));
}

void ObjectMappingNode::FollowGraph(const KeyframeGraph& graph) {
  std::lock_guard<std::mutex> lock(map_mutex_);
  mapper_.FollowGraph(graph);
  changed_ = true;
}

void ObjectMappingNode::Observe(const PoseJoiner::Joined& joined) {
  const RgbdMessages& messages = joined.payload.source;
  semantic_slam::RgbdImage image;
  try {
    image = messages.Decode();
  } catch (const InputError& e) {
    drops_.Add("bad_image", e.what());
    return;
  }
  try {
    const auto tracks = ToObjectTracks(*joined.payload.result, *vocabulary_);
    const auto camera = CameraFor(messages);
    std::lock_guard<std::mutex> lock(map_mutex_);
    mapper_.Observe(tracks, image, *camera, joined.image);
  } catch (const InputError& e) {
    drops_.Add("bad_tracked_objects", e.what());
    return;
  }
  changed_ = true;
  health_.AddLatency(messages.received);
}

std::shared_ptr<const semantic_slam::CameraModel> ObjectMappingNode::CameraFor(
    const RgbdMessages& messages) {
  if (messages.intrinsics != intrinsics_) {
    camera_ = std::make_shared<const semantic_slam::CameraModel>(*messages.intrinsics);
    intrinsics_ = messages.intrinsics;
  }
  return camera_;
}

void ObjectMappingNode::Publish() {
  const ObjectMap map = Objects();
  objects_pub_.publish(ToSemanticObjectArray(map, options_.map_frame));
  markers_pub_.publish(markers_.Draw(map, *vocabulary_, options_.map_frame));
}

ObjectMap ObjectMappingNode::Objects() const {
  std::lock_guard<std::mutex> lock(map_mutex_);
  return mapper_.Objects();
}

bool ObjectMappingNode::OnReset(std_srvs::Trigger::Request&,
                                std_srvs::Trigger::Response& response) {
  worker_->Clear();
  {
    std::lock_guard<std::mutex> lock(map_mutex_);
    mapper_.Reset();
  }
  changed_ = true;
  response.success = true;
  response.message = "all objects are forgotten; ids go on";
  return true;
}

bool ObjectMappingNode::OnPause(std_srvs::SetBool::Request& request,
                                std_srvs::SetBool::Response& response) {
  paused_ = request.data;
  input_->SetPaused(request.data);
  response.success = true;
  response.message = request.data ? "paused: images are thrown away" : "mapping goes on";
  return true;
}

bool ObjectMappingNode::OnQuery(semantic_slam::Query::Request& request,
                                semantic_slam::Query::Response& response) {
  try {
    const auto label = ToLabel(request.class_name, *vocabulary_);
    const auto box = ToBox(request.box_min, request.box_max);
    ObjectMap map = Objects();
    map.objects = FindObjects(map, label, box);
    semantic_slam::SemanticObjectArray found = ToSemanticObjectArray(map, options_.map_frame);
    response.header = found.header;
    response.objects = std::move(found.objects);
    response.message = std::to_string(response.objects.size()) + " objects found";
    response.success = true;
  } catch (const InputError& e) {
    response.success = false;
    response.message = e.what();
  }
  return true;
}

std::string ObjectMappingNode::Save(const std::string& folder) const {
  semantic_slam::WriteObjectMap(folder + "/objects.json", Objects(), *vocabulary_);
  return "the object map is in " + folder;
}

void ObjectMappingNode::Diagnose(NodeHealth::Status& status) const {
  if (health_.processed() == 0) {
    status.summary(DiagnosticStatus::WARN, "no tracked objects have been mapped yet");
  } else {
    status.summary(DiagnosticStatus::OK, "mapping objects");
  }
  status.add("images", health_.processed());
  std::unique_lock<std::mutex> lock(map_mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;  // it is being worked on; the next message has it
  const ObjectMap map = mapper_.Objects();
  status.add("map", map.map_id);
  status.add("objects", map.objects.size());
}

}  // namespace semantic_slam_ros
