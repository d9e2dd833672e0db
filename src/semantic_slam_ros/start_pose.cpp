#include "semantic_slam_ros/start_pose.h"

#include <algorithm>

#include "semantic_slam/common/error.h"
#include "semantic_slam/localization/gravity_alignment.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::AccelerometerReading;
using semantic_slam::SecondsBetween;

namespace {

constexpr int kQueueSize = 200;     // an imu sends in bursts
constexpr double kWindowS = 0.5;    // readings that count, before the image
constexpr double kRememberS = 2.0;  // images arrive later than readings of the same moment
constexpr double kEnough = 0.8;     // share of the window that must be covered to go ahead

// The base stands at the map's origin, turned so that `up_camera` is z and the camera looks along x.
Rigid3d UprightStart(const Eigen::Vector3d& up_camera, const Rigid3d& T_base_camera) {
  Rigid3d T_map_base = Rigid3d::Identity();
  T_map_base.linear() = semantic_slam::StartPoseFromUp(up_camera).linear() *
                        T_base_camera.linear().transpose();
  return T_map_base * T_base_camera;
}

}  // namespace

StartPose::StartPose(ros::NodeHandle nh, DropCounter& drops)
    : drops_(drops),
      imu_sub_(nh.subscribe(topics::kImu, kQueueSize, &StartPose::OnImu, this)) {}

void StartPose::OnImu(const sensor_msgs::ImuConstPtr& msg) try {
  const AccelerometerReading reading = ToAccelerometerReading(*msg);
  std::lock_guard<std::mutex> lock(mutex_);
  imu_frame_ = FrameName(msg->header.frame_id);
  // Stamps that go back mean another recording: what was read before belongs to the old one.
  if (!readings_.empty() && reading.stamp < readings_.back().stamp) readings_.clear();
  const auto is_old = [&reading](const AccelerometerReading& r) {
    return SecondsBetween(r.stamp, reading.stamp) > kRememberS;
  };
  readings_.erase(readings_.begin(),
                  std::find_if_not(readings_.begin(), readings_.end(), is_old));
  readings_.push_back(reading);
} catch (const semantic_slam::InputError& e) {
  drops_.Add("bad_imu", e.what());
}

bool StartPose::IsWorthWaiting(Stamp stamp) const {
  if (imu_sub_.getNumPublishers() == 0) return false;
  if (SecondsBetween(*first_image_, stamp) >= kWindowS) return false;
  std::lock_guard<std::mutex> lock(mutex_);
  return readings_.empty() || SecondsBetween(readings_.front().stamp, stamp) < kEnough * kWindowS;
}

std::optional<StartPose::Found> StartPose::Find(Stamp stamp, const std::string& camera_frame,
                                                const Rigid3d& T_base_camera,
                                                StaticTransforms& transforms) {
  if (!first_image_) first_image_ = stamp;
  if (IsWorthWaiting(stamp)) return std::nullopt;
  std::vector<AccelerometerReading> readings;
  std::string imu_frame;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    readings = readings_;
    imu_frame = imu_frame_;
  }
  const std::string level = "the base is taken to stand level, ";
  if (readings.empty()) return Found{T_base_camera, level + "there is no imu"};
  const auto up_imu = semantic_slam::MeanAcceleration(readings, stamp, kWindowS);
  if (!up_imu) return Found{T_base_camera, level + "the imu does not read gravity"};
  const auto T_camera_imu = transforms.Find(camera_frame, imu_frame);
  if (!T_camera_imu) {
    return Found{T_base_camera, level + "tf does not know the imu's frame '" + imu_frame + "'"};
  }
  return Found{UprightStart(T_camera_imu->linear() * *up_imu, T_base_camera), "up from the imu"};
}

}  // namespace semantic_slam_ros
