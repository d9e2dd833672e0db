#include "semantic_slam_ros/start_pose.h"

#include <algorithm>

#include <ros/console.h>

#include "semantic_slam/common/error.h"
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

std::optional<semantic_slam::MapStart> StartPose::Find(const semantic_slam::RgbdImage& image,
                                                       const semantic_slam::CameraModel& camera,
                                                       const std::string& camera_frame,
                                                       const Rigid3d& T_base_camera,
                                                       StaticTransforms& transforms) {
  if (!first_image_) first_image_ = image.stamp;
  if (IsWorthWaiting(image.stamp)) return std::nullopt;
  return semantic_slam::FindMapStart(UpByImu(image.stamp, camera_frame, transforms), image, camera,
                                     T_base_camera);
}

std::optional<Eigen::Vector3d> StartPose::UpByImu(Stamp stamp, const std::string& camera_frame,
                                                  StaticTransforms& transforms) const {
  std::vector<AccelerometerReading> readings;
  std::string imu_frame;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    readings = readings_;
    imu_frame = imu_frame_;
  }
  if (readings.empty()) return std::nullopt;
  const auto up_imu = semantic_slam::MeanAcceleration(readings, stamp, kWindowS);
  if (!up_imu) {
    ROS_WARN("the imu does not read gravity, so it cannot tell which way is up");
    return std::nullopt;
  }
  const auto T_camera_imu = transforms.Find(camera_frame, imu_frame);
  if (!T_camera_imu) return std::nullopt;
  return T_camera_imu->linear() * *up_imu;
}

}  // namespace semantic_slam_ros
