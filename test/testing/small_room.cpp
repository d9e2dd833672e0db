#include "testing/small_room.h"

#include <random>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "testing/textured_room.h"

namespace semantic_slam {
namespace {

constexpr float kFlatDepthM = 2.0f;

const TexturedRoom& Room() {
  static const TexturedRoom kRoom([] {
    TexturedRoomOptions options;
    options.intrinsics = SmallIntrinsics();
    options.noise = false;
    return options;
  }());
  return kRoom;
}

RgbdImage FlatImage(const cv::Mat& grey, Stamp stamp) {
  RgbdImage image;
  image.stamp = image.depth_stamp = stamp;
  cv::cvtColor(grey, image.colour, cv::COLOR_GRAY2BGR);
  image.depth_m = cv::Mat(grey.size(), CV_32FC1, cv::Scalar::all(kFlatDepthM));
  return image;
}

std::shared_ptr<const FrameFeatures> FeaturesOf(const RgbdImage& image) {
  return std::make_shared<const FrameFeatures>(image, *SmallCamera(), SmallExtractor());
}

Eigen::Vector3d RandomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

}  // namespace

CameraIntrinsics SmallIntrinsics() {
  return {320, 240, 260.0, 260.0, 159.5, 119.5, {}};
}

std::shared_ptr<const CameraModel> SmallCamera() {
  static const auto kCamera = std::make_shared<const CameraModel>(SmallIntrinsics());
  return kCamera;
}

const OrbExtractor& SmallExtractor() {
  static const OrbExtractor kExtractor([] {
    OrbExtractorOptions options;
    options.max_features = 500;
    return options;
  }());
  return kExtractor;
}

RgbdImage SmallRoomImage(const Rigid3d& T_world_camera, Stamp stamp) {
  return Room().Render(T_world_camera, stamp);
}

std::shared_ptr<const FrameFeatures> SmallRoomFeatures(const Rigid3d& T_world_camera, Stamp stamp) {
  return FeaturesOf(SmallRoomImage(T_world_camera, stamp));
}

RgbdImage SquaresImage(std::uint32_t seed) {
  constexpr int kSidePx = 8;
  const CameraIntrinsics c = SmallIntrinsics();
  cv::Mat grey(c.height_px, c.width_px, CV_8UC1);
  std::mt19937 random(seed);
  for (int v = 0; v < grey.rows; v += kSidePx) {
    for (int u = 0; u < grey.cols; u += kSidePx) {
      grey(cv::Rect(u, v, kSidePx, kSidePx)) = static_cast<double>(random() % 256);
    }
  }
  // FAST wants one strongest pixel per corner; the ideal corner of a square has several.
  cv::GaussianBlur(grey, grey, cv::Size(3, 3), 0.8);
  return FlatImage(grey, Stamp{1'000'000'000 + static_cast<std::int64_t>(seed)});
}

std::shared_ptr<const FrameFeatures> SquaresFeatures(std::uint32_t seed) {
  return FeaturesOf(SquaresImage(seed));
}

RgbdImage BlankImage(Stamp stamp) {
  const CameraIntrinsics c = SmallIntrinsics();
  return FlatImage(cv::Mat(c.height_px, c.width_px, CV_8UC1, cv::Scalar::all(128)), stamp);
}

KeyframeId AddKeyframeWithPoints(Map& map, std::shared_ptr<const FrameFeatures> features,
                                 const Rigid3d& T_map_camera) {
  const FrameFeatures& frame = *features;
  const KeyframeId id = map.AddKeyframe(std::move(features), T_map_camera).id;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Feature& feature = frame[i];
    if (!feature.has_depth()) continue;
    const Eigen::Vector3d p_camera =
        SmallCamera()->Unproject(feature.pixel.x(), feature.pixel.y(), feature.depth_m);
    map.AddPoint(T_map_camera * p_camera, id, static_cast<int>(i));
  }
  map.UpdateCovisibility(id);
  return id;
}

double DistanceBetween(const Rigid3d& a, const Rigid3d& b) {
  return (a.translation() - b.translation()).norm();
}

double AngleBetween(const Rigid3d& a, const Rigid3d& b) {
  return RotationAngle(a.linear().transpose() * b.linear());
}

Rigid3d Nudged(const Rigid3d& T, double distance_m, double angle_rad, std::uint32_t seed) {
  std::mt19937 random(seed);
  Rigid3d nudged = T;
  nudged.translation() += distance_m * RandomDirection(random);
  nudged.linear() = T.linear() * ExpSo3(angle_rad * RandomDirection(random));
  return nudged;
}

}  // namespace semantic_slam
