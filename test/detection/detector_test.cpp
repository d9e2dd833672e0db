#include "semantic_slam/detection/detector.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

const cv::Scalar kRed(0, 0, 255), kBlue(255, 0, 0);  // BGR
constexpr Stamp kStamp{123};

// Grey, 640 x 480: ten times the network's input, so that a cell of its grid is 80 px wide.
cv::Mat GreyImage() {
  return cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90));
}

cv::Rect CellAt(int column, int row) {
  return {80 * column, 80 * row, 80, 80};
}

// The same network with boxes of five cells' width.
Model WideBlockDetector(const TemporaryFolder& folder) {
  Model model = BlockDetector();
  std::ifstream file(model.network_path);
  std::string network((std::istreambuf_iterator<char>(file)), {});
  const std::string anchors = "anchors=8,8";
  network.replace(network.find(anchors), anchors.size(), "anchors=40,40");
  model.network_path = folder.Write("wide_block_detector.cfg", network);
  return model;
}

std::string ErrorOf(const Model& model, const DetectorOptions& options = {}) {
  return MessageOf<ConfigError>([&] { Detector(model, Vocabulary(), {}, options); });
}

void ExpectBox(const DetectedBox& found, const cv::Rect2f& expected) {
  constexpr double kTolerancePx = 1e-3;  // the network's and our single precision at 640 px
  EXPECT_NEAR(found.box.x, expected.x, kTolerancePx);
  EXPECT_NEAR(found.box.y, expected.y, kTolerancePx);
  EXPECT_NEAR(found.box.width, expected.width, kTolerancePx);
  EXPECT_NEAR(found.box.height, expected.height, kTolerancePx);
}

TEST(DetectorTest, FindsObjectsWhereTheyAre) {
  Detector detector(BlockDetector(), Vocabulary(), {}, {});
  cv::Mat image = GreyImage();
  image(CellAt(2, 3)) = kRed;
  image(CellAt(5, 1)) = kBlue;
  const Detections found = detector.Detect(image, ColourOrder::kBgr, kStamp);
  EXPECT_EQ(found.stamp, kStamp);
  EXPECT_EQ(found.image_size, cv::Size(640, 480));
  EXPECT_NO_THROW(CheckDetections(found, Vocabulary()));
  ASSERT_EQ(found.boxes.size(), 2u);
  const bool red_first = found.boxes[0].label == LabelOf("chair");
  const DetectedBox &red = found.boxes[red_first ? 0 : 1], &blue = found.boxes[red_first ? 1 : 0];
  EXPECT_EQ(red.label, LabelOf("chair"));
  EXPECT_EQ(blue.label, LabelOf("tv"));
  EXPECT_GT(red.confidence, 0.9f);
  // Edges of pixels lie half a pixel before their centres.
  ExpectBox(red, {159.5f, 239.5f, 80.0f, 80.0f});
  ExpectBox(blue, {399.5f, 79.5f, 80.0f, 80.0f});
}

TEST(DetectorTest, FindsNothingWhereThereIsNothing) {
  Detector detector(BlockDetector(), Vocabulary(), {}, {});
  EXPECT_TRUE(detector.Detect(GreyImage(), ColourOrder::kBgr, kStamp).boxes.empty());
}

TEST(DetectorTest, TakesEitherChannelOrder) {
  Detector detector(BlockDetector(), Vocabulary(), {}, {});
  cv::Mat image = GreyImage();
  image(CellAt(2, 3)) = kRed;
  const Detections found = detector.Detect(image, ColourOrder::kRgb, kStamp);
  ASSERT_EQ(found.boxes.size(), 1u);
  EXPECT_EQ(found.boxes[0].label, LabelOf("tv"));
}

TEST(DetectorTest, CutsBoxesAtTheImagesEdges) {
  const TemporaryFolder folder;
  Detector detector(WideBlockDetector(folder), Vocabulary(), {}, {});
  cv::Mat image = GreyImage();
  image(CellAt(0, 0)) = kRed;
  const Detections found = detector.Detect(image, ColourOrder::kBgr, kStamp);
  ASSERT_EQ(found.boxes.size(), 1u);
  // 400 px about the middle of the first cell, at 39.5 px.
  ExpectBox(found.boxes[0], {-0.5f, -0.5f, 240.0f, 240.0f});
}

TEST(DetectorTest, TwoClassesOfOneLabelAreOneObject) {
  const TemporaryFolder folder;
  Model model = WideBlockDetector(folder);
  cv::Mat image = GreyImage();
  image(CellAt(3, 3)) = kRed;
  image(CellAt(4, 3)) = kBlue;
  // The boxes of neighbouring cells share two thirds of their union.
  const Detections apart =
      Detector(model, Vocabulary(), {}, {}).Detect(image, ColourOrder::kBgr, kStamp);
  EXPECT_EQ(apart.boxes.size(), 2u) << "of two labels, so two objects";
  model.card.label_map = {{"red block", "tv"}, {"blue block", "tv"}};
  const Detections together =
      Detector(model, Vocabulary(), {}, {}).Detect(image, ColourOrder::kBgr, kStamp);
  ASSERT_EQ(together.boxes.size(), 1u);
  EXPECT_EQ(together.boxes[0].label, LabelOf("tv"));
}

TEST(DetectorTest, CallsAClassWithoutALabelUnknown) {
  Model model = BlockDetector();
  model.card.label_map.clear();
  cv::Mat image = GreyImage();
  image(CellAt(3, 3)) = kRed;
  const Detections found =
      Detector(model, Vocabulary(), {}, {}).Detect(image, ColourOrder::kBgr, kStamp);
  ASSERT_EQ(found.boxes.size(), 1u);
  EXPECT_EQ(found.boxes[0].label, kUnknownLabel);
}

TEST(DetectorTest, KeepsTheSurest) {
  DetectorOptions options;
  options.max_detections = 1;
  options.min_confidence = 0.1;
  Detector detector(BlockDetector(), Vocabulary(), {}, options);
  cv::Mat image = GreyImage();
  image(CellAt(2, 3)) = cv::Scalar(0, 0, 190);
  image(CellAt(5, 1)) = kBlue;
  const Detections found = detector.Detect(image, ColourOrder::kBgr, kStamp);
  ASSERT_EQ(found.boxes.size(), 1u);
  EXPECT_EQ(found.boxes[0].label, LabelOf("tv"));
}

TEST(DetectorTest, RefusesImagesThatAreNone) {
  Detector detector(BlockDetector(), Vocabulary(), {}, {});
  EXPECT_THROW(detector.Detect({}, ColourOrder::kBgr, kStamp), InputError);
  EXPECT_THROW(detector.Detect(cv::Mat(4, 4, CV_8UC1), ColourOrder::kBgr, kStamp), InputError);
}

TEST(DetectorTest, RefusesANetworkThatDoesNotFitItsCard) {
  Model model = BlockDetector();
  model.classes.push_back("green block");
  ExpectOneLineWith(ErrorOf(model), {"block_detector.yaml: the network gives 48 x 7, but",
                                     "makes 8 columns per box"});
  ExpectOneLineWith(ErrorOf(ColourSegmenter()), {"head/type is neither yolo nor ssd"});
}

TEST(DetectorTest, RefusesOptionsOutOfRange) {
  DetectorOptions options;
  options.max_overlap = 1.5;
  EXPECT_EQ(ErrorOf(BlockDetector(), options), "max_overlap = 1.5, but must be in [0, 1]");
}

}  // namespace
}  // namespace semantic_slam
