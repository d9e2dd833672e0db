#include "semantic_slam/detection/yolo_decoder.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// A model of three classes with an input of 100 x 50.
Model ModelOf(const NetworkHead& head) {
  Model model;
  model.card.path = "card.yaml";
  model.card.labels_file = "a.names";
  model.card.input.width_px = 100;
  model.card.input.height_px = 50;
  model.card.head = head;
  model.card.head.type = HeadType::kYolo;
  model.classes = {"a", "b", "c"};
  return model;
}

Shape ShapeOf(const cv::Mat& array) {
  return {array.size.p, array.size.p + array.dims};
}

// 1 x N x columns.
cv::Mat Output(const std::vector<std::vector<float>>& rows) {
  cv::Mat output({1, static_cast<int>(rows.size()), static_cast<int>(rows[0].size())}, CV_32F);
  float* to = output.ptr<float>();
  for (const auto& row : rows) to = std::copy(row.begin(), row.end(), to);
  return output;
}

// 1 x columns x N.
cv::Mat Transposed(const cv::Mat& output) {
  const cv::Mat matrix(output.size[1], output.size[2], CV_32F, const_cast<uchar*>(output.ptr()));
  cv::Mat result({1, output.size[2], output.size[1]}, CV_32F);
  cv::Mat turned(output.size[2], output.size[1], CV_32F, result.ptr());
  cv::transpose(matrix, turned);
  return result;
}

std::vector<NetworkBox> Decode(const NetworkHead& head, const std::vector<cv::Mat>& outputs,
                               float min_confidence = 0.3f) {
  std::vector<Shape> shapes;
  for (const cv::Mat& output : outputs) shapes.push_back(ShapeOf(output));
  return YoloDecoder(ModelOf(head), shapes).Decode(outputs, min_confidence);
}

std::string ErrorOf(const NetworkHead& head, const std::vector<Shape>& shapes) {
  return MessageOf<ConfigError>([&] { YoloDecoder(ModelOf(head), shapes); });
}

void ExpectBox(const NetworkBox& actual, int class_index, float confidence, const cv::Rect2f& box) {
  EXPECT_EQ(actual.class_index, class_index);
  EXPECT_FLOAT_EQ(actual.confidence, confidence);
  EXPECT_EQ(actual.box, box);
}

TEST(YoloDecoderTest, ReadsRowsOfBoxAndScores) {
  const auto boxes =
      Decode({}, {Output({{20, 10, 8, 4, 0.1f, 0.9f, 0.2f}, {50, 25, 2, 2, 0.1f, 0.2f, 0.25f}})});
  ASSERT_EQ(boxes.size(), 1u) << "the second is below the threshold";
  ExpectBox(boxes[0], 1, 0.9f, {16, 8, 8, 4});
}

TEST(YoloDecoderTest, ReadsThemTransposed) {
  NetworkHead head;
  head.transposed = true;
  const auto boxes = Decode(
      head,
      {Transposed(Output({{20, 10, 8, 4, 0.1f, 0.9f, 0.2f}, {50, 25, 2, 2, 0.1f, 0.2f, 0.8f}}))});
  ASSERT_EQ(boxes.size(), 2u);
  ExpectBox(boxes[0], 1, 0.9f, {16, 8, 8, 4});
  ExpectBox(boxes[1], 2, 0.8f, {49, 24, 2, 2});
}

TEST(YoloDecoderTest, MultipliesASeparateObjectness) {
  NetworkHead head;
  head.objectness = Objectness::kSeparate;
  const auto boxes = Decode(head, {Output({{20, 10, 8, 4, 0.5f, 0.1f, 0.2f, 0.8f},
                                           {20, 10, 8, 4, 0.5f, 0.1f, 0.2f, 0.5f},
                                           {20, 10, 8, 4, 0.2f, 0.1f, 0.2f, 1.0f}})});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], 2, 0.4f, {16, 8, 8, 4});
}

TEST(YoloDecoderTest, LeavesAnIncludedObjectnessAlone) {
  NetworkHead head;
  head.objectness = Objectness::kIncluded;
  const auto boxes = Decode(head, {Output({{20, 10, 8, 4, 0.5f, 0.1f, 0.2f, 0.8f}})});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], 2, 0.8f, {16, 8, 8, 4});
}

TEST(YoloDecoderTest, ReadsCornersAndSharesOfTheInput) {
  NetworkHead head;
  head.box = BoxFormat::kXyxy;
  head.units = BoxUnits::kNormalised;
  const auto boxes = Decode(head, {Output({{0.25f, 0.5f, 0.5f, 1.0f, 0.9f, 0, 0}})});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], 0, 0.9f, {25, 25, 25, 25});
}

TEST(YoloDecoderTest, AppliesTheSigmoidToScoresAndObjectness) {
  NetworkHead head;
  head.activation = Activation::kSigmoid;
  head.objectness = Objectness::kSeparate;
  const auto boxes = Decode(head, {Output({{20, 10, 8, 4, 2.0f, -1.0f, 1.0f, 0.0f}})});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], 1, 1.0f / (1.0f + std::exp(-2.0f)) / (1.0f + std::exp(-1.0f)), {16, 8, 8, 4});
}

TEST(YoloDecoderTest, IgnoresWhatIsNotFinite) {
  const auto boxes = Decode({}, {Output({{20, 10, 8, 4, kNan, 0.4f, 0.2f},
                                         {20, 10, 8, 4, kNan, kNan, kNan},
                                         {kNan, 10, 8, 4, 0.9f, 0, 0},
                                         {20, 10, kInf, 4, 0.9f, 0, 0},
                                         {20, 10, 8, 0, 0.9f, 0, 0},
                                         {20, 10, -8, 4, 0.9f, 0, 0},
                                         {20, 10, 8, 4, kInf, 0, 0}})});
  ASSERT_EQ(boxes.size(), 2u);
  ExpectBox(boxes[0], 1, 0.4f, {16, 8, 8, 4});
  EXPECT_EQ(boxes[1].confidence, 1.0f) << "no confidence is above 1";
}

TEST(YoloDecoderTest, OfEqualScoresTheFirstClassWins) {
  const auto boxes = Decode({}, {Output({{20, 10, 8, 4, 0.1f, 0.5f, 0.5f}})});
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].class_index, 1);
}

TEST(YoloDecoderTest, ReadsSeveralOutputsOneAfterTheOther) {
  // As OpenCV's region layer of Darknet gives them: without a leading 1.
  NetworkHead head;
  head.objectness = Objectness::kIncluded;
  const cv::Mat first = (cv::Mat_<float>(1, 8) << 20, 10, 8, 4, 1, 0.9f, 0, 0);
  const cv::Mat second =
      (cv::Mat_<float>(2, 8) << 0, 0, 8, 4, 1, 0, 0, 0, 50, 25, 2, 2, 1, 0, 0, 0.7f);
  const auto boxes = Decode(head, {first, second});
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].class_index, 0);
  EXPECT_EQ(boxes[1].class_index, 2);
}

TEST(YoloDecoderTest, ReadsBoxesAndScoresSideBySide) {
  const auto boxes =
      Decode({}, {Output({{20, 10, 8, 4}, {50, 25, 2, 2}}), Output({{0, 0, 0}, {0, 0.6f, 0}})});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], 1, 0.6f, {49, 24, 2, 2});
}

TEST(YoloDecoderTest, ReadsRawGrids) {
  NetworkHead head;
  head.objectness = Objectness::kSeparate;
  head.activation = Activation::kSigmoid;
  head.strides = {10.0f, 50.0f};
  head.anchors = {{{8, 4}}, {{60, 30}}};
  // Ten rows of five cells at stride 10; all of it far below zero except one objectness and class.
  cv::Mat fine({1, 8, 5, 10}, CV_32F, cv::Scalar(-20)),
      coarse({1, 8, 1, 2}, CV_32F, cv::Scalar(-20));
  for (const int column : {0, 1, 2, 3}) fine.ptr<float>(0, column, 2)[3] = 0.0f;
  for (const int column : {4, 6}) fine.ptr<float>(0, column, 2)[3] = 20.0f;
  const auto boxes = Decode(head, {fine, coarse});
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0], 1, 1.0f, {31, 23, 8, 4});
}

TEST(YoloDecoderTest, RefusesShapesThatTheCardDoesNotMake) {
  EXPECT_EQ(ErrorOf({}, {{1, 100, 8}}),
            "card.yaml: the network gives 1 x 100 x 8, but the card's head with the 3 classes in "
            "a.names makes 7 columns per box");
  NetworkHead transposed;
  transposed.transposed = true;
  ExpectOneLineWith(ErrorOf(transposed, {{1, 100, 7}}), {"makes 7 columns per box, transposed"});
  EXPECT_EQ(ErrorOf(transposed, {{1, 7, 100}}), "");
  for (const std::vector<Shape>& shapes :
       {std::vector<Shape>{}, {{}}, {{7}}, {{2, 100, 7}}, {{1, 100, 7}, {1, 100, 6}}}) {
    EXPECT_NE(ErrorOf({}, shapes), "") << ToString(shapes);
  }
  NetworkHead grids;
  grids.strides = {8.0f};
  grids.anchors = {{{8, 4}}};
  EXPECT_NE(ErrorOf(grids, {{1, 100, 7}}), "");
  EXPECT_NE(ErrorOf(grids, {{1, 7, 5, 5}, {1, 7, 5, 5}}), "") << "one grid, two outputs";
}

}  // namespace
}  // namespace semantic_slam
