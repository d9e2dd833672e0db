#include "semantic_slam/network_evaluation/detection_report.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace semantic_slam {
namespace {

class DetectionReportTest : public ::testing::Test {
 protected:
  DetectionReportTest() {
    const cv::Rect2f box(0.0f, 0.0f, 10.0f, 10.0f);
    evaluation_.score.Add({{0, 1.0f, box}, {0, 1.0f, box}}, {{0, 0.9f, box}});
    evaluation_.confusion.Add(0, 0);
    evaluation_.confusion.Add(0, 2);
    evaluation_.timing = {"detection", 1, 12.5, 20.25};
    classes_.Add("chair", 5);
    classes_.Add("table", 7);
  }

  ClassList classes_;
  DetectionEvaluation evaluation_{2, 0.25};
};

TEST_F(DetectionReportTest, JsonHasNullForWhatThereIsNot) {
  const auto json = ToJson(evaluation_, classes_);
  EXPECT_EQ(json["boxes"], 2);
  EXPECT_EQ(json["map50"], 0.5);
  EXPECT_EQ(json["at_threshold"]["threshold"], 0.25);
  EXPECT_EQ(json["at_threshold"]["precision"], 1.0);
  EXPECT_EQ(json["at_threshold"]["recall"], 0.5);
  EXPECT_EQ(json["at_best_f1"]["hits"], 1);
  EXPECT_EQ(json["classes"]["chair"]["ap50"], 0.5);
  EXPECT_TRUE(json["classes"]["table"]["ap50"].is_null());
  EXPECT_EQ(json["confusion"]["names"][2], "background");
  EXPECT_EQ(json["time"]["p95_ms"], 20.25);
}

TEST_F(DetectionReportTest, WithoutFindingsThereIsNoBestThreshold) {
  EXPECT_TRUE(ToJson(DetectionEvaluation(2, 0.25), classes_)["at_best_f1"].is_null());
}

TEST_F(DetectionReportTest, TableHasADashForIt) {
  std::ostringstream out;
  PrintTable(evaluation_, classes_, out);
  const std::string text = out.str();
  EXPECT_NE(text.find("mAP@0.5                       50.0 %\n"), std::string::npos) << text;
  std::istringstream table(text.substr(text.find("  table")));
  std::string word, words;
  while (table >> word) words += word + " ";
  EXPECT_EQ(words, "table - - - - - 0 ");
}

}  // namespace
}  // namespace semantic_slam
