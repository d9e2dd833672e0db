#include "semantic_slam/features/orb_extractor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/features/quadtree.h"

namespace semantic_slam {
namespace {

constexpr int kPatchSizePx = 31;
constexpr int kHalfPatchPx = kPatchSizePx / 2;
// Room for the rotated patch and for the blur before it is described.
constexpr int kBorderPx = 19;
static_assert(sizeof(Descriptor) == 32, "cv::ORB writes 32 bytes per descriptor");

// Half the width of the round patch on each row from its middle.
std::array<int, kHalfPatchPx + 1> CircleHalfWidths() {
  std::array<int, kHalfPatchPx + 1> half_width;
  for (int dv = 0; dv <= kHalfPatchPx; ++dv) {
    half_width[dv] =
        static_cast<int>(std::sqrt(kHalfPatchPx * kHalfPatchPx + 0.5 - static_cast<double>(dv * dv)));
  }
  return half_width;
}

// Direction from the patch's centre to its intensity centroid [deg, 0..360), ORB paper eq. (1)-(3).
float CentroidAngleDeg(const cv::Mat& image, const cv::Point2f& centre) {
  static const auto kHalfWidth = CircleHalfWidths();
  const int cu = cvRound(centre.x), cv = cvRound(centre.y);
  int m10 = 0, m01 = 0;
  for (int dv = -kHalfPatchPx; dv <= kHalfPatchPx; ++dv) {
    const std::uint8_t* row = image.ptr<std::uint8_t>(cv + dv) + cu;
    const int half = kHalfWidth[std::abs(dv)];
    int row_sum = 0;
    for (int du = -half; du <= half; ++du) {
      m10 += du * row[du];
      row_sum += row[du];
    }
    m01 += dv * row_sum;
  }
  return cv::fastAtan2(static_cast<float>(m01), static_cast<float>(m10));
}

// In every cell keeps the corners above `threshold`, or all of them if none is.
std::vector<cv::KeyPoint> KeepStrongPerCell(const std::vector<cv::KeyPoint>& corners, cv::Size size,
                                            int cell_size, float threshold) {
  const int columns = (size.width + cell_size - 1) / cell_size;
  const int rows = (size.height + cell_size - 1) / cell_size;
  const auto cell_of = [&](const cv::KeyPoint& corner) {
    return static_cast<int>(corner.pt.y) / cell_size * columns +
           static_cast<int>(corner.pt.x) / cell_size;
  };
  std::vector<bool> has_strong(static_cast<std::size_t>(columns) * rows, false);
  for (const auto& corner : corners) {
    if (corner.response >= threshold) has_strong[cell_of(corner)] = true;
  }
  std::vector<cv::KeyPoint> kept;
  kept.reserve(corners.size());
  for (const auto& corner : corners) {
    if (corner.response >= threshold || !has_strong[cell_of(corner)]) kept.push_back(corner);
  }
  return kept;
}

std::vector<int> FeaturesPerLevel(const OrbExtractorOptions& options) {
  const double ratio = 1.0 / options.pyramid_scale;
  double share = options.max_features * (1.0 - ratio) / (1.0 - std::pow(ratio, options.pyramid_levels));
  std::vector<int> per_level;
  int left = options.max_features;
  for (int level = 0; level + 1 < options.pyramid_levels; ++level, share *= ratio) {
    per_level.push_back(std::min(left, static_cast<int>(std::lround(share))));
    left -= per_level.back();
  }
  per_level.push_back(left);
  return per_level;
}

void DescribeLevel(const cv::Mat& level, int octave, float scale,
                   std::vector<cv::KeyPoint>& corners, Keypoints& out) {
  if (corners.empty()) return;
  // One level only: the pyramid is ours. cv::ORB blurs, turns the tests and evaluates them.
  const auto orb = cv::ORB::create(static_cast<int>(corners.size()), 1.2f, 1, kBorderPx - 3, 0, 2,
                                   cv::ORB::FAST_SCORE, kPatchSizePx);
  cv::Mat descriptors;
  orb->compute(level, corners, descriptors);
  for (int i = 0; i < descriptors.rows; ++i) {
    const cv::KeyPoint& corner = corners[i];
    out.keypoints.push_back({Eigen::Vector2f(corner.pt.x, corner.pt.y) * scale,
                             corner.angle * static_cast<float>(CV_PI / 180.0), corner.response,
                             octave});
    std::memcpy(out.descriptors.emplace_back().data(), descriptors.ptr(i), sizeof(Descriptor));
  }
}

}  // namespace

std::vector<float> PyramidScales(const OrbExtractorOptions& options) {
  std::vector<float> scales;
  for (int level = 0; level < options.pyramid_levels; ++level) {
    scales.push_back(static_cast<float>(std::pow(options.pyramid_scale, level)));
  }
  return scales;
}

OrbExtractor::OrbExtractor(const OrbExtractorOptions& options)
    : options_(Validated(options)), scales_(PyramidScales(options_)) {
  features_per_level_ = FeaturesPerLevel(options_);
}

Keypoints OrbExtractor::Extract(const cv::Mat& grey) const {
  CV_Assert(grey.type() == CV_8UC1);
  Keypoints result;
  cv::Mat level = grey;
  for (int octave = 0; octave < options_.pyramid_levels; ++octave) {
    if (octave > 0) {
      const cv::Size size(cvRound(grey.cols / scales_[octave]), cvRound(grey.rows / scales_[octave]));
      cv::Mat smaller;
      cv::resize(level, smaller, size, 0.0, 0.0, cv::INTER_LINEAR);
      level = smaller;
    }
    if (std::min(level.cols, level.rows) <= 2 * kBorderPx + kPatchSizePx) break;
    auto corners = DetectOnLevel(level, features_per_level_[octave]);
    DescribeLevel(level, octave, scales_[octave], corners, result);
  }
  return result;
}

std::vector<cv::KeyPoint> OrbExtractor::DetectOnLevel(const cv::Mat& level, int wanted) const {
  const int margin = kBorderPx - 3;  // FAST itself leaves 3 px at its image's border
  const cv::Mat inner = level(cv::Rect(margin, margin, level.cols - 2 * margin, level.rows - 2 * margin));
  std::vector<cv::KeyPoint> corners;
  cv::FAST(inner, corners, options_.min_fast_threshold, true);
  corners = KeepStrongPerCell(corners, inner.size(), options_.cell_size_px,
                              static_cast<float>(options_.fast_threshold));
  corners = SpreadByQuadtree(corners, inner.size(), wanted);
  for (auto& corner : corners) {
    corner.pt += cv::Point2f(static_cast<float>(margin), static_cast<float>(margin));
    corner.angle = CentroidAngleDeg(level, corner.pt);
    corner.octave = 0;
    corner.size = kPatchSizePx;
  }
  return corners;
}

}  // namespace semantic_slam
