#include "testing/procedural_texture.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

constexpr int kSmallestLevelPx = 8;

// Paints in metres, so that patterns have the same size whatever the resolution.
class Painter {
 public:
  Painter(cv::Mat& image, double texel_m, std::uint64_t seed)
      : image_(image), texel_m_(texel_m), random_(seed) {}

  double Uniform(double low, double high) { return random_.uniform(low, high); }
  double width_m() const { return image_.cols * texel_m_; }
  double height_m() const { return image_.rows * texel_m_; }

  cv::Scalar Colour(double low, double high) {
    return {Uniform(low, high), Uniform(low, high), Uniform(low, high)};
  }
  cv::Scalar Near(const cv::Scalar& colour, double by) {
    const double shift = Uniform(-by, by);
    return colour + cv::Scalar::all(shift);
  }

  void Fill(const cv::Scalar& colour) { image_.setTo(colour); }

  void Rectangle(double x_m, double y_m, double w_m, double h_m, const cv::Scalar& colour) {
    cv::rectangle(image_, Pixel(x_m, y_m), Pixel(x_m + w_m, y_m + h_m), colour, cv::FILLED);
  }

  void Line(double x0_m, double y0_m, double x1_m, double y1_m, const cv::Scalar& colour) {
    cv::line(image_, Pixel(x0_m, y0_m), Pixel(x1_m, y1_m), colour, Pixels(0.004), cv::LINE_AA);
  }

  void Circle(double x_m, double y_m, double radius_m, const cv::Scalar& colour) {
    cv::circle(image_, Pixel(x_m, y_m), Pixels(radius_m), colour, cv::FILLED, cv::LINE_AA);
  }

  // A small quadrilateral of any shape: a stain, a scratch, a flake.
  void Fleck(double x_m, double y_m, double size_m, const cv::Scalar& colour) {
    std::vector<cv::Point> corners;
    for (int i = 0; i < 4; ++i) {
      const double angle = i * CV_PI / 2 + Uniform(0.0, 1.2);
      const double radius = size_m * Uniform(0.3, 0.7);
      corners.push_back(Pixel(x_m + radius * std::cos(angle), y_m + radius * std::sin(angle)));
    }
    cv::fillConvexPoly(image_, corners, colour, cv::LINE_AA);
  }

  void Flecks(double per_m2, double smallest_m, double largest_m, const cv::Scalar& base,
              double contrast) {
    const int count = static_cast<int>(per_m2 * width_m() * height_m());
    for (int i = 0; i < count; ++i) {
      Fleck(Uniform(0, width_m()), Uniform(0, height_m()), Uniform(smallest_m, largest_m),
            Near(base, contrast));
    }
  }

  void Checker(double x_m, double y_m, double cell_m, int columns, int rows) {
    const cv::Scalar dark = Colour(10, 90), light = Colour(160, 250);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        Rectangle(x_m + column * cell_m, y_m + row * cell_m, cell_m, cell_m,
                  (row + column) % 2 == 0 ? dark : light);
      }
    }
  }

  void Text(double x_m, double y_m, double letter_m, int letters, const cv::Scalar& colour) {
    std::string text;
    for (int i = 0; i < letters; ++i) text += static_cast<char>('A' + random_.uniform(0, 26));
    const double scale = letter_m / texel_m_ / 22.0;  // Hershey's letters are 22 px high at scale 1
    cv::putText(image_, text, Pixel(x_m, y_m), cv::FONT_HERSHEY_DUPLEX, scale, colour,
                Pixels(letter_m / 8), cv::LINE_AA);
  }

  // A printed sheet: a frame, and a picture of some kind in it.
  void Poster(double x_m, double y_m, double w_m, double h_m) {
    Rectangle(x_m, y_m, w_m, h_m, Colour(20, 70));
    const double border = 0.04 * std::min(w_m, h_m);
    const cv::Scalar paper = Colour(120, 240);
    Rectangle(x_m + border, y_m + border, w_m - 2 * border, h_m - 2 * border, paper);
    const double cell = w_m / 14;
    Checker(x_m + Uniform(1, 6) * cell, y_m + 0.12 * h_m, cell, 4 + random_.uniform(0, 3), 4);
    for (int i = 0; i < 12; ++i) {
      Circle(x_m + Uniform(0.15, 0.85) * w_m, y_m + Uniform(0.45, 0.75) * h_m,
             Uniform(0.01, 0.07) * w_m, Colour(0, 255));
    }
    for (int i = 0; i < 10; ++i) {
      Fleck(x_m + Uniform(0.15, 0.85) * w_m, y_m + Uniform(0.2, 0.75) * h_m,
            Uniform(0.05, 0.2) * w_m, Colour(0, 255));
    }
    for (int row = 0; row < 3; ++row) {
      Text(x_m + 0.1 * w_m, y_m + (0.83 + 0.05 * row) * h_m, 0.03 * h_m, 8 + random_.uniform(0, 6),
           Colour(0, 70));
    }
  }

  // Smooth variation over `size_m`, +- `amplitude`.
  void Cloud(double size_m, double amplitude) {
    const cv::Size coarse(std::max(2, static_cast<int>(width_m() / size_m)),
                          std::max(2, static_cast<int>(height_m() / size_m)));
    cv::Mat noise(coarse, CV_32FC1), smooth, image;
    random_.fill(noise, cv::RNG::UNIFORM, -amplitude, amplitude);
    cv::resize(noise, smooth, image_.size(), 0, 0, cv::INTER_CUBIC);
    cv::cvtColor(smooth, smooth, cv::COLOR_GRAY2BGR);
    image_.convertTo(image, CV_32FC3);
    image += smooth;
    image.convertTo(image_, CV_8UC3);
  }

 private:
  cv::Point Pixel(double x_m, double y_m) const {
    return {cvRound(x_m / texel_m_), cvRound(y_m / texel_m_)};
  }
  int Pixels(double length_m) const { return std::max(1, cvRound(length_m / texel_m_)); }

  cv::Mat& image_;
  const double texel_m_;
  cv::RNG random_;
};

void PaintWallpaper(Painter& painter) {
  const cv::Scalar base = painter.Colour(175, 225);
  painter.Fill(base);
  painter.Flecks(150.0, 0.015, 0.05, base, 45.0);
  const double step_m = 0.95;
  for (double x_m = 0.15; x_m + 0.75 < painter.width_m(); x_m += step_m) {
    const double w_m = painter.Uniform(0.5, 0.75);
    const double h_m = painter.Uniform(0.7, 1.0);
    painter.Poster(x_m + painter.Uniform(0.0, 0.1), painter.Uniform(0.35, 0.75), w_m, h_m);
  }
  // The skirting board, at the bottom.
  painter.Rectangle(0.0, painter.height_m() - 0.08, painter.width_m(), 0.08,
                    cv::Scalar(70, 90, 110));
}

void PaintPlanks(Painter& painter, double plank_w_m, double plank_h_m, const cv::Scalar& wood) {
  painter.Fill(wood * 0.5);
  bool shifted = false;
  for (double y_m = 0.0; y_m < painter.height_m(); y_m += plank_h_m, shifted = !shifted) {
    for (double x_m = shifted ? -plank_w_m / 2 : 0.0; x_m < painter.width_m(); x_m += plank_w_m) {
      const cv::Scalar colour = painter.Near(wood, 35.0);
      painter.Rectangle(x_m + 0.003, y_m + 0.003, plank_w_m - 0.006, plank_h_m - 0.006, colour);
      for (int i = 0; i < 3; ++i) {
        const double grain_m = y_m + painter.Uniform(0.1, 0.9) * plank_h_m;
        painter.Line(x_m + painter.Uniform(0.0, 0.4) * plank_w_m, grain_m,
                     x_m + painter.Uniform(0.5, 1.0) * plank_w_m, grain_m, colour * 0.75);
      }
    }
  }
  painter.Flecks(60.0, 0.01, 0.03, wood * 0.6, 30.0);
}

void PaintCeiling(Painter& painter) {
  PaintPlanks(painter, 0.6, 0.6, cv::Scalar(200, 205, 205));
  painter.Flecks(100.0, 0.01, 0.03, cv::Scalar::all(120), 50.0);
}

void PaintWood(Painter& painter) {
  PaintPlanks(painter, 0.6, 0.12, cv::Scalar(95, 140, 190));
  // Papers lie about.
  const int papers = static_cast<int>(4.0 * painter.width_m() * painter.height_m());
  for (int i = 0; i < papers; ++i) {
    const double x_m = painter.Uniform(0.0, painter.width_m() - 0.2);
    const double y_m = painter.Uniform(0.0, painter.height_m() - 0.28);
    painter.Rectangle(x_m, y_m, 0.2, 0.28, painter.Colour(215, 250));
    for (int row = 0; row < 7; ++row) {
      painter.Text(x_m + 0.02, y_m + 0.05 + 0.032 * row, 0.012, 9, painter.Colour(0, 60));
    }
  }
}

void PaintPackaging(Painter& painter) {
  const cv::Scalar base = painter.Colour(60, 220);
  painter.Fill(base);
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const double size_m = std::min(w_m, h_m);
  painter.Rectangle(0.0, 0.62 * h_m, w_m, 0.2 * h_m, painter.Colour(0, 255));
  painter.Checker(painter.Uniform(0.05, 0.5) * w_m, 0.1 * h_m, size_m / 12, 4, 3);
  for (int i = 0; i < 6; ++i) {
    painter.Circle(painter.Uniform(0.1, 0.9) * w_m, painter.Uniform(0.1, 0.9) * h_m,
                   painter.Uniform(0.02, 0.08) * size_m, painter.Colour(0, 255));
  }
  painter.Text(0.08 * w_m, 0.55 * h_m, 0.14 * size_m, 6, painter.Colour(0, 60));
  painter.Text(0.08 * w_m, 0.76 * h_m, 0.08 * size_m, 9, painter.Colour(200, 255));
  painter.Flecks(250.0, 0.008, 0.025, base, 90.0);
}

cv::Mat Paint(Material material, cv::Size size, double texel_m, std::uint64_t seed) {
  cv::Mat image(size, CV_8UC3);
  Painter painter(image, texel_m, seed);
  switch (material) {
    case Material::kWallpaper:
      PaintWallpaper(painter);
      break;
    case Material::kParquet:
      PaintPlanks(painter, 0.45, 0.09, cv::Scalar(70, 110, 160));
      break;
    case Material::kCeiling:
      PaintCeiling(painter);
      break;
    case Material::kWood:
      PaintWood(painter);
      break;
    case Material::kPackaging:
      PaintPackaging(painter);
      break;
  }
  painter.Cloud(0.5, 18.0);  // uneven light
  painter.Cloud(0.02, 8.0);  // uneven paint
  return image;
}

}  // namespace

ProceduralTexture::ProceduralTexture(Material material, double width_m, double height_m,
                                     double texel_m, std::uint64_t seed)
    : texel_m_(static_cast<float>(texel_m)) {
  const cv::Size size(std::max(kSmallestLevelPx, cvRound(width_m / texel_m)),
                      std::max(kSmallestLevelPx, cvRound(height_m / texel_m)));
  levels_.push_back(Paint(material, size, texel_m, seed));
  while (std::min(levels_.back().cols, levels_.back().rows) >= 2 * kSmallestLevelPx) {
    cv::Mat half;
    cv::resize(levels_.back(), half, levels_.back().size() / 2, 0, 0, cv::INTER_AREA);
    levels_.push_back(half);
  }
}

cv::Vec3f ProceduralTexture::Sample(float x_m, float y_m, float footprint_m) const {
  const float level = std::log2(std::max(footprint_m / texel_m_, 1.0f));
  const int last = static_cast<int>(levels_.size()) - 1;
  const int fine = std::min(static_cast<int>(level), last);
  const int coarse = std::min(fine + 1, last);
  const auto at = [&](int l) {
    const float texel = texel_m_ * static_cast<float>(1 << l);
    return Bilinear(levels_[l], x_m / texel - 0.5f, y_m / texel - 0.5f);
  };
  const float weight = std::clamp(level - static_cast<float>(fine), 0.0f, 1.0f);
  return (1.0f - weight) * at(fine) + weight * at(coarse);
}

cv::Vec3f ProceduralTexture::Bilinear(const cv::Mat& image, float x_px, float y_px) {
  const float x = std::clamp(x_px, 0.0f, static_cast<float>(image.cols - 1));
  const float y = std::clamp(y_px, 0.0f, static_cast<float>(image.rows - 1));
  const int x0 = std::min(static_cast<int>(x), image.cols - 2);
  const int y0 = std::min(static_cast<int>(y), image.rows - 2);
  const float dx = x - static_cast<float>(x0), dy = y - static_cast<float>(y0);
  const std::uint8_t* top = image.ptr(y0) + 3 * x0;
  const std::uint8_t* bottom = image.ptr(y0 + 1) + 3 * x0;
  cv::Vec3f colour;
  for (int i = 0; i < 3; ++i) {
    const float above = static_cast<float>(top[i]) + dx * static_cast<float>(top[i + 3] - top[i]);
    const float below =
        static_cast<float>(bottom[i]) + dx * static_cast<float>(bottom[i + 3] - bottom[i]);
    colour[i] = above + dy * (below - above);
  }
  return colour;
}

}  // namespace semantic_slam
