#include "semantic_slam/tracking/semantic_mask.h"

#include <cmath>
#include <iterator>

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

// Label images that may wait for theirs to be tracked.
constexpr std::size_t kMaxMasks = 4;
// So far away are features without depth taken to be [m]: where that is wrong, the turn of the
// camera still is taken into account.
constexpr double kUnknownDepthM = 3.0;

cv::Mat MaskOf(const LabelImage& image, int margin_px) {
  cv::Mat table(1, 256, CV_8UC1, cv::Scalar::all(0));
  for (const LabelId label : image.left_out) table.at<std::uint8_t>(label) = 255;
  cv::Mat mask;
  cv::LUT(image.labels, table, mask);
  if (margin_px == 0) return mask;
  const int side_px = 2 * margin_px + 1;
  cv::dilate(mask, mask, cv::getStructuringElement(cv::MORPH_RECT, cv::Size(side_px, side_px)));
  return mask;
}

bool IsSet(const cv::Mat& mask, const Eigen::Vector2d& raw) {
  const double u = std::round(raw.x()), v = std::round(raw.y());
  if (!(u >= 0.0 && v >= 0.0 && u < mask.cols && v < mask.rows)) return false;
  return mask.at<std::uint8_t>(static_cast<int>(v), static_cast<int>(u)) != 0;
}

}  // namespace

SemanticMask::SemanticMask(const SemanticMaskOptions& options) : options_(Validated(options)) {}

void SemanticMask::Reset() {
  masks_.clear();
  T_odom_cameras_.clear();
}

LabelImageFate SemanticMask::Add(const LabelImage& image, const CameraModel& camera) {
  if (!camera.Contains(image.labels) || image.labels.type() != CV_8UC1) {
    return LabelImageFate::kBadSize;
  }
  if (!masks_.empty() && !(masks_.rbegin()->first < image.stamp))
    return LabelImageFate::kOutOfOrder;
  if (!T_odom_cameras_.empty()) {
    const Stamp newest = T_odom_cameras_.rbegin()->first;
    if (SecondsBetween(image.stamp, newest) > options_.max_age_s) return LabelImageFate::kLate;
    if (image.stamp <= newest && T_odom_cameras_.count(image.stamp) == 0) {
      return LabelImageFate::kNotTracked;
    }
  }
  masks_.emplace(image.stamp, MaskOf(image, options_.margin_px));
  if (masks_.size() > kMaxMasks) masks_.erase(masks_.begin());
  return LabelImageFate::kUsed;
}

void SemanticMask::AddPose(Stamp stamp, const Rigid3d& T_odom_camera) {
  T_odom_cameras_.emplace(stamp, T_odom_camera);
  while (SecondsBetween(T_odom_cameras_.begin()->first, stamp) > options_.max_age_s) {
    T_odom_cameras_.erase(T_odom_cameras_.begin());
  }
}

// The newest labels that can be laid on the image at `stamp`; nullptr if there are none.
const cv::Mat* SemanticMask::NewestUntil(Stamp stamp, const Rigid3d& T_odom_now,
                                         Rigid3d& T_mask_now) const {
  for (auto mask = masks_.rbegin(); mask != masks_.rend(); ++mask) {
    if (stamp < mask->first) continue;
    if (SecondsBetween(mask->first, stamp) > options_.max_age_s) break;
    const auto pose = T_odom_cameras_.find(mask->first);
    if (mask->first == stamp) {
      T_mask_now = Rigid3d::Identity();
    } else if (pose != T_odom_cameras_.end()) {
      T_mask_now = pose->second.inverse() * T_odom_now;
    } else {
      continue;
    }
    return &mask->second;
  }
  return nullptr;
}

std::vector<bool> SemanticMask::Find(const FrameFeatures& features, const Rigid3d& T_odom_camera,
                                     const CameraModel& camera) const {
  std::vector<bool> found(features.size(), false);
  Rigid3d T_mask_now;
  const cv::Mat* mask = NewestUntil(features.stamp(), T_odom_camera, T_mask_now);
  if (mask == nullptr) return found;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Feature& feature = features[i];
    const Eigen::Vector3d p =
        T_mask_now * camera.Unproject(feature.exposed.x(), feature.exposed.y(),
                                      feature.has_depth() ? feature.depth_m : kUnknownDepthM);
    found[i] = p.z() > 0.0 && IsSet(*mask, camera.ProjectRaw(p));
  }
  return found;
}

}  // namespace semantic_slam
