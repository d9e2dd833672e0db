#include "semantic_slam/detection/box_decoder.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/detection/ssd_decoder.h"
#include "semantic_slam/detection/yolo_decoder.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

TEST(MakeBoxDecoderTest, GoesByTheHead) {
  Model model;
  model.card.path = "card.yaml";
  model.classes = {"a", "b", "c"};
  const std::vector<Shape> rows{{1, 1, 10, 7}};
  model.card.head.type = HeadType::kYolo;
  EXPECT_NE(dynamic_cast<YoloDecoder*>(MakeBoxDecoder(model, rows).get()), nullptr);
  model.card.head.type = HeadType::kSsd;
  EXPECT_NE(dynamic_cast<SsdDecoder*>(MakeBoxDecoder(model, rows).get()), nullptr);
  model.card.head.type = HeadType::kSegmentation;
  EXPECT_EQ(MessageOf<ConfigError>([&] { MakeBoxDecoder(model, rows); }),
            "card.yaml: head/type is neither yolo nor ssd");
}

}  // namespace
}  // namespace semantic_slam
