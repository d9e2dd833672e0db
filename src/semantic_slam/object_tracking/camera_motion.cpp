#include "semantic_slam/object_tracking/camera_motion.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "semantic_slam/common/options.h"

namespace semantic_slam {
namespace {

// A camera that comes twice as near within one image is none that we know.
constexpr double kMaxZoom = 2.0;

ImageMotion NoMotion() {
  return ImageMotion::Identity();
}

cv::Mat HalfSizeGrey(const cv::Mat& image) {
  cv::Mat half;
  cv::resize(image, half, image.size() / 2, 0.0, 0.0, cv::INTER_AREA);
  if (half.channels() == 3) cv::cvtColor(half, half, cv::COLOR_BGR2GRAY);
  return half;
}

// Of the affine motion [s R | t] at half size; as one of the full image.
ImageMotion AtFullSize(const cv::Mat& affine) {
  ImageMotion motion;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      motion(row, column) = affine.at<double>(row, column) * (column == 2 ? 2.0 : 1.0);
    }
  }
  return motion;
}

bool IsPlausible(const ImageMotion& motion) {
  const double zoom = motion.col(0).norm();
  return motion.allFinite() && zoom < kMaxZoom && zoom > 1.0 / kMaxZoom;
}

}  // namespace

CameraMotion::CameraMotion(const CameraMotionOptions& options) : options_(Validated(options)) {}

ImageMotion CameraMotion::Update(const cv::Mat& image) {
  if (image.rows < 2 || image.cols < 2) {
    last_half_.release();
    return NoMotion();
  }
  const cv::Mat half = HalfSizeGrey(image);
  const ImageMotion motion = half.size() == last_half_.size() ? MotionTo(half) : NoMotion();
  last_half_ = half;
  cv::goodFeaturesToTrack(half, last_corners_, options_.max_corners, options_.corner_quality,
                          options_.min_distance_px, cv::noArray(), options_.block_size_px);
  return motion;
}

ImageMotion CameraMotion::MotionTo(const cv::Mat& half) const {
  if (last_corners_.empty()) return NoMotion();
  std::vector<cv::Point2f> corners, from, to;
  std::vector<unsigned char> found;
  cv::calcOpticalFlowPyrLK(last_half_, half, last_corners_, corners, found, cv::noArray());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    from.push_back(last_corners_[i]);
    to.push_back(corners[i]);
  }
  if (static_cast<int>(from.size()) < options_.min_inliers) return NoMotion();
  cv::Mat inliers;
  const cv::Mat affine = cv::estimateAffinePartial2D(from, to, inliers, cv::RANSAC);
  if (affine.empty() || cv::countNonZero(inliers) < options_.min_inliers) return NoMotion();
  const ImageMotion motion = AtFullSize(affine);
  return IsPlausible(motion) ? motion : NoMotion();
}

}  // namespace semantic_slam
