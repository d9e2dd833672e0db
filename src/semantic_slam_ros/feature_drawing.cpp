#include "semantic_slam_ros/feature_drawing.h"

#include <algorithm>
#include <string>

#include <opencv2/imgproc.hpp>

namespace semantic_slam_ros {

using semantic_slam::FeatureView;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;

namespace {

constexpr int kBannerHeightPx = 24;
constexpr double kFontScale = 0.5;

// Red, green, blue as the image's order wants them.
cv::Scalar Colour(semantic_slam::ColourOrder order, int red, int green, int blue) {
  return order == semantic_slam::ColourOrder::kRgb ? cv::Scalar(red, green, blue)
                                                   : cv::Scalar(blue, green, red);
}

void DrawFeature(cv::Mat& pixels, const FeatureView& feature, const cv::Scalar& colour) {
  const cv::Point centre(cvRound(feature.pixel.x()), cvRound(feature.pixel.y()));
  if (feature.is_left_out) {
    cv::drawMarker(pixels, centre, colour, cv::MARKER_TILTED_CROSS, 7, 1, cv::LINE_AA);
    return;
  }
  if (!feature.is_inlier) {
    cv::circle(pixels, centre, 1, colour, cv::FILLED);
    return;
  }
  // A fifth of the patch: as large as it must be to tell the pyramid's levels apart.
  const int half = std::max(2, cvRound(feature.size_px / 10.0f));
  cv::rectangle(pixels, centre - cv::Point(half, half), centre + cv::Point(half, half), colour, 1,
                cv::LINE_AA);
  cv::circle(pixels, centre, 1, colour, cv::FILLED);
}

std::string StatusLine(const TrackedImage& image, std::size_t features) {
  std::string line = std::string(ToString(image.status)) + "   map " +
                     std::to_string(image.map_id) + "   " + std::to_string(features) + " features";
  if (image.status == TrackingStatus::kTracking) {
    line += "   " + std::to_string(image.inliers) + " inliers   keyframe " +
            std::to_string(image.keyframe_id);
  }
  return line;
}

}  // namespace

ColourImage DrawFeatures(const ColourImage& colour, const std::vector<FeatureView>& features,
                         const TrackedImage& image) {
  ColourImage drawing{{}, colour.order};
  cv::copyMakeBorder(colour.pixels, drawing.pixels, 0, kBannerHeightPx, 0, 0, cv::BORDER_CONSTANT,
                     Colour(colour.order, 24, 24, 28));
  const cv::Scalar green = Colour(colour.order, 60, 220, 90);
  const cv::Scalar grey = Colour(colour.order, 160, 160, 160);
  const cv::Scalar orange = Colour(colour.order, 250, 150, 40);
  const cv::Scalar red = Colour(colour.order, 240, 80, 70);
  cv::Mat picture = drawing.pixels.rowRange(0, colour.pixels.rows);
  // Inliers last, on top.
  for (const bool is_inlier : {false, true}) {
    for (const FeatureView& feature : features) {
      if (feature.is_inlier != is_inlier) continue;
      DrawFeature(picture, feature, feature.is_left_out ? orange : is_inlier ? green : grey);
    }
  }
  const bool is_tracking = image.status == TrackingStatus::kTracking;
  cv::putText(drawing.pixels, StatusLine(image, features.size()),
              {8, colour.pixels.rows + kBannerHeightPx - 8}, cv::FONT_HERSHEY_SIMPLEX, kFontScale,
              is_tracking ? green : red, 1, cv::LINE_AA);
  return drawing;
}

}  // namespace semantic_slam_ros
