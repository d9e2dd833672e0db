#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/dataset/image_pairer.h"
#include "semantic_slam/dataset/problem_log.h"
#include "semantic_slam/dataset/rgbd_source.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/transform_tree.h"

namespace semantic_slam_ros {

// Which topics of a bag to read: of each list the first that is there. Image topics are looked for
// raw first, then compressed (NAME/compressed, NAME/compressedDepth).
struct BagTopics {
  // The published TUM bags'; realsense2_camera's; openni_launch's.
  std::vector<std::string> colour{"/camera/rgb/image_color", "/camera/color/image_raw",
                                  "/camera/rgb/image_rect_color", "/camera/rgb/image_raw"};
  std::vector<std::string> depth{"/camera/depth/image", "/camera/aligned_depth_to_color/image_raw",
                                 "/camera/depth_registered/image_raw",
                                 "/camera/depth_registered/image_rect"};
  std::vector<std::string> camera_info{"/camera/rgb/camera_info", "/camera/color/camera_info"};
  std::vector<std::string> imu{"/imu", "/camera/imu"};
  std::string world_frame = "world";  // of the ground truth on /tf
};

// An RGB-D sequence from a bag: raw or compressed images, depth in metres or millimetres. Images
// are read as they are asked for, so memory does not grow with the bag; accelerometer and
// transforms are read at once. Malformed transforms and accelerometer readings are left out. Not
// thread-safe.
class BagSource : public semantic_slam::RgbdSource {
 public:
  // Throws InputError, in one line, if the file is missing, is no bag, was not closed properly, or
  // has no colour or depth images (naming the topics it has).
  explicit BagSource(const std::string& path, const BagTopics& topics = {},
                     const semantic_slam::ImagePairerOptions& pairing = WaitForNearest());

  std::size_t size() const override { return size_; }

  // Throws InputError if the file turns out to be damaged, its images jump back in time, or at its
  // end if no images paired up.
  std::optional<semantic_slam::RgbdImage> Next() override;

  const std::vector<std::string>& problems() const override { return problems_.reasons(); }
  std::size_t dropped() const override { return problems_.count(); }
  const std::vector<semantic_slam::AccelerometerReading>& accelerometer() const override {
    return accelerometer_;
  }
  std::optional<Eigen::Matrix3d> R_camera_imu() const override { return R_camera_imu_; }

  // The bag's own calibration. The published TUM bags carry the driver's default, which leaves out
  // the distortion. Throws InputError if there is none or it is all zeros.
  semantic_slam::CameraIntrinsics Intrinsics() const;

  // Poses T_world_camera of the colour optical frame by /tf; empty if it does not say.
  const semantic_slam::Trajectory& ground_truth() const { return ground_truth_; }

 private:
  using Pairer = semantic_slam::ImagePairer<ImageMessage>;

  // A file need not hurry: pairs are exactly those of semantic_slam::PairStamps().
  static semantic_slam::ImagePairerOptions WaitForNearest();

  void Open();
  void ChooseTopics(const BagTopics& topics);
  std::optional<std::string> FirstPresent(const std::vector<std::string>& names,
                                          const std::vector<std::string>& types) const;
  std::string RequireImages(const char* what, const std::vector<std::string>& names) const;
  TransformTree ReadTransforms() const;
  std::string ReadColourFrame() const;
  void ReadAccelerometer(const TransformTree& tree, const std::string& camera_frame);
  bool ReadPairs();
  void AddImage(const rosbag::MessageInstance& instance);
  void Keep(std::vector<Pairer::Pair> pairs);
  void CheckAnyPaired() const;
  static semantic_slam::RgbdImage Decode(const Pairer::Pair& pair);

  const std::string path_;
  rosbag::Bag bag_;
  std::map<std::string, std::string> types_;  // message type by topic
  std::string colour_topic_;
  std::string depth_topic_;
  std::optional<std::string> camera_info_topic_;
  std::optional<std::string> imu_topic_;
  std::size_t size_ = 0;
  semantic_slam::ProblemLog problems_;
  std::vector<semantic_slam::AccelerometerReading> accelerometer_;
  std::optional<Eigen::Matrix3d> R_camera_imu_;
  semantic_slam::Trajectory ground_truth_;

  Pairer pairer_;
  rosbag::View images_;
  rosbag::View::iterator next_image_;
  bool flushed_ = false;
  bool any_paired_ = false;
  std::deque<Pairer::Pair> pairs_;  // read, not yet returned
};

}  // namespace semantic_slam_ros
