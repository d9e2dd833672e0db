#include "semantic_slam_ros/tracking_stage.h"

#include <utility>

#include <ros/console.h>
#include <ros/init.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/map/map_file.h"

namespace semantic_slam_ros {

using semantic_slam::CameraModel;
using semantic_slam::InputError;
using semantic_slam::RgbdImage;
using semantic_slam::VisualLocalization;

namespace {

// `path` if it is empty or names a sound map. So a bad file is told at start, not with the first
// image.
const std::string& CheckedMapFile(const std::string& path) {
  try {
    if (!path.empty()) semantic_slam::ReadMapFile(path);
  } catch (const InputError& e) {
    throw semantic_slam::ConfigError(std::string("map_file: ") + e.what());
  }
  return path;
}

}  // namespace

TrackingStage::TrackingStage(const ros::NodeHandle& nh,
                             const semantic_slam::LocalizationOptions& options,
                             const TrackingMapOptions& map_options,
                             const TrackingLabelOptions& label_options, std::string base_frame,
                             DropCounter& drops)
    : options_(options),
      map_file_(CheckedMapFile(map_options.map_file)),
      base_frame_(std::move(base_frame)),
      drops_(drops),
      transforms_(nh),
      start_pose_(nh, drops),
      labels_(nh, label_options, drops),
      mapping_(map_options.mapping) {}

std::optional<TrackedFrame> TrackingStage::Process(const RgbdMessages& messages) try {
  RgbdImage image = messages.Decode();
  const auto T_base_camera = transforms_.Find(base_frame_, messages.frame_id);
  if (!T_base_camera) {
    drops_.AddQuietly("no_transform");
    return std::nullopt;
  }
  FollowCalibration(messages);
  FollowTimeline(messages.timeline);
  if (!started_ && !Start(image, messages.frame_id, *T_base_camera)) {
    drops_.AddQuietly("waiting_for_imu");
    return std::nullopt;
  }
  labels_.HandTo(*localization_);
  const semantic_slam::TrackedImage tracked = localization_->Track(image);
  return TrackedFrame{std::move(image), tracked, messages.frame_id, *T_base_camera};
} catch (const InputError& e) {
  drops_.Add("bad_image", e.what());
  return std::nullopt;
}

std::shared_ptr<VisualLocalization> TrackingStage::localization() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return localization_;
}

void TrackingStage::SetMapping(bool on) {
  std::shared_ptr<VisualLocalization> localization;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    mapping_ = on;
    localization = localization_;
  }
  if (localization != nullptr) localization->SetMapping(on);
}

bool TrackingStage::is_mapping() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return mapping_;
}

std::string TrackingStage::start_source() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return start_source_;
}

void TrackingStage::FollowCalibration(const RgbdMessages& messages) {
  if (messages.intrinsics == intrinsics_) return;
  if (intrinsics_ != nullptr) ROS_WARN("the calibration changed: the map is forgotten");
  intrinsics_ = messages.intrinsics;
  ROS_INFO("camera %s: %d x %d px, fx %.2f fy %.2f cx %.2f cy %.2f, %zu distortion coefficients",
           messages.frame_id.c_str(), intrinsics_->width_px, intrinsics_->height_px,
           intrinsics_->fx_px, intrinsics_->fy_px, intrinsics_->cx_px, intrinsics_->cy_px,
           intrinsics_->distortion.size());
  camera_ = std::make_shared<const CameraModel>(*intrinsics_);
  BeginMap(messages.timeline);
  if (localization_ != nullptr) {
    localization_->Reset(camera_);
  } else {
    MakeLocalization();
  }
}

void TrackingStage::MakeLocalization() {
  auto localization = std::make_shared<VisualLocalization>(options_, camera_,
                                                           semantic_slam::MappingMode::kThreaded);
  try {
    if (!map_file_.empty()) localization->LoadMap(map_file_);
  } catch (const InputError& e) {
    ROS_FATAL("map_file: %s", e.what());
    ros::requestShutdown();
  }
  std::lock_guard<std::mutex> lock(mutex_);
  localization->SetMapping(mapping_);
  localization_ = std::move(localization);
}

void TrackingStage::FollowTimeline(int timeline) {
  if (timeline == timeline_) return;
  BeginMap(timeline);
  if (is_mapping()) {
    localization_->Reset();
  } else {
    localization_->Restart();
  }
}

void TrackingStage::BeginMap(int timeline) {
  timeline_ = timeline;
  started_ = false;
  start_pose_.Restart();
}

bool TrackingStage::Start(const RgbdImage& image, const std::string& camera_frame,
                          const Rigid3d& T_base_camera) {
  const auto start = start_pose_.Find(image, *camera_, camera_frame, T_base_camera, transforms_);
  if (!start) return false;
  localization_->SetStart(start->T_map_camera);
  ROS_INFO("upright at %s s: %s", ToString(image.stamp).c_str(), start->source.c_str());
  started_ = true;
  std::lock_guard<std::mutex> lock(mutex_);
  start_source_ = start->source;
  return true;
}

}  // namespace semantic_slam_ros
