#include "semantic_slam/dnn/label_drawing.h"

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontScale = 0.42;
constexpr int kMarginPx = 4;
constexpr int kBaseLinePx = 5;  // above the tag's lower edge

}  // namespace

cv::Scalar ColourOf(const LabelClass& label, ColourOrder order) {
  const auto [red, green, blue] = label.rgb;
  return order == ColourOrder::kRgb ? cv::Scalar(red, green, blue) : cv::Scalar(blue, green, red);
}

int TagWidthPx(const std::string& text) {
  int base_line = 0;
  return cv::getTextSize(text, kFont, kFontScale, 1, &base_line).width + 2 * kMarginPx;
}

void DrawTag(cv::Mat& picture, cv::Point corner, const std::string& text,
             const cv::Scalar& colour) {
  const cv::Rect tag(corner, cv::Size(TagWidthPx(text), kTagHeightPx));
  cv::rectangle(picture, tag, colour, cv::FILLED);
  // Green counts double, as it does to the eye; it is the middle channel in either order.
  const double brightness = (colour[0] + 2.0 * colour[1] + colour[2]) / 4.0;
  const cv::Scalar ink = cv::Scalar::all(brightness > 128.0 ? 0 : 255);
  cv::putText(picture, text, {tag.x + kMarginPx, tag.y + kTagHeightPx - kBaseLinePx}, kFont,
              kFontScale, ink, 1, cv::LINE_AA);
}

}  // namespace semantic_slam
