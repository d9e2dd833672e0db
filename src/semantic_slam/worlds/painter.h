#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/random_stream.h"

namespace semantic_slam {

using Bgr = cv::Scalar;  // 0..255 each

// Hue from red over green and blue to red again, saturation and value, each 0..1.
Bgr Hsv(double hue, double saturation, double value);
Bgr Mix(const Bgr& a, const Bgr& b, double share_of_b);
double Luma(const Bgr& colour);  // 0..255
// Black or white-ish ink, whichever can be read on `paper`.
Bgr InkOn(const Bgr& paper);

// Draws on an image in metres, x to the right and y down from its upper left corner, so that
// things have the same size whatever the resolution. Parts outside the image are cut off, or come
// in at the opposite edge if the painter wraps. The same seed and calls draw the same bytes. Not
// thread-safe.
class Painter {
 public:
  // Shares the pixels of `image`, CV_8UC3. Sides of an image that wraps are powers of two.
  Painter(const cv::Mat& image, double texel_m, std::uint64_t seed, bool wraps = false);

  double width_m() const { return image_.cols * texel_m_; }
  double height_m() const { return image_.rows * texel_m_; }
  double texel_m() const { return texel_m_; }
  bool wraps() const { return wraps_; }
  cv::Size size_px() const { return image_.size(); }

  // A painter for a rectangle of the image (what of it lies inside, at least one texel), with
  // random numbers of its own.
  Painter Part(double x_m, double y_m, double width_m, double height_m);

  double Uniform(double low, double high) { return low + (high - low) * random_.Uniform(); }
  int Integer(int low, int high);  // both included
  bool Chance(double probability) { return random_.Uniform() < probability; }
  template <typename T>
  const T& Pick(const std::vector<T>& from) {
    return from[Integer(0, static_cast<int>(from.size()) - 1)];
  }
  // `colour` lighter or darker by up to `by`; hues may drift apart by a quarter of that.
  Bgr Near(const Bgr& colour, double by);

  void Fill(const Bgr& colour) { image_.setTo(colour); }
  // From the upper to the lower edge.
  void Gradient(const Bgr& top, const Bgr& bottom);
  void Rectangle(double x_m, double y_m, double width_m, double height_m, const Bgr& colour);
  void Polygon(const std::vector<cv::Point2d>& corners_m, const Bgr& colour);
  void Ellipse(const cv::Point2d& centre_m, double radius_x_m, double radius_y_m, const Bgr& colour,
               double turn_rad = 0.0);
  void Disc(const cv::Point2d& centre_m, double radius_m, const Bgr& colour) {
    Ellipse(centre_m, radius_m, radius_m, colour);
  }
  // Through all points; at least one texel wide.
  void Line(const std::vector<cv::Point2d>& points_m, double width_m, const Bgr& colour,
            bool closed = false);
  void Frame(double x_m, double y_m, double width_m, double height_m, double line_m,
             const Bgr& colour);
  // A small quadrilateral of any shape: a stain, a chip, a fleck.
  void Fleck(const cv::Point2d& centre_m, double size_m, const Bgr& colour);
  // Flecks everywhere, `colour` lighter or darker by up to `contrast`.
  void Flecks(double per_m2, double smallest_m, double largest_m, const Bgr& colour,
              double contrast);
  // Capitals are `letter_m` high; their left lower corner is (x_m, y_m). Turned text runs
  // downwards, as on the back of a book, and the left upper corner of its capitals is there.
  void Text(double x_m, double y_m, double letter_m, const std::string& text, const Bgr& colour,
            bool turned = false);
  double TextWidth(double letter_m, const std::string& text) const;
  // Lines of small print that fill a rectangle; words are grey bars where letters would be too
  // small to be drawn.
  void Print(double x_m, double y_m, double width_m, double height_m, double line_pitch_m,
             const Bgr& colour);

  // Smooth random values about -1..1 per texel that vary over about the given lengths; with ends
  // that meet if the painter wraps.
  cv::Mat1f Noise(double size_x_m, double size_y_m);
  cv::Mat1f Noise(double size_m) { return Noise(size_m, size_m); }
  // Adds the same to all three colours of each texel.
  void AddGrey(const cv::Mat1f& grey);
  void AddNoise(double size_x_m, double size_y_m, double contrast) {
    AddGrey(contrast * Noise(size_x_m, size_y_m));
  }
  void AddNoise(double size_m, double contrast) { AddNoise(size_m, size_m, contrast); }
  // Lays `colour` over each texel with the given share, 0..1.
  void Glaze(const Bgr& colour, const cv::Mat1f& share);
  void RemoveColour();
  // Gaussian.
  void Blur(double sigma_m);
  // Moves all colours so that their mean becomes `colour` as far as saturation allows.
  void SetMean(const Bgr& colour);

 private:
  template <typename Draw>
  void ForEachCopy(const cv::Rect2d& bounds_m, const Draw& draw);
  std::vector<cv::Point> FixedPoint(const std::vector<cv::Point2d>& points_m,
                                    const cv::Point2d& moved_m) const;
  int Pixels(double length_m) const;
  double TextScale(double letter_m) const;
  int CellsOfNoise(double length_m, double size_m, int texels) const;

  cv::Mat image_;
  double texel_m_;
  bool wraps_;
  RandomStream random_;
};

}  // namespace semantic_slam
