#include "semantic_slam/detection/ssd_decoder.h"

#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

Model ModelOf(BoxUnits units) {
  Model model;
  model.card.path = "card.yaml";
  model.card.input.width_px = 100;
  model.card.input.height_px = 50;
  model.card.head.type = HeadType::kSsd;
  model.card.head.units = units;
  model.classes = {"background", "a", "b"};
  return model;
}

cv::Mat Output(const std::vector<std::vector<float>>& rows) {
  cv::Mat output({1, 1, static_cast<int>(rows.size()), 7}, CV_32F);
  float* to = output.ptr<float>();
  for (const auto& row : rows) to = std::copy(row.begin(), row.end(), to);
  return output;
}

TEST(SsdDecoderTest, ReadsRowsAndSkipsBackgroundAndFaintOnes) {
  const SsdDecoder decoder(ModelOf(BoxUnits::kNormalised), {{1, 1, 100, 7}});
  const auto boxes = decoder.Decode({Output({{0, 2, 0.9f, 0.25f, 0.5f, 0.5f, 1.0f},
                                             {0, 0, 0.9f, 0.25f, 0.5f, 0.5f, 1.0f},
                                             {0, 1, 0.2f, 0.25f, 0.5f, 0.5f, 1.0f}})},
                                    0.3f);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].class_index, 2);
  EXPECT_FLOAT_EQ(boxes[0].confidence, 0.9f);
  EXPECT_EQ(boxes[0].box, cv::Rect2f(25, 25, 25, 25));
}

TEST(SsdDecoderTest, ReadsPixels) {
  const SsdDecoder decoder(ModelOf(BoxUnits::kPixels), {{1, 1, 1, 7}});
  const auto boxes = decoder.Decode({Output({{0, 1, 0.9f, 1, 2, 4, 8}})}, 0.3f);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_EQ(boxes[0].box, cv::Rect2f(1, 2, 3, 6));
}

TEST(SsdDecoderTest, IgnoresWhatIsNoBox) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const SsdDecoder decoder(ModelOf(BoxUnits::kPixels), {{1, 1, 1, 7}});
  const cv::Mat output = Output({{0, 1, nan, 1, 2, 4, 8},
                                 {0, nan, 0.9f, 1, 2, 4, 8},
                                 {0, 3, 0.9f, 1, 2, 4, 8},
                                 {0, -1, 0.9f, 1, 2, 4, 8},
                                 {0, 1, 0.9f, nan, 2, 4, 8},
                                 {0, 1, 0.9f, 4, 2, 1, 8}});
  EXPECT_TRUE(decoder.Decode({output}, 0.3f).empty());
}

TEST(SsdDecoderTest, RefusesAnotherShape) {
  const auto error_of = [](const std::vector<Shape>& shapes) {
    return MessageOf<ConfigError>([&] { SsdDecoder(ModelOf(BoxUnits::kPixels), shapes); });
  };
  EXPECT_EQ(error_of({{1, 1, 100, 6}}),
            "card.yaml: the network gives 1 x 1 x 100 x 6, expected one output of 1 x 1 x N x 7");
  EXPECT_NE(error_of({}), "");
  EXPECT_NE(error_of({{1, 1, 1, 7}, {1, 1, 1, 7}}), "");
}

}  // namespace
}  // namespace semantic_slam
