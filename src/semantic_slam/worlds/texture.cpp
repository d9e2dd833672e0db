#include "semantic_slam/worlds/texture.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

constexpr int kLongestEdgePx = 1024;    // of a picture, to bound memory
constexpr float kLongestEdgeM = 20.0f;  // to bound what is painted on it

const Pattern& PatternOf(const Material& material) {
  const auto found = Patterns().find(material.pattern);
  if (found != Patterns().end()) return found->second;
  std::string known;
  for (const auto& [name, pattern] : Patterns()) known += (known.empty() ? "" : ", ") + name;
  throw ConfigError("pattern \"" + material.pattern + "\" does not exist; there are " + known);
}

// Whether the material is one picture; throws ConfigError if its pattern does not allow that.
bool IsPicture(const Material& material, const Pattern& pattern) {
  const Eigen::Vector2f& size_m = material.picture_size_m;
  const bool has_size = (size_m.array() > 0.0f).all() && (size_m.array() <= kLongestEdgeM).all();
  const bool has_none = size_m == Eigen::Vector2f::Zero();
  if ((has_size && pattern.extent != Pattern::Extent::kRepeats) ||
      (has_none && pattern.extent != Pattern::Extent::kPicture)) {
    return has_size;
  }
  const bool must_repeat = pattern.extent == Pattern::Extent::kRepeats;
  throw ConfigError("picture_size_m of pattern \"" + material.pattern + "\" = [" +
                    std::to_string(size_m.x()) + ", " + std::to_string(size_m.y()) +
                    "], but must be " + (must_repeat ? "zero" : "in (0, 20]"));
}

std::uint64_t SeedOf(const Material& material) {
  std::uint64_t seed = HashOf({material.seed});
  for (const char letter : material.pattern) seed = HashOf({seed, std::uint64_t(letter)});
  return seed;
}

cv::Vec2f TexelsPerMetre(const cv::Mat& image, const Eigen::Vector2f& size_m) {
  return {static_cast<float>(image.cols) / size_m.x(), static_cast<float>(image.rows) / size_m.y()};
}

// Of four neighbours, `right` and `down` of the way from the first.
cv::Vec3f Blend(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c,
                const std::uint8_t* d, float right, float down) {
  const float weight_d = right * down;
  const float weight_c = down - weight_d;
  const float weight_b = right - weight_d;
  const float weight_a = 1.0f - right - weight_c;
  cv::Vec3f colour;
  for (int i = 0; i < 3; ++i) {
    colour[i] = weight_a * a[i] + weight_b * b[i] + weight_c * c[i] + weight_d * d[i];
  }
  return colour;
}

// NaN becomes `low`.
float Limited(float value, float low, float high) {
  value = value > low ? value : low;
  return value < high ? value : high;
}

}  // namespace

std::vector<std::string> PatternNames() {
  std::vector<std::string> names;
  for (const auto& [name, pattern] : Patterns()) names.push_back(name);
  return names;
}

Texture::Texture(const Material& material) {
  const Pattern& pattern = PatternOf(material);
  repeats_ = !IsPicture(material, pattern);
  cv::Size size_px = pattern.period_px;
  double texel_m = pattern.texel_m;
  Eigen::Vector2f size_m(size_px.width * texel_m, size_px.height * texel_m);
  if (!repeats_) {
    size_m = material.picture_size_m;
    texel_m = std::max(texel_m, static_cast<double>(size_m.maxCoeff()) / kLongestEdgePx);
    size_px = {std::max(1, cvRound(size_m.x() / texel_m)),
               std::max(1, cvRound(size_m.y() / texel_m))};
  }
  const Bgr colour(material.rgb[2], material.rgb[1], material.rgb[0]);
  cv::Mat image(size_px, CV_8UC3, colour);
  Painter painter(image, texel_m, SeedOf(material), repeats_);
  pattern.paint(painter, colour);
  if (repeats_ && pattern.keeps_mean) painter.SetMean(colour);
  texel_m_ = static_cast<float>(texel_m);
  levels_.push_back({image, TexelsPerMetre(image, size_m)});
  AddSmallerCopies();
}

Texture::Texture(const cv::Mat& image, const Eigen::Vector2f& size_m)
    : texel_m_(size_m.x() / static_cast<float>(image.cols)), repeats_(false) {
  assert(image.type() == CV_8UC3 && !image.empty() && size_m.minCoeff() > 0.0f);
  levels_.push_back({image, TexelsPerMetre(image, size_m)});
  AddSmallerCopies();
}

void Texture::AddSmallerCopies() {
  while (levels_.back().image.total() > 1) {
    const Level& fine = levels_.back();
    const cv::Size half(std::max(1, fine.image.cols / 2), std::max(1, fine.image.rows / 2));
    cv::Mat smaller;
    cv::resize(fine.image, smaller, half, 0, 0, cv::INTER_AREA);
    const cv::Vec2f scale(static_cast<float>(half.width) / fine.image.cols,
                          static_cast<float>(half.height) / fine.image.rows);
    levels_.push_back({smaller, fine.texels_per_m.mul(scale)});
  }
}

std::size_t Texture::SizeInBytes() const {
  std::size_t bytes = 0;
  for (const Level& level : levels_) bytes += level.image.total() * level.image.elemSize();
  return bytes;
}

cv::Vec3f Texture::Sample(float x_m, float y_m, float footprint_m) const {
  const int last = static_cast<int>(levels_.size()) - 1;
  const float texels = Limited(footprint_m / texel_m_, 1.0f, static_cast<float>(1 << last));
  // texels = 2^level * (1 + share), straight from the number's exponent and fraction.
  std::uint32_t bits = 0;
  std::memcpy(&bits, &texels, sizeof(bits));
  const int level = static_cast<int>(bits >> 23) - 127;
  const float share = static_cast<float>(bits & 0x7fffff) * 0x1.0p-23f;
  const cv::Vec3f fine = SampleLevel(level, x_m, y_m);
  if (level == last) return fine;
  return fine + share * (SampleLevel(level + 1, x_m, y_m) - fine);
}

template <bool kRepeats>
cv::Vec3f Texture::Bilinear(const Level& level, float x_m, float y_m) {
  constexpr float kFarthest = 1e9f;  // texels; an int can hold it
  const int columns = level.image.cols, rows = level.image.rows;
  const float x_px = Limited(x_m * level.texels_per_m[0] - 0.5f, kRepeats ? -kFarthest : 0.0f,
                             kRepeats ? kFarthest : static_cast<float>(columns - 1));
  const float y_px = Limited(y_m * level.texels_per_m[1] - 0.5f, kRepeats ? -kFarthest : 0.0f,
                             kRepeats ? kFarthest : static_cast<float>(rows - 1));
  int left = cvFloor(x_px), top = cvFloor(y_px);
  const float right_share = x_px - static_cast<float>(left);
  const float down_share = y_px - static_cast<float>(top);
  int right = left + 1, bottom = top + 1;
  if (kRepeats) {
    left &= columns - 1, right &= columns - 1;
    top &= rows - 1, bottom &= rows - 1;
  } else {
    right = std::min(right, columns - 1), bottom = std::min(bottom, rows - 1);
  }
  const std::uint8_t* upper = level.image.data + level.image.step.p[0] * top;
  const std::uint8_t* lower = level.image.data + level.image.step.p[0] * bottom;
  return Blend(upper + 3 * left, upper + 3 * right, lower + 3 * left, lower + 3 * right,
               right_share, down_share);
}

}  // namespace semantic_slam
