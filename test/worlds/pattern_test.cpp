#include "semantic_slam/worlds/pattern.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/worlds/texture.h"

namespace semantic_slam {
namespace {

Material MaterialOf(const std::string& pattern, std::uint64_t seed = 1) {
  Material material;
  material.pattern = pattern;
  material.rgb = {150, 125, 105};
  material.seed = seed;
  if (Patterns().at(pattern).extent == Pattern::Extent::kPicture) {
    material.picture_size_m = {0.7f, 0.5f};
  }
  return material;
}

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

// Corners per m2 that a camera with a focal length of 384 px sees from 2 m.
double CornersPerM2(const Texture& texture, float width_m, float height_m) {
  constexpr float kPixelM = 2.0f / 384;
  cv::Mat3b image(cvRound(height_m / kPixelM), cvRound(width_m / kPixelM));
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image(v, u) = texture.Sample((u + 0.5f) * kPixelM, (v + 0.5f) * kPixelM, kPixelM);
    }
  }
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  std::vector<cv::KeyPoint> corners;
  cv::FAST(grey, corners, 10);
  return static_cast<double>(corners.size()) / (width_m * height_m);
}

class PatternTest : public ::testing::TestWithParam<std::string> {};

TEST_P(PatternTest, OnlyTheSameMaterialIsTheSamePicture) {
  const Material material = MaterialOf(GetParam(), 1);
  const cv::Mat image = Texture(material).image();
  EXPECT_TRUE(SameBytes(image, Texture(material).image()));
  EXPECT_FALSE(SameBytes(image, Texture(MaterialOf(GetParam(), 2)).image())) << "other seed";
  Material recoloured = material;
  recoloured.rgb = {40, 60, 90};
  EXPECT_FALSE(SameBytes(image, Texture(recoloured).image())) << "other colour";
}

// Black and white stuff must not overflow, and pictures of any shape must be painted.
TEST_P(PatternTest, PaintsEveryColourAndShape) {
  for (const std::uint8_t grey : {0, 255}) {
    for (const Eigen::Vector2f& size_m : {Eigen::Vector2f(0.02f, 0.9f), Eigen::Vector2f(3, 0.03f),
                                          Eigen::Vector2f(0.002f, 0.002f)}) {
      Material material = MaterialOf(GetParam());
      material.rgb = {grey, grey, grey};
      if (Patterns().at(GetParam()).extent != Pattern::Extent::kRepeats) {
        material.picture_size_m = size_m;
      }
      EXPECT_FALSE(Texture(material).image().empty());
      if (material.picture_size_m.isZero()) break;
    }
  }
}

std::vector<std::string> NamesWhere(bool (*is_wanted)(const Pattern&)) {
  std::vector<std::string> names;
  for (const auto& [name, pattern] : Patterns()) {
    if (is_wanted(pattern)) names.push_back(name);
  }
  return names;
}

const auto kName = [](const auto& info) { return info.param; };
INSTANTIATE_TEST_SUITE_P(All, PatternTest,
                         ::testing::ValuesIn(NamesWhere([](const Pattern&) { return true; })),
                         kName);

class RepeatingPatternTest : public ::testing::TestWithParam<std::string> {};

// The largest difference, averaged along the line, between neighbouring rows.
double SteepestRow(const cv::Mat& image) {
  double steepest = 0.0;
  for (int row = 1; row < image.rows; ++row) {
    steepest = std::max(steepest, cv::norm(image.row(row - 1), image.row(row), cv::NORM_L1));
  }
  return steepest;
}

TEST_P(RepeatingPatternTest, HasNoSeamAndItsMaterialsColour) {
  const Material material = MaterialOf(GetParam());
  const cv::Mat image = Texture(material).image();
  for (const cv::Mat& side : {image, cv::Mat(image.t())}) {
    const double seam = cv::norm(side.row(0), side.row(side.rows - 1), cv::NORM_L1);
    // A seam may be where a brick ends, as steep as every other such line but for its noise.
    EXPECT_LE(seam, 1.05 * SteepestRow(side));
  }
  if (!Patterns().at(GetParam()).keeps_mean) return;
  const cv::Scalar mean = cv::mean(image);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(mean[i], material.rgb[2 - i], 1.0);  // what saturates cannot be moved
  }
}

INSTANTIATE_TEST_SUITE_P(All, RepeatingPatternTest,
                         ::testing::ValuesIn(NamesWhere([](const Pattern& pattern) {
                           return pattern.extent != Pattern::Extent::kPicture;
                         })),
                         kName);

// A view of 8 m2 needs some hundred corners.
TEST(PatternsTest, RichOnesHaveCornersForACamera) {
  for (const char* name :
       {"brick",          "cardboard",     "carpet",       "carpet_tiles", "checkered_tiles",
        "chipboard",      "cloth",         "cork",         "curtain",      "fabric",
        "floral_curtain", "floral_fabric", "foliage",      "herringbone",  "hexagon_wallpaper",
        "kilim",          "leather",       "marble",       "parquet",      "rug",
        "rustic_wood",    "shag_rug",      "subway_tiles", "terrazzo",     "tiles",
        "wallpaper",      "wood"}) {
    EXPECT_GT(CornersPerM2(Texture(MaterialOf(name)), 2.0f, 1.5f), 80.0) << name;
  }
  for (const char* name : {"books", "clock_face", "keyboard", "magazine", "newspaper", "painting",
                           "poster", "screen", "whiteboard", "window_view"}) {
    EXPECT_GT(CornersPerM2(Texture(MaterialOf(name)), 0.7f, 0.5f), 150.0) << name;
  }
}

TEST(PatternsTest, PoorOnesHaveNone) {
  for (const char* name : {"plaster", "ceiling_tiles", "plastic", "glass", "metal", "paper"}) {
    EXPECT_LT(CornersPerM2(Texture(MaterialOf(name)), 2.0f, 1.5f), 20.0) << name;
  }
}

}  // namespace
}  // namespace semantic_slam
