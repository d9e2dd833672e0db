#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/worlds/painter.h"

namespace semantic_slam {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
constexpr double kFontHeightPx = 21.0;    // of its capitals at scale 1
constexpr double kLegibleLetterPx = 5.0;  // smaller ones become bars

int FontThickness(double letter_px) {
  return std::max(1, cvRound(letter_px / 11.0));
}

}  // namespace

double Painter::TextScale(double letter_m) const {
  return letter_m / texel_m_ / kFontHeightPx;
}

double Painter::TextWidth(double letter_m, const std::string& text) const {
  const int thickness = FontThickness(letter_m / texel_m_);
  return cv::getTextSize(text, kFont, TextScale(letter_m), thickness, nullptr).width * texel_m_;
}

void Painter::Text(double x_m, double y_m, double letter_m, const std::string& text,
                   const Bgr& colour, bool turned) {
  const int thickness = FontThickness(letter_m / texel_m_);
  const double scale = TextScale(letter_m);
  const cv::Point at(cvRound(x_m / texel_m_), cvRound(y_m / texel_m_));
  if (!turned) {
    cv::putText(image_, text, at, kFont, scale, colour, thickness, cv::LINE_AA);
    return;
  }
  int below_px = 0;
  const cv::Size size = cv::getTextSize(text, kFont, scale, thickness, &below_px);
  cv::Mat1b stencil = cv::Mat1b::zeros(size.height + below_px, size.width);
  cv::putText(stencil, text, {0, size.height}, kFont, scale, cv::Scalar(255), thickness,
              cv::LINE_AA);
  cv::rotate(stencil, stencil, cv::ROTATE_90_CLOCKWISE);
  const cv::Rect place =
      cv::Rect(at - cv::Point(below_px, 0), stencil.size()) & cv::Rect({}, image_.size());
  if (place.empty()) return;
  cv::Mat1f share;
  stencil(place - at + cv::Point(below_px, 0)).convertTo(share, CV_32F, 1.0 / 255.0);
  Painter(image_(place), texel_m_, 0).Glaze(colour, share);
}

void Painter::Print(double x_m, double y_m, double width_m, double height_m, double line_pitch_m,
                    const Bgr& colour) {
  const double letter_m = 0.55 * line_pitch_m;
  const bool is_legible = letter_m / texel_m_ >= kLegibleLetterPx;
  for (double line_m = y_m; line_m + line_pitch_m <= y_m + height_m; line_m += line_pitch_m) {
    const double end_m = x_m + width_m * (Chance(0.2) ? Uniform(0.3, 0.9) : 1.0);
    for (double word_m = x_m; word_m < end_m;) {
      const int letters = Integer(2, 9);
      const double space_m = 0.75 * letter_m;
      const double length_m = std::min(letters * 0.8 * letter_m, end_m - word_m);
      if (is_legible) {
        std::string word;
        for (int i = 0; i < letters; ++i) word += static_cast<char>('a' + Integer(0, 25));
        if (word_m + TextWidth(letter_m, word) > x_m + width_m) break;
        Text(word_m, line_m + 1.2 * letter_m, letter_m, word, colour);
        word_m += TextWidth(letter_m, word) + space_m;
      } else {
        Rectangle(word_m, line_m + 0.2 * letter_m, length_m, letter_m, Near(colour, 25));
        word_m += length_m + space_m;
      }
    }
  }
}

}  // namespace semantic_slam
