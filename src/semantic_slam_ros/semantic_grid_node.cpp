#include "semantic_slam_ros/semantic_grid_node.h"

#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <image_transport/image_transport.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/semantic_grid/semantic_grid_file.h"
#include "semantic_slam/semantic_grid/semantic_grid_picture.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/grid_conversions.h"
#include "semantic_slam_ros/object_conversions.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;

SemanticGridNode::SemanticGridNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : SemanticGridNode(nh, private_nh, ReadParameters<SemanticGridNodeParameters>(private_nh)) {}

SemanticGridNode::SemanticGridNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                                   const SemanticGridNodeParameters& parameters)
    : builder_(parameters.grid, parameters.costs, LoadLabels(private_nh, parameters.labels)),
      grid_pub_(nh.advertise<semantic_slam::SemanticGrid>(topics::kSemanticGrid, 1, true)),
      map_pub_(nh.advertise<nav_msgs::OccupancyGrid>(topics::kSemanticMap, 1, true)),
      // Drawn for those who look only, so who begins to look must cause a drawing.
      image_pub_(image_transport::ImageTransport(nh).advertise(
          topics::kSemanticGridImage, 1,
          [this](const image_transport::SingleSubscriberPublisher&) { MarkChanged(); })),
      health_(nh, private_nh, "semantic grid", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      saver_(private_nh, topics::kSaveMap, parameters.node.output_directory,
             [this](const std::string& folder) { return Save(folder); }),
      worker_(std::make_unique<semantic_slam::Worker<Input>>(
          1, semantic_slam::WhenFull::kDropOldest, [this](const Input& input) { Process(input); })),
      timer_(nh.createWallTimer(ros::WallDuration(parameters.node.update_period_s),
                                [this](const ros::WallTimerEvent&) { HandOver(); })) {
  reset_service_ = private_nh.advertiseService(topics::kReset, &SemanticGridNode::OnReset, this);
  map_sub_ = nh.subscribe(topics::kMap, 1, &SemanticGridNode::OnMap, this);
  objects_sub_ = nh.subscribe(topics::kObjects, 1, &SemanticGridNode::OnObjects, this);
}

SemanticGridNode::~SemanticGridNode() {
  timer_.stop();
  HandOver();
  worker_.reset();
  saver_.SaveOnShutdown();
}

void SemanticGridNode::OnMap(const nav_msgs::OccupancyGridConstPtr& msg) {
  newest_.map = msg;
  MarkChanged();
}

void SemanticGridNode::OnObjects(const semantic_slam::SemanticObjectArrayConstPtr& msg) {
  newest_.objects = msg;
  MarkChanged();
}

bool SemanticGridNode::OnReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  newest_ = Input();
  MarkChanged();
  response.success = true;
  response.message = "the grid is forgotten; a new one begins with the next map or objects";
  return true;
}

void SemanticGridNode::MarkChanged() {
  if (!changed_) changed_ = Clock::now();
}

void SemanticGridNode::HandOver() {
  if (!changed_) return;
  newest_.received = *std::exchange(changed_, std::nullopt);
  worker_->Push(newest_);
}

void SemanticGridNode::Process(const Input& input) {
  auto built = std::make_shared<Snapshot>();
  if (!Read(input, *built)) return;
  built->cells = builder_.Build(built->map, built->objects);
  Publish(*built);
  {
    std::lock_guard<std::mutex> lock(mutex_);
    snapshot_ = std::move(built);
  }
  health_.AddLatency(input.received);
}

// False if a message is malformed: then the last grid stays. It is counted once per grid.
bool SemanticGridNode::Read(const Input& input, Snapshot& snapshot) {
  const char* cause = "bad_map";
  try {
    if (input.map != nullptr) {
      snapshot.map = ToOccupancyMap(*input.map);
      snapshot.frame = FrameName(input.map->header.frame_id);
    }
    cause = "bad_objects";
    if (input.objects == nullptr) return true;
    snapshot.objects = ToObjectMap(*input.objects, builder_.vocabulary());
    const std::string frame = FrameName(input.objects->header.frame_id);
    if (input.map != nullptr && frame != snapshot.frame) {
      throw InputError("objects are in frame '" + frame + "', the map is in '" + snapshot.frame +
                       "'");
    }
    snapshot.frame = frame;
    return true;
  } catch (const InputError& e) {
    drops_.Add(cause, e.what());
    return false;
  }
}

void SemanticGridNode::Publish(const Snapshot& snapshot) {
  grid_pub_.publish(ToSemanticGrid(snapshot.cells, snapshot.frame));
  map_pub_.publish(ToOccupancyGrid(snapshot.cells, snapshot.frame));
  if (image_pub_.getNumSubscribers() == 0) return;
  const cv::Mat picture = semantic_slam::DrawSemanticGrid(snapshot.cells, snapshot.map,
                                                          snapshot.objects, builder_.vocabulary());
  image_pub_.publish(ToImage(picture, "bgr8", MakeHeader(snapshot.cells.stamp, snapshot.frame)));
}

std::shared_ptr<const SemanticGridNode::Snapshot> SemanticGridNode::snapshot() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return snapshot_;
}

std::string SemanticGridNode::Save(const std::string& folder) const {
  const std::shared_ptr<const Snapshot> saved = snapshot();
  if (saved == nullptr)
    throw InputError("no map and no objects have come yet, so there is no grid");
  semantic_slam::WriteSemanticGrid(folder, saved->cells, saved->map, saved->objects,
                                   builder_.vocabulary());
  return "the semantic grid is in " + folder;
}

void SemanticGridNode::Diagnose(NodeHealth::Status& status) const {
  const std::shared_ptr<const Snapshot> shown = snapshot();
  if (shown == nullptr) {
    status.summary(DiagnosticStatus::WARN, "no map and no objects have come yet");
    return;
  }
  if (shown->map.cells.empty()) {
    status.summary(DiagnosticStatus::WARN, "there is no map yet");
  } else {
    status.summary(DiagnosticStatus::OK, "following map and objects");
  }
  status.add("grids", health_.processed());
  status.add("cells", shown->cells.cost.size());
  status.add("objects", shown->objects.objects.size());
}

}  // namespace semantic_slam_ros
