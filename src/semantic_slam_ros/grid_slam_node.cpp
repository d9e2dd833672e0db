#include "semantic_slam_ros/grid_slam_node.h"

#include <algorithm>
#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/console.h>
#include <sensor_msgs/LaserScan.h>

#include "semantic_slam/camera/level_frame.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/submaps/occupancy_map_file.h"
#include "semantic_slam_ros/grid_conversions.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/scan_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::BeamStatus;
using semantic_slam::ConfigError;
using semantic_slam::InputError;
using semantic_slam::InsertOutcome;
using semantic_slam::KeyframeGraph;
using semantic_slam::OccupancyMap;
using semantic_slam::PlanarScan;
using semantic_slam::ScanBeam;
using semantic_slam::TrackedImage;

namespace {

GridSlamNodeParameters Checked(GridSlamNodeParameters parameters,
                               const ros::NodeHandle& private_nh) {
  GridSlamNodeOptions& node = parameters.node;
  const std::string name = private_nh.resolveName("map_source");
  if (node.map_source == "grid") {
    throw ConfigError(name + " = grid is not available in this version, only visual is");
  }
  if (node.map_source != "visual") {
    throw ConfigError(name + " = " + node.map_source + ", but must be visual");
  }
  try {
    semantic_slam::CheckScanBuilderOptions(parameters.grid_slam.scan);
  } catch (const ConfigError& e) {
    throw ConfigError(private_nh.resolveName("scan/") + e.what());
  }
  node.map_frame = FrameName(node.map_frame);
  node.scan_frame = FrameName(node.scan_frame);
  return parameters;
}

bool SeesNothing(const PlanarScan& scan) {
  return std::all_of(scan.beams.begin(), scan.beams.end(),
                     [](const ScanBeam& beam) { return beam.status() == BeamStatus::kUnknown; });
}

}  // namespace

GridSlamNode::GridSlamNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : GridSlamNode(nh, private_nh,
                   Checked(ReadParameters<GridSlamNodeParameters>(private_nh), private_nh)) {}

GridSlamNode::GridSlamNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                           const GridSlamNodeParameters& parameters)
    : options_(parameters.node),
      scan_options_(parameters.grid_slam.scan),
      joiner_(parameters.pose_joiner, drops_),
      throttle_(options_.min_period_s),
      mapper_(parameters.grid_slam),
      scan_pub_(nh.advertise<sensor_msgs::LaserScan>(topics::kScan, 10)),
      map_pub_(nh.advertise<nav_msgs::OccupancyGrid>(topics::kMap, 1, true)),
      metadata_pub_(nh.advertise<nav_msgs::MapMetaData>(topics::kMapMetadata, 1, true)),
      health_(nh, private_nh, "grid_slam", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      saver_(private_nh, topics::kSaveMap, options_.output_directory,
             [this](const std::string& folder) { return Save(folder); }),
      worker_(std::make_unique<StageWorker<Joiner::Joined>>(
          options_.queue_size, drops_, [this](const Joiner::Joined& joined) { Process(joined); })),
      graph_input_(std::make_unique<GraphInput>(
          nh, drops_, [this](const TrackedImage& image) { OnTracked(image); },
          [this](const KeyframeGraph& graph) { OnGraph(graph); })),
      rgbd_input_(std::make_unique<RgbdInput>(
          nh, parameters.input, parameters.pairer, drops_,
          [this](RgbdMessages messages) { OnPair(std::move(messages)); })) {
  // By the wall's clock: the map must reach who looks at it also while a simulated one stands.
  map_timer_ = nh.createWallTimer(ros::WallDuration(options_.map_period_s),
                                  [this](const ros::WallTimerEvent&) { PublishMap(); });
  reset_service_ = private_nh.advertiseService(topics::kReset, &GridSlamNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &GridSlamNode::OnPause, this);
}

GridSlamNode::~GridSlamNode() {
  map_timer_.stop();
  rgbd_input_.reset();
  graph_input_.reset();
  worker_.reset();
  saver_.SaveOnShutdown();
}

void GridSlamNode::OnPair(RgbdMessages messages) {
  if (!throttle_.IsDue(messages.stamp)) return;
  const semantic_slam::Stamp stamp = messages.stamp;
  Push(joiner_.AddPayload(stamp, std::move(messages)));
}

void GridSlamNode::OnTracked(const TrackedImage& image) {
  Push(joiner_.AddTracked(image));
}

void GridSlamNode::OnGraph(const KeyframeGraph& graph) {
  std::lock_guard<std::mutex> lock(mutex_);
  mapper_.FollowGraph(graph);
}

void GridSlamNode::Push(std::vector<Joiner::Joined> joined) {
  for (Joiner::Joined& image : joined) worker_->Push(std::move(image));
}

bool GridSlamNode::OnReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  std::lock_guard<std::mutex> lock(mutex_);
  mapper_.Reset();
  response.success = true;
  response.message = "the map is forgotten; a new one begins with the next scan";
  return true;
}

bool GridSlamNode::OnPause(std_srvs::SetBool::Request& request,
                           std_srvs::SetBool::Response& response) {
  rgbd_input_->SetPaused(request.data);
  response.success = true;
  response.message = request.data ? "paused: images are thrown away" : "mapping goes on";
  return true;
}

void GridSlamNode::Process(const Joiner::Joined& joined) try {
  const RgbdMessages& messages = joined.payload;
  FollowCalibration(messages);
  const PlanarScan scan = scan_builder_->Build(messages.Decode(), joined.image.T_map_camera);
  PublishScan(scan, joined);
  Enter(scan, joined.image);
  health_.AddLatency(messages.received);
} catch (const InputError& e) {
  drops_.Add("bad_image", e.what());
}

void GridSlamNode::FollowCalibration(const RgbdMessages& messages) {
  if (messages.intrinsics == intrinsics_) return;
  intrinsics_ = messages.intrinsics;
  const auto camera = std::make_shared<const semantic_slam::CameraModel>(*intrinsics_);
  scan_builder_ = std::make_unique<const semantic_slam::ScanBuilder>(scan_options_, camera);
}

void GridSlamNode::PublishScan(const PlanarScan& scan, const Joiner::Joined& joined) {
  if (options_.publish_tf) {
    const Rigid3d& T_map_camera = joined.image.T_map_camera;
    const Rigid3d T_camera_level = T_map_camera.inverse() * semantic_slam::LevelPose(T_map_camera);
    tf_broadcaster_.sendTransform(ToTransformStamped(scan.stamp, joined.payload.frame_id,
                                                     options_.scan_frame, T_camera_level));
  }
  if (scan_pub_.getNumSubscribers() == 0) return;
  scan_pub_.publish(ToLaserScan(scan, scan_options_.min_range_m, options_.scan_frame));
}

void GridSlamNode::Enter(const PlanarScan& scan, const TrackedImage& image) {
  if (SeesNothing(scan)) {
    drops_.AddQuietly("nothing_seen");
    return;
  }
  InsertOutcome outcome;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    outcome = mapper_.Insert(scan, image);
    entered_ += outcome == InsertOutcome::kInserted;
  }
  if (outcome == InsertOutcome::kInserted || outcome == InsertOutcome::kNotMoved) return;
  drops_.AddQuietly(ToString(outcome));
}

void GridSlamNode::PublishMap() {
  OccupancyMap map;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (mapper_.changes() == published_) return;
    published_ = mapper_.changes();
    map = mapper_.Render();
  }
  const nav_msgs::OccupancyGrid msg = ToOccupancyGrid(map, options_.map_frame);
  map_pub_.publish(msg);
  metadata_pub_.publish(msg.info);
}

std::string GridSlamNode::Save(const std::string& folder) {
  OccupancyMap map;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    map = mapper_.Render();
  }
  semantic_slam::WriteOccupancyMap(folder, map);
  return "the map is in " + folder;
}

void GridSlamNode::Diagnose(NodeHealth::Status& status) {
  std::int64_t entered = 0;
  std::size_t submaps = 0;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    entered = entered_;
    submaps = mapper_.submaps();
  }
  const std::int64_t scans = health_.processed();
  if (scans == 0) {
    status.summary(DiagnosticStatus::WARN, "no scan yet");
  } else if (entered == 0) {
    status.summary(DiagnosticStatus::WARN, "no scan has shown anything in the band of heights yet");
  } else {
    status.summary(DiagnosticStatus::OK, "mapping");
  }
  status.add("scans", scans);
  status.add("scans entered", entered);
  status.add("submaps", submaps);
}

}  // namespace semantic_slam_ros
