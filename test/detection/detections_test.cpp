#include "semantic_slam/detection/detections.h"

#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Detections Good() {
  Detections detections;
  detections.vocabulary_hash = Vocabulary().hash();
  detections.image_size = {640, 480};
  detections.boxes.push_back({LabelOf("chair"), 0.5f, {-10.0f, 5.0f, 700.0f, 20.0f}});
  return detections;
}

std::string ErrorOf(const Detections& detections) {
  return MessageOf<InputError>([&] { CheckDetections(detections, Vocabulary()); });
}

TEST(CheckDetectionsTest, TakesGoodOnesAndNone) {
  EXPECT_EQ(ErrorOf(Good()), "") << "boxes may reach beyond the image";
  Detections none = Good();
  none.boxes.clear();
  EXPECT_EQ(ErrorOf(none), "");
}

TEST(CheckDetectionsTest, RefusesAnotherVocabulary) {
  Detections detections = Good();
  detections.vocabulary_hash = 5;
  EXPECT_EQ(ErrorOf(detections), "detections: made with another label set, hash 5, expected " +
                                     std::to_string(Vocabulary().hash()));
}

TEST(CheckDetectionsTest, RefusesUnknownIds) {
  Detections detections = Good();
  detections.boxes[0].label = 200;
  EXPECT_EQ(ErrorOf(detections), "detections: label id 200 is not in the vocabulary");
}

TEST(CheckDetectionsTest, RefusesConfidencesThatAreNone) {
  for (const float confidence : {-0.1f, 1.1f, kNan}) {
    Detections detections = Good();
    detections.boxes[0].confidence = confidence;
    ExpectOneLineWith(ErrorOf(detections), {"detections: confidence is ", "expected 0 to 1"});
  }
}

TEST(CheckDetectionsTest, RefusesBoxesThatAreNone) {
  const float inf = std::numeric_limits<float>::infinity();
  for (const cv::Rect2f& box : {cv::Rect2f(0, 0, 0, 5), cv::Rect2f(0, 0, 5, -1),
                                cv::Rect2f(kNan, 0, 5, 5), cv::Rect2f(0, 0, inf, 5)}) {
    Detections detections = Good();
    detections.boxes[0].box = box;
    EXPECT_EQ(ErrorOf(detections), "detections: a box is empty or not finite");
  }
}

}  // namespace
}  // namespace semantic_slam
