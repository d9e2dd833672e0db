#include "semantic_slam/detection/detection_overlay.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

cv::Mat Black() {
  return cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(0));
}

Detections DetectionsOf(const std::vector<DetectedBox>& boxes) {
  Detections detections;
  detections.vocabulary_hash = Vocabulary().hash();
  detections.image_size = {160, 120};
  detections.boxes = boxes;
  return detections;
}

cv::Vec3b ColourOfLabel(const std::string& name, bool rgb) {
  const auto colour = Vocabulary()[LabelOf(name)].rgb;
  return rgb ? cv::Vec3b(colour[0], colour[1], colour[2])
             : cv::Vec3b(colour[2], colour[1], colour[0]);
}

TEST(DrawDetectionsTest, DrawsBoxesInTheColoursOfTheirLabels) {
  const Detections one = DetectionsOf({{LabelOf("chair"), 0.5f, {19.5f, 39.5f, 100.0f, 60.0f}}});
  const cv::Mat image = Black();
  for (const bool rgb : {true, false}) {
    const cv::Mat picture =
        DrawDetections(image, rgb ? ColourOrder::kRgb : ColourOrder::kBgr, one, Vocabulary());
    EXPECT_EQ(picture.at<cv::Vec3b>(70, 20), ColourOfLabel("chair", rgb)) << "left edge";
    EXPECT_EQ(picture.at<cv::Vec3b>(99, 70), ColourOfLabel("chair", rgb)) << "lower edge";
    EXPECT_EQ(picture.at<cv::Vec3b>(70, 70), cv::Vec3b::all(0)) << "inside";
    EXPECT_EQ(picture.at<cv::Vec3b>(30, 21), ColourOfLabel("chair", rgb)) << "the tag above";
  }
  EXPECT_EQ(image.at<cv::Vec3b>(70, 20), cv::Vec3b::all(0)) << "the image is not drawn on";
}

TEST(DrawDetectionsTest, TheSurestIsOnTop) {
  const cv::Rect2f box(19.5f, 39.5f, 100.0f, 60.0f);
  const Detections two = DetectionsOf({{LabelOf("chair"), 0.9f, box}, {LabelOf("tv"), 0.3f, box}});
  EXPECT_EQ(DrawDetections(Black(), ColourOrder::kRgb, two, Vocabulary()).at<cv::Vec3b>(70, 20),
            ColourOfLabel("chair", true));
}

TEST(DrawDetectionsTest, BoxesMayReachBeyondTheImage) {
  const Detections off = DetectionsOf({{LabelOf("chair"), 0.9f, {-50.0f, -1e9f, 2e9f, 2e9f}},
                                       {LabelOf("tv"), 0.3f, {500.0f, 500.0f, 10.0f, 10.0f}}});
  EXPECT_EQ(DrawDetections(Black(), ColourOrder::kRgb, off, Vocabulary()).size(),
            cv::Size(160, 120));
}

TEST(DrawDetectionsTest, RefusesWhatItCannotDraw) {
  const auto draw = [](const cv::Mat& image, const Detections& detections) {
    DrawDetections(image, ColourOrder::kRgb, detections, Vocabulary());
  };
  EXPECT_THROW(draw(cv::Mat(), DetectionsOf({})), InputError);
  EXPECT_THROW(draw(cv::Mat(10, 10, CV_8UC1), DetectionsOf({})), InputError);
  EXPECT_THROW(draw(Black(), Detections()), InputError);
}

}  // namespace
}  // namespace semantic_slam
