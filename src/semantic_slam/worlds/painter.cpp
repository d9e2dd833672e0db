#include "semantic_slam/worlds/painter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

constexpr int kFractionBits = 4;  // of the coordinates that OpenCV draws at

[[maybe_unused]] bool IsPowerOfTwo(int n) {
  return n > 0 && (n & (n - 1)) == 0;
}

cv::Rect2d BoundsOf(const std::vector<cv::Point2d>& points, double margin) {
  cv::Point2d low = points.front(), high = points.front();
  for (const cv::Point2d& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const cv::Point2d by(margin, margin);
  return {low - by, high + by};
}

}  // namespace

Bgr Hsv(double hue, double saturation, double value) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + 6.0 * (hue - std::floor(hue)), 6.0);
    return 255.0 * value * (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(1.0), channel(3.0), channel(5.0)};
}

Bgr Mix(const Bgr& a, const Bgr& b, double share_of_b) {
  return a * (1.0 - share_of_b) + b * share_of_b;
}

double Luma(const Bgr& colour) {
  return 0.114 * colour[0] + 0.587 * colour[1] + 0.299 * colour[2];
}

Bgr InkOn(const Bgr& paper) {
  return Luma(paper) > 110 ? Bgr::all(25) : Bgr::all(235);
}

Painter::Painter(const cv::Mat& image, double texel_m, std::uint64_t seed, bool wraps)
    : image_(image), texel_m_(texel_m), wraps_(wraps), random_(seed) {
  assert(image.type() == CV_8UC3 && !image.empty() && texel_m > 0.0);
  assert(!wraps || (IsPowerOfTwo(image.cols) && IsPowerOfTwo(image.rows)));
}

Painter Painter::Part(double x_m, double y_m, double width_m, double height_m) {
  const int left = std::clamp(cvRound(x_m / texel_m_), 0, image_.cols - 1);
  const int top = std::clamp(cvRound(y_m / texel_m_), 0, image_.rows - 1);
  const int right = std::clamp(cvRound((x_m + width_m) / texel_m_), left + 1, image_.cols);
  const int bottom = std::clamp(cvRound((y_m + height_m) / texel_m_), top + 1, image_.rows);
  return {image_(cv::Rect(left, top, right - left, bottom - top)), texel_m_, random_.Bits()};
}

int Painter::Integer(int low, int high) {
  return low + static_cast<int>(random_.Uniform() * (high - low + 1));
}

Bgr Painter::Near(const Bgr& colour, double by) {
  const double lighter = Uniform(-by, by);
  Bgr near = colour;
  for (int i = 0; i < 3; ++i) {
    near[i] = std::clamp(colour[i] + lighter + Uniform(-by, by) / 4, 0.0, 255.0);
  }
  return near;
}

// Calls draw(offset) for the shape itself and for its copies that reach into an image that wraps.
template <typename Draw>
void Painter::ForEachCopy(const cv::Rect2d& bounds_m, const Draw& draw) {
  if (!wraps_) return draw(cv::Point2d());
  const cv::Rect2d image_m(0, 0, width_m(), height_m());
  for (const double dy_m : {-height_m(), 0.0, height_m()}) {
    for (const double dx_m : {-width_m(), 0.0, width_m()}) {
      const cv::Point2d moved_m(dx_m, dy_m);
      if (!((bounds_m + moved_m) & image_m).empty()) draw(moved_m);
    }
  }
}

std::vector<cv::Point> Painter::FixedPoint(const std::vector<cv::Point2d>& points_m,
                                           const cv::Point2d& moved_m) const {
  std::vector<cv::Point> fixed;
  fixed.reserve(points_m.size());
  for (const cv::Point2d& p : points_m) {
    const cv::Point2d px = (p + moved_m) / texel_m_ - cv::Point2d(0.5, 0.5);
    fixed.push_back(px * (1 << kFractionBits));
  }
  return fixed;
}

int Painter::Pixels(double length_m) const {
  return std::max(1, cvRound(length_m / texel_m_));
}

void Painter::Gradient(const Bgr& top, const Bgr& bottom) {
  for (int row = 0; row < image_.rows; ++row) {
    image_.row(row).setTo(Mix(top, bottom, (row + 0.5) / image_.rows));
  }
}

void Painter::Rectangle(double x_m, double y_m, double width_m, double height_m,
                        const Bgr& colour) {
  const auto px = [&](double m) { return cvRound(m / texel_m_); };
  ForEachCopy({x_m - texel_m_, y_m - texel_m_, width_m + 2 * texel_m_, height_m + 2 * texel_m_},
              [&](const cv::Point2d& by) {
                const int left = px(x_m + by.x), top = px(y_m + by.y);
                const cv::Rect rect(left, top, std::max(1, px(x_m + width_m + by.x) - left),
                                    std::max(1, px(y_m + height_m + by.y) - top));
                const cv::Rect inside = rect & cv::Rect({}, image_.size());
                if (!inside.empty()) image_(inside).setTo(colour);
              });
}

void Painter::Polygon(const std::vector<cv::Point2d>& corners_m, const Bgr& colour) {
  ForEachCopy(BoundsOf(corners_m, texel_m_), [&](const cv::Point2d& by) {
    cv::fillPoly(image_, FixedPoint(corners_m, by), colour, cv::LINE_AA, kFractionBits);
  });
}

void Painter::Ellipse(const cv::Point2d& centre_m, double radius_x_m, double radius_y_m,
                      const Bgr& colour, double turn_rad) {
  const double reach_m = std::max(radius_x_m, radius_y_m) + texel_m_;
  ForEachCopy(BoundsOf({centre_m}, reach_m), [&](const cv::Point2d& by) {
    const double unit = (1 << kFractionBits) / texel_m_;
    cv::ellipse(image_, FixedPoint({centre_m}, by).front(),
                cv::Size(cvRound(radius_x_m * unit), cvRound(radius_y_m * unit)),
                turn_rad * 180.0 / CV_PI, 0, 360, colour, cv::FILLED, cv::LINE_AA, kFractionBits);
  });
}

void Painter::Line(const std::vector<cv::Point2d>& points_m, double width_m, const Bgr& colour,
                   bool closed) {
  ForEachCopy(BoundsOf(points_m, width_m + texel_m_), [&](const cv::Point2d& by) {
    cv::polylines(image_, FixedPoint(points_m, by), closed, colour, Pixels(width_m), cv::LINE_AA,
                  kFractionBits);
  });
}

void Painter::Frame(double x_m, double y_m, double width_m, double height_m, double line_m,
                    const Bgr& colour) {
  Rectangle(x_m, y_m, width_m, line_m, colour);
  Rectangle(x_m, y_m + height_m - line_m, width_m, line_m, colour);
  Rectangle(x_m, y_m, line_m, height_m, colour);
  Rectangle(x_m + width_m - line_m, y_m, line_m, height_m, colour);
}

void Painter::Fleck(const cv::Point2d& centre_m, double size_m, const Bgr& colour) {
  std::vector<cv::Point2d> corners_m;
  for (int i = 0; i < 4; ++i) {
    const double angle = i * CV_PI / 2 + Uniform(0.0, 1.2);
    const double radius_m = size_m * Uniform(0.3, 0.7);
    corners_m.push_back(centre_m + radius_m * cv::Point2d(std::cos(angle), std::sin(angle)));
  }
  ForEachCopy(BoundsOf(corners_m, texel_m_), [&](const cv::Point2d& by) {
    cv::fillConvexPoly(image_, FixedPoint(corners_m, by), colour, cv::LINE_AA, kFractionBits);
  });
}

void Painter::Flecks(double per_m2, double smallest_m, double largest_m, const Bgr& colour,
                     double contrast) {
  const int count = cvRound(per_m2 * width_m() * height_m());
  for (int i = 0; i < count; ++i) {
    const cv::Point2d centre_m(Uniform(0.0, width_m()), Uniform(0.0, height_m()));
    Fleck(centre_m, Uniform(smallest_m, largest_m), Near(colour, contrast));
  }
}

// A power of two if the painter wraps, so that a cell is a whole number of texels.
int Painter::CellsOfNoise(double length_m, double size_m, int texels) const {
  const double cells = std::clamp(length_m / size_m, 1.0, static_cast<double>(texels));
  return wraps_ ? 1 << cvRound(std::log2(cells)) : cvRound(cells);
}

cv::Mat1f Painter::Noise(double size_x_m, double size_y_m) {
  const cv::Size cells(CellsOfNoise(width_m(), size_x_m, image_.cols),
                       CellsOfNoise(height_m(), size_y_m, image_.rows));
  cv::Mat1f noise(cells), smooth;
  for (float& value : noise) value = static_cast<float>(Uniform(-1.0, 1.0));
  if (cells == image_.size()) return noise;
  if (!wraps_) {
    cv::resize(noise, smooth, image_.size(), 0, 0, cv::INTER_CUBIC);
    return smooth;
  }
  constexpr int kMargin = 2;  // cells; as far as cubic interpolation looks
  const cv::Size cell_px(image_.cols / cells.width, image_.rows / cells.height);
  cv::copyMakeBorder(noise, noise, kMargin, kMargin, kMargin, kMargin, cv::BORDER_WRAP);
  cv::resize(noise, smooth, cv::Size(noise.cols * cell_px.width, noise.rows * cell_px.height), 0, 0,
             cv::INTER_CUBIC);
  return smooth(cv::Rect({kMargin * cell_px.width, kMargin * cell_px.height}, image_.size()));
}

void Painter::AddGrey(const cv::Mat1f& grey) {
  for (int row = 0; row < image_.rows; ++row) {
    std::uint8_t* bgr = image_.ptr(row);
    const float* by = grey[row];
    for (int column = 0; column < image_.cols; ++column, bgr += 3) {
      const int step = cvRound(by[column]);
      for (int i = 0; i < 3; ++i) bgr[i] = cv::saturate_cast<std::uint8_t>(bgr[i] + step);
    }
  }
}

void Painter::Glaze(const Bgr& colour, const cv::Mat1f& share) {
  const cv::Vec3f over(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                       static_cast<float>(colour[2]));
  for (int row = 0; row < image_.rows; ++row) {
    std::uint8_t* bgr = image_.ptr(row);
    for (int column = 0; column < image_.cols; ++column, bgr += 3) {
      const float weight = share(row, column);
      for (int i = 0; i < 3; ++i) {
        bgr[i] = cv::saturate_cast<std::uint8_t>(bgr[i] + weight * (over[i] - bgr[i]));
      }
    }
  }
}

void Painter::RemoveColour() {
  cv::Mat grey;
  cv::cvtColor(image_, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, image_, cv::COLOR_GRAY2BGR);
}

void Painter::Blur(double sigma_m) {
  cv::GaussianBlur(image_, image_, {}, sigma_m / texel_m_, 0.0,
                   cv::BORDER_REPLICATE | cv::BORDER_ISOLATED);
}

void Painter::SetMean(const Bgr& colour) {
  image_ += colour - cv::mean(image_);
}

}  // namespace semantic_slam
