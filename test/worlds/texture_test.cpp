#include "semantic_slam/worlds/texture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

Material MaterialOf(const std::string& pattern) {
  Material material;
  material.pattern = pattern;
  material.rgb = {150, 120, 100};
  return material;
}

Material PictureOf(const std::string& pattern, float width_m, float height_m) {
  Material material = MaterialOf(pattern);
  material.picture_size_m = {width_m, height_m};
  return material;
}

void ExpectNear(const cv::Vec3f& a, const cv::Vec3f& b, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "colour " << i;
}

cv::Vec3f MeanOf(const Texture& texture) {
  const cv::Scalar mean = cv::mean(texture.image());
  return {float(mean[0]), float(mean[1]), float(mean[2])};
}

TEST(TextureTest, RefusesAPatternThatDoesNotExistAndNamesThoseThatDo) {
  ExpectOneLineWith(MessageOf<ConfigError>([] { Texture(MaterialOf("tartan")); }),
                    {"\"tartan\"", "brick", "parquet", "wood"});
}

TEST(TextureTest, RefusesAPictureWithoutASize) {
  ExpectOneLineWith(MessageOf<ConfigError>([] { Texture(MaterialOf("poster")); }),
                    {"picture_size_m", "\"poster\"", "in (0, 20]"});
  EXPECT_THROW(Texture(PictureOf("poster", 1, -1)), ConfigError);
  EXPECT_THROW(Texture(PictureOf("poster", 1, 0)), ConfigError);
  EXPECT_THROW(Texture(PictureOf("poster", 21, 1)), ConfigError);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(Texture(PictureOf("poster", nan, 1)), ConfigError);
  EXPECT_THROW(Texture(PictureOf("rug", 1, -1)), ConfigError);
}

TEST(TextureTest, RefusesASizeOfWhatRepeatsForEver) {
  ExpectOneLineWith(MessageOf<ConfigError>([] { Texture(PictureOf("brick", 2, 1)); }),
                    {"picture_size_m", "\"brick\"", "[2", "zero"});
}

TEST(TextureTest, RugAndCorkAreEither) {
  for (const char* pattern : {"rug", "cork"}) {
    EXPECT_NEAR(Texture(MaterialOf(pattern)).image().cols, 512, 0) << pattern;
    EXPECT_NEAR(Texture(PictureOf(pattern, 1.5f, 0.9f)).image().cols, 600, 150) << pattern;
  }
}

TEST(TextureTest, PictureHasTheShapeOfItsSize) {
  const Texture texture(PictureOf("poster", 0.6f, 0.9f));
  EXPECT_EQ(texture.image().cols, 300);
  EXPECT_EQ(texture.image().rows, 450);
  EXPECT_FLOAT_EQ(texture.texel_m(), 0.002f);
}

TEST(TextureTest, HugeAndTinyPicturesStayWithinMemory) {
  EXPECT_EQ(Texture(PictureOf("whiteboard", 20.0f, 10.0f)).image().size(), cv::Size(1024, 512));
  const Texture tiny(PictureOf("whiteboard", 1e-6f, 1e-6f));
  EXPECT_EQ(tiny.image().size(), cv::Size(1, 1));
}

TEST(TextureTest, SmallerCopiesCostAThirdMore) {
  const Texture texture(MaterialOf("brick"));
  const double finest = static_cast<double>(texture.image().total() * 3);
  EXPECT_NEAR(texture.SizeInBytes() / finest, 4.0 / 3, 0.001);
}

class SampleTest : public ::testing::TestWithParam<Material> {
 protected:
  const Texture texture_{GetParam()};
  const float texel_m_ = texture_.texel_m();
  cv::Vec3f Texel(int x, int y) const { return texture_.image().at<cv::Vec3b>(y, x); }
};

TEST_P(SampleTest, MiddleOfATexelIsTheTexel) {
  for (const cv::Point p : {cv::Point(0, 0), cv::Point(17, 33), cv::Point(200, 101)}) {
    // The place in texels is rounded to a float: 200 +- 1e-5, times a step of 255 at most.
    ExpectNear(texture_.Sample((p.x + 0.5f) * texel_m_, (p.y + 0.5f) * texel_m_, 0.0f),
               Texel(p.x, p.y), 0.01);
  }
}

TEST_P(SampleTest, BetweenTexelsIsBetweenTheirColours) {
  ExpectNear(texture_.Sample(41 * texel_m_, 50.5f * texel_m_, texel_m_),
             0.5f * (Texel(40, 50) + Texel(41, 50)), 0.01);
  ExpectNear(texture_.Sample(40.5f * texel_m_, 50.75f * texel_m_, texel_m_),
             0.75f * Texel(40, 50) + 0.25f * Texel(40, 51), 0.01);
}

TEST_P(SampleTest, FootprintOfTwoTexelsIsTheMeanOfFour) {
  const cv::Vec3f mean = 0.25f * (Texel(64, 32) + Texel(65, 32) + Texel(64, 33) + Texel(65, 33));
  // The smaller copy is rounded to whole grey levels.
  ExpectNear(texture_.Sample(65 * texel_m_, 33 * texel_m_, 2 * texel_m_), mean, 0.51);
}

TEST_P(SampleTest, FootprintsBetweenBlend) {
  const auto at = [&](float texels) { return texture_.Sample(0.3f, 0.2f, texels * texel_m_); };
  ExpectNear(at(1.5f), 0.5f * (at(1) + at(2)), 0.01);
  ExpectNear(at(7), 0.25f * at(4) + 0.75f * at(8), 0.01);
}

TEST_P(SampleTest, LargeFootprintIsTheMean) {
  for (const float footprint_m : {100.0f, 1e30f, std::numeric_limits<float>::infinity()}) {
    // Means of four are rounded to whole grey levels, halves upwards: 1/8 too bright per halving,
    // of which there are ten, and half a level in the end.
    ExpectNear(texture_.Sample(0.3f, 0.2f, footprint_m), MeanOf(texture_), 1.75);
  }
}

TEST_P(SampleTest, AnyNumberGivesAColour) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const float values[] = {nan, infinity, -infinity, 1e38f, -1e38f, 0.0f, -3.7f, 1e-40f};
  for (const float x : values) {
    for (const float y : values) {
      for (const float footprint : values) {
        const cv::Vec3f colour = texture_.Sample(x, y, footprint);
        for (int i = 0; i < 3; ++i) {
          ASSERT_TRUE(colour[i] >= 0.0f && colour[i] <= 255.01f)
              << x << " " << y << " " << footprint << ": " << colour[i];
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BrickAndPoster, SampleTest,
                         ::testing::Values(MaterialOf("brick"), PictureOf("poster", 0.6f, 0.9f)));

TEST(TextureTest, WhatRepeatsDoesSoOnBothSides) {
  const Texture texture(MaterialOf("brick"));
  const float period_m = texture.texel_m() * 1024;
  for (const float footprint_m : {0.001f, 0.02f, 0.3f}) {
    const cv::Vec3f colour = texture.Sample(0.31f, 0.47f, footprint_m);
    // The place is rounded to a float: 1e-3 texels at 5 periods, times a step of 255 at most.
    ExpectNear(texture.Sample(0.31f + period_m, 0.47f, footprint_m), colour, 0.3);
    ExpectNear(texture.Sample(0.31f, 0.47f - 2 * period_m, footprint_m), colour, 0.3);
    ExpectNear(texture.Sample(0.31f - 5 * period_m, 0.47f + period_m, footprint_m), colour, 0.3);
  }
}

TEST(TextureTest, PictureGoesOnAsAtItsEdge) {
  const Texture texture(PictureOf("painting", 0.6f, 0.5f));
  ExpectNear(texture.Sample(-5.0f, 0.2f, 0.0f), texture.Sample(0.0f, 0.2f, 0.0f), 0.0);
  ExpectNear(texture.Sample(7.0f, 9.0f, 0.0f), texture.image().at<cv::Vec3b>(249, 299), 0.0);
}

TEST(TextureTest, PictureIsNotSquashedInSmallerCopies) {
  // 401 x 267 texels: halves are rounded, and places on them must follow.
  const Texture texture(PictureOf("poster", 0.802f, 0.534f));
  const cv::Mat& image = texture.image();
  cv::Mat3b right = image.colRange(image.cols - 64, image.cols).rowRange(64, 128);
  const cv::Scalar mean = cv::mean(right);
  // 64 texels are cell 6 of 64 texels, smaller by 1.6 % than 401 / 6; bilinear across neighbours.
  const cv::Vec3f seen = texture.Sample(0.802f - 0.064f, 0.192f, 0.128f);
  ExpectNear(seen, {float(mean[0]), float(mean[1]), float(mean[2])}, 25.0);
}

TEST(TextureTest, TakesAPictureOfOnesOwn) {
  const cv::Mat3b image = (cv::Mat3b(1, 2) << cv::Vec3b(0, 0, 0), cv::Vec3b(200, 100, 50));
  const Texture texture(image, {0.2f, 0.1f});
  EXPECT_FLOAT_EQ(texture.texel_m(), 0.1f);
  ExpectNear(texture.Sample(0.15f, 0.05f, 0.0f), {200, 100, 50}, 0.0);
  ExpectNear(texture.Sample(0.10f, 0.05f, 0.0f), {100, 50, 25}, 0.001);
}

TEST(TextureTest, PatternNamesAreSorted) {
  const std::vector<std::string> names = PatternNames();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(names.size(), 59u);
}

}  // namespace
}  // namespace semantic_slam
