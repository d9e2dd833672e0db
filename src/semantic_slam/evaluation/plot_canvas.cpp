#include "semantic_slam/evaluation/plot_canvas.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

constexpr int kOversampling = 2;
constexpr int kShift = 4;  // fractional bits of coordinates
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kCapitalHeight = 21.0;  // of that font at scale 1 [px]
constexpr double kStrokePerHeight = 0.115;
const cv::Scalar kWhite(255, 255, 255);

cv::Point Fixed(cv::Point2d p) {
  // A pixel's centre has whole coordinates in OpenCV, its corner has them here.
  const double scale = kOversampling << kShift;
  const double half = 0.5 * (1 << kShift);
  return {cvRound(p.x * scale - half), cvRound(p.y * scale - half)};
}

int Thickness(double width) {
  return std::max(1, cvRound(width * kOversampling));
}

struct Lettering {
  explicit Lettering(double height)
      : scale(height * kOversampling / kCapitalHeight),
        thickness(Thickness(height * kStrokePerHeight)) {}
  double scale;
  int thickness;
};

cv::Size TextSize(const std::string& text, const Lettering& lettering) {
  int baseline = 0;
  return cv::getTextSize(text, kFont, lettering.scale, lettering.thickness, &baseline);
}

}  // namespace

PlotCanvas::PlotCanvas(cv::Size size)
    : size_(size), pixels_(size * kOversampling, CV_8UC3, kWhite) {}

void PlotCanvas::Line(cv::Point2d from, cv::Point2d to, const cv::Scalar& colour, double width) {
  cv::line(pixels_, Fixed(from), Fixed(to), colour, Thickness(width), cv::LINE_AA, kShift);
}

void PlotCanvas::DashedLine(cv::Point2d from, cv::Point2d to, const cv::Scalar& colour,
                            double width) {
  constexpr double kDash = 10.0;
  constexpr double kPeriod = 16.0;
  const double length = cv::norm(to - from);
  const cv::Point2d direction = (to - from) / std::max(length, 1.0);
  for (double s = 0.0; s < length; s += kPeriod) {
    Line(from + s * direction, from + std::min(s + kDash, length) * direction, colour, width);
  }
}

void PlotCanvas::Polyline(const std::vector<cv::Point2d>& points, const cv::Scalar& colour,
                          double width) {
  std::vector<cv::Point> fixed(points.size());
  std::transform(points.begin(), points.end(), fixed.begin(), Fixed);
  cv::polylines(pixels_, fixed, false, colour, Thickness(width), cv::LINE_AA, kShift);
}

void PlotCanvas::Rectangle(const cv::Rect2d& box, const cv::Scalar& colour, double width) {
  const cv::Point2d top_left = box.tl();
  const cv::Point2d bottom_right = box.br();
  Polyline({top_left,
            {bottom_right.x, top_left.y},
            bottom_right,
            {top_left.x, bottom_right.y},
            top_left},
           colour, width);
}

void PlotCanvas::Dot(cv::Point2d centre, double radius, const cv::Scalar& colour) {
  const auto disc = [&](double r, const cv::Scalar& fill) {
    cv::circle(pixels_, Fixed(centre), cvRound(r * (kOversampling << kShift)), fill, cv::FILLED,
               cv::LINE_AA, kShift);
  };
  disc(radius + 1.5, kWhite);
  disc(radius, colour);
}

void PlotCanvas::Square(cv::Point2d centre, double half_side, const cv::Scalar& colour) {
  const auto box = [&](double h, const cv::Scalar& fill) {
    const cv::Point2d half(h, h);
    cv::rectangle(pixels_, Fixed(centre - half), Fixed(centre + half), fill, cv::FILLED,
                  cv::LINE_AA, kShift);
  };
  box(half_side + 1.5, kWhite);
  box(half_side, colour);
}

void PlotCanvas::Paste(const cv::Mat& picture, cv::Point top_left) {
  const cv::Rect box(top_left * kOversampling, picture.size() * kOversampling);
  cv::resize(picture, pixels_(box), box.size(), 0.0, 0.0, cv::INTER_NEAREST);
}

void PlotCanvas::Text(const std::string& text, cv::Point2d anchor, HorizontalAlign align,
                      double height, const cv::Scalar& colour) {
  PutText(text, anchor, align, height, colour, 0.0);
}

void PlotCanvas::RimmedText(const std::string& text, cv::Point2d anchor, HorizontalAlign align,
                            double height, const cv::Scalar& colour) {
  PutText(text, anchor, align, height, kWhite, 1.5);
  PutText(text, anchor, align, height, colour, 0.0);
}

// `rim` [px] is how much wider than usual the strokes are to either side.
void PlotCanvas::PutText(const std::string& text, cv::Point2d anchor, HorizontalAlign align,
                         double height, const cv::Scalar& colour, double rim) {
  const Lettering lettering(height);
  const double width = TextSize(text, lettering).width;
  double left = anchor.x * kOversampling;
  if (align == HorizontalAlign::kCentre) left -= 0.5 * width;
  if (align == HorizontalAlign::kRight) left -= width;
  cv::putText(pixels_, text, {cvRound(left), cvRound(anchor.y * kOversampling)}, kFont,
              lettering.scale, colour, lettering.thickness + cvRound(2.0 * rim * kOversampling),
              cv::LINE_AA);
}

void PlotCanvas::VerticalText(const std::string& text, cv::Point2d centre, double height,
                              const cv::Scalar& colour) {
  const Lettering lettering(height);
  const cv::Size size = TextSize(text, lettering);
  const int margin = size.height;  // for what hangs below the base line
  cv::Mat strip(size.height + 2 * margin, size.width, CV_8UC3, kWhite);
  cv::putText(strip, text, {0, size.height + margin}, kFont, lettering.scale, colour,
              lettering.thickness, cv::LINE_AA);
  cv::rotate(strip, strip, cv::ROTATE_90_COUNTERCLOCKWISE);
  const cv::Point top_left(cvRound(centre.x * kOversampling - 0.5 * strip.cols),
                           cvRound(centre.y * kOversampling - 0.5 * strip.rows));
  const cv::Rect box = cv::Rect(top_left, strip.size()) & cv::Rect({0, 0}, pixels_.size());
  if (box.empty()) return;
  cv::Mat target = pixels_(box);
  cv::min(target, strip(box - top_left), target);
}

double PlotCanvas::TextWidth(const std::string& text, double height) {
  return static_cast<double>(TextSize(text, Lettering(height)).width) / kOversampling;
}

cv::Mat PlotCanvas::Image() const {
  cv::Mat image;
  cv::resize(pixels_, image, size_, 0.0, 0.0, cv::INTER_AREA);
  return image;
}

}  // namespace semantic_slam
