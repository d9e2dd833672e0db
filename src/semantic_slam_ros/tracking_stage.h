#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <ros/node_handle.h>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/localization/visual_localization.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/rgbd_input.h"
#include "semantic_slam_ros/start_pose.h"
#include "semantic_slam_ros/static_transforms.h"
#include "semantic_slam_ros/tracking_labels.h"

namespace semantic_slam_ros {

// One image with what tracking made of it, and where its camera sits on the robot.
struct TrackedFrame {
  semantic_slam::RgbdImage image;
  semantic_slam::TrackedImage tracked;
  std::string camera_frame;
  semantic_slam::Rigid3d T_base_camera;
};

struct TrackingMapOptions {
  std::string map_file;  // a map to begin with; empty: none
  bool mapping = true;   // false: the map stays as it is, and the camera is only localized in it

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("map_file", self.map_file);
    visit("mapping", self.mapping);
  }
};

// VisualLocalization, and what it takes to keep it going on a live stream: it is made when the
// calibration is known, starts with z up, and forgets the map when the calibration changes or the
// images begin a new timeline; without mapping a new timeline leaves the map as it is. Counts what
// it cannot use under bad_image, no_transform and waiting_for_imu, and as TrackingLabels does.
class TrackingStage {
 public:
  // Throws ConfigError if an option is out of range, or the map's file is bad. If it turns out with
  // the first image that the map was made with another camera, the process is asked to end. `drops`
  // must outlive this.
  TrackingStage(const ros::NodeHandle& nh, const semantic_slam::LocalizationOptions& options,
                const TrackingMapOptions& map_options, const TrackingLabelOptions& label_options,
                std::string base_frame, DropCounter& drops);

  // nullopt if the images could not be used; they are counted then. For one thread.
  std::optional<TrackedFrame> Process(const RgbdMessages& messages);

  // nullptr before the first image, and then the same for good. From any thread.
  std::shared_ptr<semantic_slam::VisualLocalization> localization() const;

  // See VisualLocalization::SetMapping(); before the first image it holds from that on. From any
  // thread.
  void SetMapping(bool on);
  bool is_mapping() const;

  // What told which way is up when the current map began; empty before. From any thread.
  std::string start_source() const;

 private:
  void FollowCalibration(const RgbdMessages& messages);
  void MakeLocalization();
  void FollowTimeline(int timeline);
  void BeginMap(int timeline);
  bool Start(const semantic_slam::RgbdImage& image, const std::string& camera_frame,
             const semantic_slam::Rigid3d& T_base_camera);

  const semantic_slam::LocalizationOptions options_;
  const std::string map_file_;
  const std::string base_frame_;
  DropCounter& drops_;
  StaticTransforms transforms_;
  StartPose start_pose_;
  TrackingLabels labels_;
  std::shared_ptr<const semantic_slam::CameraIntrinsics> intrinsics_;
  std::shared_ptr<const semantic_slam::CameraModel> camera_;
  int timeline_ = 0;
  bool started_ = false;
  mutable std::mutex mutex_;
  std::shared_ptr<semantic_slam::VisualLocalization> localization_;  // pointer guarded by mutex_
  bool mapping_;                                                     // guarded by mutex_
  std::string start_source_;                                         // guarded by mutex_
};

}  // namespace semantic_slam_ros
