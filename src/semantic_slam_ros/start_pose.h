#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <sensor_msgs/Imu.h>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/dataset/rgbd_source.h"
#include "semantic_slam/localization/gravity_alignment.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/static_transforms.h"

namespace semantic_slam_ros {

// Finds the pose at which a map begins, see semantic_slam::FindMapStart(): gathers the imu's readings
// for it, and waits for them if there is an imu.
//
// The callback may run on another thread than the rest.
class StartPose {
 public:
  // `drops` must outlive this.
  StartPose(ros::NodeHandle nh, DropCounter& drops);

  // The map begins anew: wait for readings again.
  void Restart() { first_image_.reset(); }

  // The start if it is `image` that begins the map; nullopt as long as it is worth waiting for more
  // readings, at most half a second of images.
  std::optional<semantic_slam::MapStart> Find(const semantic_slam::RgbdImage& image,
                                              const semantic_slam::CameraModel& camera,
                                              const std::string& camera_frame,
                                              const semantic_slam::Rigid3d& T_base_camera,
                                              StaticTransforms& transforms);

 private:
  void OnImu(const sensor_msgs::ImuConstPtr& msg);
  bool IsWorthWaiting(semantic_slam::Stamp stamp) const;
  std::optional<Eigen::Vector3d> UpByImu(semantic_slam::Stamp stamp,
                                         const std::string& camera_frame,
                                         StaticTransforms& transforms) const;

  DropCounter& drops_;
  std::optional<semantic_slam::Stamp> first_image_;
  mutable std::mutex mutex_;
  std::vector<semantic_slam::AccelerometerReading> readings_;  // guarded by mutex_; the last seconds
  std::string imu_frame_;                                      // guarded by mutex_
  ros::Subscriber imu_sub_;
};

}  // namespace semantic_slam_ros
