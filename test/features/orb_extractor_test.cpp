#include "semantic_slam/features/orb_extractor.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "testing/expect_error.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

cv::Mat Grey(const RgbdImage& image) {
  cv::Mat grey;
  cv::cvtColor(image.colour, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

// Squares, smoothed as by a lens, so that the image can be turned without becoming another one.
cv::Mat SmoothSquares() {
  cv::Mat smooth;
  cv::GaussianBlur(Grey(SquaresImage(1)), smooth, cv::Size(5, 5), 1.2);
  return smooth;
}

// Grey with a brighter square of 10 px every 30 px.
cv::Mat SquaresOfContrast(int contrast) {
  cv::Mat image(240, 320, CV_8UC1, cv::Scalar::all(100));
  for (int v = 10; v < image.rows; v += 30) {
    for (int u = 10; u < image.cols; u += 30) {
      image(cv::Rect(u, v, 10, 10) & cv::Rect(0, 0, 320, 240)) = 100 + contrast;
    }
  }
  cv::GaussianBlur(image, image, cv::Size(3, 3), 0.8);
  return image;
}

double AngleDifferenceDeg(float a_rad, float b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, 2.0 * M_PI)) * 180.0 / M_PI;
}

// Extracts from an image and from the same one turned by `turn_deg` (x to y), and compares what is
// found at corresponding places.
struct TurnedComparison {
  int corresponding = 0;  // keypoints found in both
  int alike = 0;          // of those, with descriptors fewer than a fifth of the bits apart
  double mean_angle_error_deg = 0.0;

  explicit TurnedComparison(double turn_deg) {
    const cv::Mat image = SmoothSquares();
    const cv::Point2f centre(159.5f, 119.5f);
    // OpenCV counts positive angles counter-clockwise in the picture, from y to x.
    const cv::Mat turn = cv::getRotationMatrix2D(centre, -turn_deg, 1.0);
    cv::Mat turned;
    cv::warpAffine(image, turned, turn, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
    const Keypoints a = SmallExtractor().Extract(image), b = SmallExtractor().Extract(turned);
    const cv::Matx23d M = turn;
    for (std::size_t i = 0; i < a.keypoints.size(); ++i) {
      const cv::Vec2d place =
          M * cv::Vec3d(a.keypoints[i].pixel.x(), a.keypoints[i].pixel.y(), 1.0);
      const auto j = Nearest(b.keypoints, place, a.keypoints[i].octave);
      if (!j) continue;
      ++corresponding;
      alike += HammingDistance(a.descriptors[i], b.descriptors[*j]) < kMaxDescriptorDistance / 5;
      mean_angle_error_deg += AngleDifferenceDeg(
          b.keypoints[*j].angle_rad,
          a.keypoints[i].angle_rad + static_cast<float>(turn_deg * M_PI / 180.0));
    }
    mean_angle_error_deg /= std::max(1, corresponding);
  }

  static std::optional<std::size_t> Nearest(const std::vector<Keypoint>& keypoints,
                                            const cv::Vec2d& place, int octave) {
    for (std::size_t j = 0; j < keypoints.size(); ++j) {
      const Eigen::Vector2d offset =
          keypoints[j].pixel.cast<double>() - Eigen::Vector2d(place[0], place[1]);
      if (keypoints[j].octave == octave && offset.norm() < 1.0) return j;
    }
    return std::nullopt;
  }
};

TEST(PyramidScalesTest, ArePowersOfTheScale) {
  OrbExtractorOptions options;
  options.pyramid_levels = 3;
  options.pyramid_scale = 1.5;
  EXPECT_EQ(PyramidScales(options), (std::vector<float>{1.0f, 1.5f, 2.25f}));
}

TEST(OrbExtractorTest, FindsNothingWhereThereIsNothing) {
  const Keypoints none = SmallExtractor().Extract(cv::Mat(240, 320, CV_8UC1, cv::Scalar::all(90)));
  EXPECT_TRUE(none.keypoints.empty());
  EXPECT_TRUE(none.descriptors.empty());
}

TEST(OrbExtractorTest, FindsNothingInAnImageWithoutRoomForAPatch) {
  const cv::Mat tiny = Grey(SquaresImage(1))(cv::Rect(0, 0, 69, 240));
  EXPECT_TRUE(SmallExtractor().Extract(tiny).keypoints.empty());
}

TEST(OrbExtractorTest, GivesTheNumberOfFeaturesAskedFor) {
  const cv::Mat image = Grey(SquaresImage(1));
  for (const int wanted : {100, 300, 500}) {
    OrbExtractorOptions options;
    options.max_features = wanted;
    options.pyramid_levels = 4;  // more would be too small for their share
    const auto found = static_cast<int>(OrbExtractor(options).Extract(image).keypoints.size());
    EXPECT_GE(found, 0.95 * wanted);
    // The quadtree's last split gives up to two more per level.
    EXPECT_LE(found, wanted + 2 * options.pyramid_levels);
  }
}

TEST(OrbExtractorTest, KeypointsComeByOctaveAndKeepAPatchFromTheBorder) {
  const Keypoints found = SmallExtractor().Extract(Grey(SquaresImage(1)));
  ASSERT_EQ(found.keypoints.size(), found.descriptors.size());
  int octave = 0;
  for (const Keypoint& keypoint : found.keypoints) {
    EXPECT_GE(keypoint.octave, octave);
    octave = keypoint.octave;
    // The half patch of 15 px and 4 px for FAST and the blur, in pixels of the keypoint's level;
    // the far border is up to half a pixel nearer because levels have whole sizes.
    const float margin = 18.0f * SmallExtractor().scales()[octave];
    EXPECT_GE(keypoint.pixel.minCoeff(), margin);
    EXPECT_LE(keypoint.pixel.x(), 319.0f - margin);
    EXPECT_LE(keypoint.pixel.y(), 239.0f - margin);
    EXPECT_GE(keypoint.angle_rad, 0.0f);
    EXPECT_LT(keypoint.angle_rad, 6.2832f);
  }
  EXPECT_GT(octave, 3);
}

TEST(OrbExtractorTest, WeakCornersCountWhereThereAreNoStrongOnes) {
  // Left half: contrast 100. Right half: contrast 15, between the two thresholds.
  const cv::Rect left(0, 0, 160, 240);
  cv::Mat image = SquaresOfContrast(15);
  SquaresOfContrast(100)(left).copyTo(image(left));
  const auto count_right = [&](int min_fast_threshold) {
    OrbExtractorOptions options;
    options.pyramid_levels = 1;
    options.min_fast_threshold = min_fast_threshold;
    const Keypoints found = OrbExtractor(options).Extract(image);
    return std::count_if(found.keypoints.begin(), found.keypoints.end(),
                         [](const Keypoint& keypoint) { return keypoint.pixel.x() > 200.0f; });
  };
  EXPECT_GT(count_right(7), 20);
  EXPECT_EQ(count_right(20), 0);
}

TEST(OrbExtractorTest, TwiceTheSameImageGivesTheSameFeatures) {
  const cv::Mat image = Grey(SquaresImage(1));
  const Keypoints a = SmallExtractor().Extract(image), b = SmallExtractor().Extract(image);
  EXPECT_EQ(a.descriptors, b.descriptors);
  ASSERT_EQ(a.keypoints.size(), b.keypoints.size());
  for (std::size_t i = 0; i < a.keypoints.size(); ++i) {
    EXPECT_EQ(a.keypoints[i].pixel, b.keypoints[i].pixel);
    EXPECT_EQ(a.keypoints[i].angle_rad, b.keypoints[i].angle_rad);
  }
}

TEST(OrbExtractorTest, AnglesAndDescriptorsTurnWithTheImage) {
  for (const double turn_deg : {0.0, 30.0, 90.0, 200.0}) {
    const TurnedComparison turned(turn_deg);
    EXPECT_GT(turned.corresponding, 60) << turn_deg;
    // Interpolation moves some corners by a pixel; unlike patches are 128 bits apart, so that these
    // cannot be an accident.
    EXPECT_GT(turned.alike, 0.8 * turned.corresponding) << turn_deg;
    EXPECT_LT(turned.mean_angle_error_deg, 10.0) << turn_deg;  // by chance it would be 90
  }
}

TEST(OrbExtractorTest, RefusesOptionsOutOfRange) {
  OrbExtractorOptions options;
  options.min_fast_threshold = 30;  // more than fast_threshold
  EXPECT_EQ(MessageOf<ConfigError>([&] { OrbExtractor{options}; }),
            "min_fast_threshold = 30, but must be in [2, 20]");
}

}  // namespace
}  // namespace semantic_slam
