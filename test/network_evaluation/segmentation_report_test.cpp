#include "semantic_slam/network_evaluation/segmentation_report.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace semantic_slam {
namespace {

class SegmentationReportTest : public ::testing::Test {
 protected:
  SegmentationReportTest() {
    classes_.Add("chair", 5);
    classes_.Add("table", 7);
    evaluation_.confusion.Add(0, 0, 3);
    evaluation_.confusion.Add(0, 2, 1);
    evaluation_.timing = {"segmentation", 2, 12.5, 20.25};
  }

  ClassList classes_;
  SegmentationEvaluation evaluation_{2};
};

TEST_F(SegmentationReportTest, JsonHasNullForWhatThereIsNot) {
  const auto json = ToJson(evaluation_, classes_);
  EXPECT_EQ(json["pixels"], 4);
  EXPECT_EQ(json["pixel_accuracy"], 0.75);
  EXPECT_EQ(json["classes"]["chair"]["iou"], 0.75);
  EXPECT_EQ(json["classes"]["chair"]["precision"], 1.0);
  EXPECT_TRUE(json["classes"]["table"]["iou"].is_null());
  EXPECT_EQ(json["classes"]["table"]["pixel_share"], 0.0);
  EXPECT_EQ(json["confusion"]["names"], (std::vector<std::string>{"chair", "table", "other"}));
  EXPECT_EQ(json["confusion"]["counts"][0], (std::vector<int>{3, 0, 1}));
  EXPECT_EQ(json["time"]["median_ms"], 12.5);
}

TEST_F(SegmentationReportTest, TableHasADashForIt) {
  std::ostringstream out;
  PrintTable(evaluation_, classes_, out);
  const std::string text = out.str();
  EXPECT_NE(text.find("pixel accuracy                75.0 %\n"), std::string::npos) << text;
  std::istringstream table(text.substr(text.find("  table")));
  std::string word, words;
  while (table >> word) words += word + " ";
  EXPECT_EQ(words, "table - - - 0.0 % ");
}

}  // namespace
}  // namespace semantic_slam
