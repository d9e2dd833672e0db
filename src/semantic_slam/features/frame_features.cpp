#include "semantic_slam/features/frame_features.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <opencv2/imgproc.hpp>


namespace semantic_slam {
namespace {

cv::Mat ToGrey(const RgbdImage& image) {
  cv::Mat grey;
  cv::cvtColor(image.colour, grey,
               image.order == ColourOrder::kBgr ? cv::COLOR_BGR2GRAY : cv::COLOR_RGB2GRAY);
  return grey;
}

float DepthAt(const cv::Mat& depth_m, const Eigen::Vector2f& raw) {
  const int u = std::clamp(cvRound(raw.x()), 0, depth_m.cols - 1);
  const int v = std::clamp(cvRound(raw.y()), 0, depth_m.rows - 1);
  const float depth = depth_m.at<float>(v, u);
  return depth > 0.0f && std::isfinite(depth) ? depth : std::numeric_limits<float>::quiet_NaN();
}

std::array<std::uint8_t, 3> ColourAt(const RgbdImage& image, const Eigen::Vector2f& raw) {
  const int u = std::clamp(cvRound(raw.x()), 0, image.colour.cols - 1);
  const int v = std::clamp(cvRound(raw.y()), 0, image.colour.rows - 1);
  const auto& c = image.colour.at<cv::Vec3b>(v, u);
  if (image.order == ColourOrder::kRgb) return {c[0], c[1], c[2]};
  return {c[2], c[1], c[0]};
}

}  // namespace

FrameFeatures::FrameFeatures(const RgbdImage& image, const CameraModel& camera,
                             const OrbExtractor& extractor)
    : stamp_(image.stamp) {
  CheckRgbdImage(image, camera);
  Keypoints extracted = extractor.Extract(ToGrey(image));
  descriptors_ = std::move(extracted.descriptors);
  features_.reserve(extracted.keypoints.size());
  for (const Keypoint& keypoint : extracted.keypoints) {
    const Eigen::Vector2f pixel = camera.Undistort(keypoint.pixel);
    features_.push_back({keypoint.pixel, pixel, pixel,
                         DepthAt(image.depth_m, keypoint.pixel), keypoint.angle_rad,
                         keypoint.octave, ColourAt(image, keypoint.pixel)});
  }
  BuildGrid(camera);
}

FrameFeatures::FrameFeatures(Stamp stamp, std::vector<Feature> features,
                             std::vector<Descriptor> descriptors, const CameraModel& camera)
    : stamp_(stamp), features_(std::move(features)), descriptors_(std::move(descriptors)) {
  assert(features_.size() == descriptors_.size());
  BuildGrid(camera);
}

std::shared_ptr<const FrameFeatures> FrameFeatures::Rectified(const CameraTwist& twist,
                                                              double readout_s,
                                                              const CameraModel& camera) const {
  auto rectified = std::make_shared<FrameFeatures>(*this);
  for (Feature& feature : rectified->features_) {
    const double row_time_s = camera.RowFraction(feature.raw.y()) * readout_s;
    const Rigid3d T_middle_row = twist.T_now_then(row_time_s);
    const Eigen::Vector3d ray = camera.Unproject(feature.exposed.x(), feature.exposed.y(), 1.0);
    const Eigen::Vector3d p_middle = feature.has_depth()
                                         ? T_middle_row * (feature.depth_m * ray)
                                         : Eigen::Vector3d(T_middle_row.linear() * ray);
    if (p_middle.z() > 0.0) feature.pixel = camera.Project(p_middle).cast<float>();
  }
  rectified->BuildGrid(camera);
  return rectified;
}

void FrameFeatures::BuildGrid(const CameraModel& camera) {
  const cv::Rect2f& bounds = camera.undistorted_bounds();
  left_px_ = bounds.x;
  top_px_ = bounds.y;
  columns_ = static_cast<int>(bounds.width / kCellPx) + 1;
  rows_ = static_cast<int>(bounds.height / kCellPx) + 1;
  cell_begin_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  std::vector<int> cell_of(features_.size());
  for (std::size_t i = 0; i < features_.size(); ++i) {
    cell_of[i] = RowOf(features_[i].pixel.y()) * columns_ + ColumnOf(features_[i].pixel.x());
    ++cell_begin_[cell_of[i] + 1];
  }
  for (std::size_t c = 1; c < cell_begin_.size(); ++c) cell_begin_[c] += cell_begin_[c - 1];
  std::vector<int> next(cell_begin_.begin(), cell_begin_.end() - 1);
  entries_.resize(features_.size());
  for (std::size_t i = 0; i < features_.size(); ++i) {
    entries_[next[cell_of[i]]++] = {features_[i].pixel, features_[i].octave, static_cast<int>(i)};
  }
}

int FrameFeatures::ColumnOf(float u) const {
  return std::clamp(static_cast<int>((u - left_px_) / kCellPx), 0, columns_ - 1);
}

int FrameFeatures::RowOf(float v) const {
  return std::clamp(static_cast<int>((v - top_px_) / kCellPx), 0, rows_ - 1);
}

}  // namespace semantic_slam
