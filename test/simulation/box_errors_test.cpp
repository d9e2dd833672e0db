#include "semantic_slam/simulation/box_errors.h"

#include <cmath>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr int kBoxes = 200;
constexpr int kImages = 20;

const LabelVocabulary& Vocabulary() {
  static const LabelVocabulary vocabulary =
      LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  return vocabulary;
}

// Chairs of 100 x 50 px in the middle of the image.
Detections Chairs(Stamp stamp) {
  const DetectedBox chair{*Vocabulary().Find("chair"), 1.0f, cv::Rect2f(200, 200, 100, 50)};
  return {stamp, Vocabulary().hash(), {640, 480}, std::vector<DetectedBox>(kBoxes, chair)};
}

BoxErrorOptions WithoutErrors() {
  BoxErrorOptions options;
  options.miss_probability = 0.0;
  options.false_positives_per_image = 0.0;
  options.confusion_probability = 0.0;
  options.jitter_px = 0.0;
  options.jitter_share = 0.0;
  return options;
}

std::vector<DetectedBox> FoundInManyImages(const BoxErrorOptions& options) {
  const BoxErrors errors(options, Vocabulary());
  std::vector<DetectedBox> all;
  for (int i = 1; i <= kImages; ++i) {
    const auto found = errors.Apply(Chairs(Stamp{i})).boxes;
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

// Four standard deviations of a share of all boxes.
double Tolerance(double share) {
  return 4.0 * std::sqrt(share * (1.0 - share) / (kBoxes * kImages));
}

TEST(BoxErrorsTest, WithoutErrorsTheBoxesAreTheTruth) {
  const Detections truth = Chairs(Stamp{7});
  const Detections found = BoxErrors(WithoutErrors(), Vocabulary()).Apply(truth);
  EXPECT_EQ(found.stamp, Stamp{7});
  EXPECT_EQ(found.image_size, truth.image_size);
  ASSERT_EQ(found.boxes.size(), truth.boxes.size());
  EXPECT_EQ(found.boxes[3].label, truth.boxes[3].label);
  EXPECT_EQ(found.boxes[3].box, truth.boxes[3].box);
}

TEST(BoxErrorsTest, GivesDetectionsByDescendingConfidence) {
  const Detections found = BoxErrors(BoxErrorOptions(), Vocabulary()).Apply(Chairs(Stamp{7}));
  EXPECT_NO_THROW(CheckDetections(found, Vocabulary()));
  for (std::size_t i = 1; i < found.boxes.size(); ++i) {
    EXPECT_GE(found.boxes[i - 1].confidence, found.boxes[i].confidence);
  }
}

TEST(BoxErrorsTest, MissesTheStatedShare) {
  BoxErrorOptions options = WithoutErrors();
  options.miss_probability = 0.3;
  const double found = static_cast<double>(FoundInManyImages(options).size()) / (kBoxes * kImages);
  EXPECT_NEAR(found, 0.7, Tolerance(0.3));
}

TEST(BoxErrorsTest, ConfusesTheStatedShareAndIsLessSureOfThem) {
  BoxErrorOptions options = WithoutErrors();
  options.confusion_probability = 0.2;
  options.confidence_spread = 0.0;
  int confused = 0;
  for (const DetectedBox& box : FoundInManyImages(options)) {
    if (box.label == *Vocabulary().Find("chair")) continue;
    ++confused;
    EXPECT_LT(box.confidence, options.mean_confidence);
  }
  EXPECT_NEAR(static_cast<double>(confused) / (kBoxes * kImages), 0.2, Tolerance(0.2));
}

TEST(BoxErrorsTest, JitterIsOfTheStatedSize) {
  BoxErrorOptions options = WithoutErrors();
  options.jitter_px = 3.0;
  options.jitter_share = 0.04;
  double squares = 0.0;
  const std::vector<DetectedBox> found = FoundInManyImages(options);
  for (const DetectedBox& box : found) squares += std::pow(box.box.x - 200.0, 2);
  const double expected = 3.0 * 3.0 + 4.0 * 4.0;  // 0.04 of 100 px is 4 px
  // Four standard deviations of a variance.
  EXPECT_NEAR(squares / found.size(), expected, 4.0 * expected * std::sqrt(2.0 / found.size()));
}

TEST(BoxErrorsTest, InventsTheStatedNumberInsideTheImage) {
  BoxErrorOptions options = WithoutErrors();
  options.false_positives_per_image = 1.5;
  const BoxErrors errors(options, Vocabulary());
  constexpr int kEmptyImages = 2000;
  std::size_t invented = 0;
  for (int i = 1; i <= kEmptyImages; ++i) {
    const Detections found = errors.Apply({Stamp{i}, Vocabulary().hash(), {640, 480}, {}});
    invented += found.boxes.size();
    for (const DetectedBox& box : found.boxes) {
      EXPECT_GE(box.box.x, -0.5f);
      EXPECT_LE(box.box.x + box.box.width, 639.5f + 1e-3f);  // rounding of a float
      EXPECT_GT(box.box.height, 0.0f);
    }
  }
  EXPECT_NEAR(static_cast<double>(invented) / kEmptyImages, 1.5,
              4.0 * std::sqrt(1.5 / kEmptyImages));
}

TEST(BoxErrorsTest, BoxesStayInTheImage) {
  BoxErrorOptions options = WithoutErrors();
  options.jitter_px = 20.0;
  Detections truth = Chairs(Stamp{3});
  for (DetectedBox& box : truth.boxes) box.box = cv::Rect2f(-0.5f, 400.0f, 30.0f, 79.5f);
  const Detections found = BoxErrors(options, Vocabulary()).Apply(truth);
  ASSERT_FALSE(found.boxes.empty());
  for (const DetectedBox& box : found.boxes) {
    EXPECT_GE(box.box.x, -0.5f);
    EXPECT_LE(box.box.y + box.box.height, 479.5f);
    EXPECT_GE(box.box.width, 1.0f);
  }
}

TEST(BoxErrorsTest, SameStampSameBoxes) {
  const BoxErrors errors(BoxErrorOptions(), Vocabulary());
  const auto once = errors.Apply(Chairs(Stamp{7})), again = errors.Apply(Chairs(Stamp{7}));
  const auto later = errors.Apply(Chairs(Stamp{8}));
  ASSERT_EQ(once.boxes.size(), again.boxes.size());
  for (std::size_t i = 0; i < once.boxes.size(); ++i) {
    EXPECT_EQ(once.boxes[i].box, again.boxes[i].box);
    EXPECT_EQ(once.boxes[i].confidence, again.boxes[i].confidence);
  }
  EXPECT_NE(once.boxes[0].box, later.boxes[0].box);
}

TEST(BoxErrorsTest, RefusesOptionsOutOfRange) {
  BoxErrorOptions options;
  options.miss_probability = 1.5;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { BoxErrors(options, Vocabulary()); }),
                    {"miss_probability = 1.5"});
}

}  // namespace
}  // namespace semantic_slam
