#include "semantic_slam_ros/tum_bag.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <utility>

#include <rosbag/bag.h>
#include <rosbag/exceptions.h>
#include <sensor_msgs/image_encodings.h>
#include <tf2_msgs/TFMessage.h>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/accelerometer_file.h"
#include "semantic_slam/dataset/tum_images.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

namespace enc = sensor_msgs::image_encodings;
namespace fs = std::filesystem;
using semantic_slam::AccelerometerReading;
using semantic_slam::CameraConfig;
using semantic_slam::ImageFile;
using semantic_slam::InputError;
using semantic_slam::ProblemLog;
using semantic_slam::StampedPose;

namespace {

constexpr char kWorld[] = "world";
constexpr char kKinect[] = "kinect";
constexpr char kCamera[] = "openni_camera";
constexpr char kColourFrame[] = "openni_rgb_frame";
constexpr char kColourOptical[] = "openni_rgb_optical_frame";
constexpr char kDepthFrame[] = "openni_depth_frame";
constexpr char kDepthOptical[] = "openni_depth_optical_frame";
constexpr char kImu[] = "imu";

constexpr std::int64_t kMarginNs = 1'000'000'000;  // of poses and accelerometer, around the images

// REP-103: what is forward, left, up in the body frame is z, -x, -y in the optical one.
Rigid3d BodyFromOptical() {
  Rigid3d T_body_optical = Rigid3d::Identity();
  T_body_optical.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return T_body_optical;
}

// The motion-capture markers' frame; groundtruth.txt has their calibration in it already.
Rigid3d KinectFromCamera() {
  return Rigid3d::Identity();
}

// Where openni_launch says the two cameras of a Kinect are.
Rigid3d FromLeft(double y_m) {
  return Rigid3d(Eigen::Translation3d(0.0, y_m, 0.0));
}
Rigid3d CameraFromColour() {
  return FromLeft(-0.045);
}
Rigid3d CameraFromDepth() {
  return FromLeft(-0.02);
}

std::int64_t Nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

// One thing to write at one time. Images are read only when their turn comes.
struct Entry {
  Stamp stamp;
  enum Kind { kColour, kDepth, kPose, kAccelerometer } kind;
  std::size_t index;
};

class TumBagWriter {
 public:
  TumBagWriter(const std::string& folder, const TumBagOptions& options) : options_(options) {
    if (!fs::is_directory(folder)) throw InputError("no such folder: " + folder);
    colour_ = semantic_slam::ReadImageList(folder, "rgb.txt", problems_);
    depth_ = semantic_slam::ReadImageList(folder, "depth.txt", problems_);
    const fs::path poses = fs::path(folder) / "groundtruth.txt";
    if (fs::exists(poses)) poses_ = semantic_slam::ReadTumTrajectory(poses.string());
    const fs::path accelerometer = fs::path(folder) / "accelerometer.txt";
    if (fs::exists(accelerometer)) {
      accelerometer_ = semantic_slam::ReadAccelerometerFile(accelerometer.string());
    }
    if (colour_.empty() && depth_.empty()) throw InputError(folder + " lists no images");
    ListEntries();
    if (entries_.empty()) throw InputError(folder + " has no images in the part asked for");
  }

  void Write(rosbag::Bag& bag, const std::function<void(std::size_t, std::size_t)>& on_message) {
    for (std::size_t done = 0; done < entries_.size(); ++done) {
      WriteEntry(bag, entries_[done]);
      if (on_message) on_message(done + 1, entries_.size());
    }
    if (report_.colour == 0 && report_.depth == 0) {
      throw InputError("no image could be read; the first: " + problems_.reasons().front());
    }
  }

  TumBagReport Report() const {
    TumBagReport report = report_;
    report.dropped = problems_.count();
    report.problems = problems_.reasons();
    return report;
  }

 private:
  void ListEntries() {
    Add(colour_, Entry::kColour, 0);
    Add(depth_, Entry::kDepth, 0);
    if (entries_.empty()) return;
    Add(poses_, Entry::kPose, kMarginNs);
    Add(accelerometer_, Entry::kAccelerometer, kMarginNs);
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.stamp < b.stamp; });
  }

  // Adds the items within the part asked for, widened by a margin at both ends.
  template <typename Item>
  void Add(const std::vector<Item>& items, Entry::Kind kind, std::int64_t margin_ns) {
    const bool all = options_.start_s == 0.0 && !options_.duration_s;
    const std::int64_t begin_ns = FirstImage().ns + Nanoseconds(options_.start_s) - margin_ns;
    const std::int64_t end_ns = options_.duration_s
                                    ? begin_ns + Nanoseconds(*options_.duration_s) + 2 * margin_ns
                                    : std::numeric_limits<std::int64_t>::max();
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::int64_t ns = items[i].stamp.ns;
      if (all || (ns >= begin_ns && ns <= end_ns)) entries_.push_back({items[i].stamp, kind, i});
    }
  }

  // Precondition: there is an image.
  Stamp FirstImage() const {
    if (colour_.empty()) return depth_.front().stamp;
    if (depth_.empty()) return colour_.front().stamp;
    return std::min(colour_.front().stamp, depth_.front().stamp);
  }

  void WriteEntry(rosbag::Bag& bag, const Entry& entry) {
    switch (entry.kind) {
      case Entry::kColour:
        return WriteColour(bag, colour_[entry.index]);
      case Entry::kDepth:
        return WriteDepth(bag, depth_[entry.index]);
      case Entry::kPose:
        return WritePose(bag, poses_[entry.index]);
      case Entry::kAccelerometer:
        return WriteReading(bag, accelerometer_[entry.index]);
    }
  }

  void WriteColour(rosbag::Bag& bag, const ImageFile& file) {
    cv::Mat rgb;
    try {
      cv::cvtColor(LoadColour(file.path, options_.camera), rgb, cv::COLOR_BGR2RGB);
    } catch (const InputError& e) {
      return problems_.Add(e.what());
    }
    WriteImage(bag, "/camera/rgb/image_color", "/camera/rgb/camera_info", file.stamp, rgb,
               enc::RGB8);
    if (poses_.empty()) bag.write("/tf", ToRos(file.stamp), FixedTransforms(file.stamp));
    ++report_.colour;
  }

  void WriteDepth(rosbag::Bag& bag, const ImageFile& file) {
    cv::Mat depth_m;
    try {
      depth_m = LoadDepthMetres(file.path, options_.camera);
    } catch (const InputError& e) {
      return problems_.Add(e.what());
    }
    WriteImage(bag, "/camera/depth/image", "/camera/depth/camera_info", file.stamp, depth_m,
               enc::TYPE_32FC1);
    ++report_.depth;
  }

  // Depth is registered to colour, so both are in colour's frame and have its calibration.
  void WriteImage(rosbag::Bag& bag, const char* topic, const char* info_topic, Stamp stamp,
                  const cv::Mat& image, const std::string& encoding) {
    const std_msgs::Header header = MakeHeader(stamp, kColourOptical);
    bag.write(topic, header.stamp, *ToImage(image, encoding, header));
    bag.write(info_topic, header.stamp, ToCameraInfo(options_.camera.intrinsics, header));
  }

  void WritePose(rosbag::Bag& bag, const StampedPose& pose) {
    tf2_msgs::TFMessage msg = FixedTransforms(pose.stamp);
    const Rigid3d T_kinect_optical = KinectFromCamera() * CameraFromColour() * BodyFromOptical();
    msg.transforms.push_back(
        ToTransformStamped(pose.stamp, kWorld, kKinect, pose.pose * T_kinect_optical.inverse()));
    bag.write("/tf", ToRos(pose.stamp), msg);
    ++report_.poses;
  }

  tf2_msgs::TFMessage FixedTransforms(Stamp stamp) const {
    Rigid3d T_optical_imu = Rigid3d::Identity();
    T_optical_imu.linear() = options_.camera.R_camera_imu;
    tf2_msgs::TFMessage msg;
    const auto add = [&](const char* parent, const char* child, const Rigid3d& T_parent_child) {
      msg.transforms.push_back(ToTransformStamped(stamp, parent, child, T_parent_child));
    };
    add(kKinect, kCamera, KinectFromCamera());
    add(kCamera, kColourFrame, CameraFromColour());
    add(kColourFrame, kColourOptical, BodyFromOptical());
    add(kCamera, kDepthFrame, CameraFromDepth());
    add(kDepthFrame, kDepthOptical, BodyFromOptical());
    add(kCamera, kImu, CameraFromColour() * BodyFromOptical() * T_optical_imu);
    return msg;
  }

  void WriteReading(rosbag::Bag& bag, const AccelerometerReading& reading) {
    sensor_msgs::Imu msg;
    msg.header = MakeHeader(reading.stamp, kImu);
    msg.linear_acceleration.x = reading.acceleration_imu.x();
    msg.linear_acceleration.y = reading.acceleration_imu.y();
    msg.linear_acceleration.z = reading.acceleration_imu.z();
    msg.orientation_covariance[0] = -1.0;       // sensor_msgs/Imu: there is none
    msg.angular_velocity_covariance[0] = -1.0;  // nor this
    bag.write("/imu", msg.header.stamp, msg);
    ++report_.accelerometer;
  }

  const TumBagOptions options_;
  std::vector<ImageFile> colour_;
  std::vector<ImageFile> depth_;
  semantic_slam::Trajectory poses_;
  std::vector<AccelerometerReading> accelerometer_;
  std::vector<Entry> entries_;
  ProblemLog problems_;
  TumBagReport report_;
};

}  // namespace

CameraConfig PublishedTumCamera() {
  CameraConfig camera;
  camera.intrinsics = {640, 480, 525.0, 525.0, 319.5, 239.5, {}};
  camera.R_camera_imu = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  return camera;
}

TumBagReport WriteTumBag(const std::string& folder, const std::string& bag_path,
                         const TumBagOptions& options,
                         const std::function<void(std::size_t, std::size_t)>& on_message) {
  TumBagWriter writer(folder, options);
  semantic_slam::WriteFileAtomicallyVia(bag_path, [&](const std::string& temporary_path) {
    try {
      rosbag::Bag bag(temporary_path, rosbag::bagmode::Write);
      bag.setCompression(rosbag::compression::LZ4);
      writer.Write(bag, on_message);
      bag.close();
      return true;
    } catch (const rosbag::BagException&) {
      return false;
    }
  });
  return writer.Report();
}

}  // namespace semantic_slam_ros
