#include "semantic_slam/network_evaluation/report_json.h"

#include <limits>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(ReportJsonTest, NoNumberIsNull) {
  EXPECT_TRUE(NumberOrNull(std::numeric_limits<double>::quiet_NaN()).is_null());
  EXPECT_EQ(NumberOrNull(0.25), 0.25);
}

TEST(ReportJsonTest, ConfusionIsRowsOfTruth) {
  ConfusionMatrix matrix(1);
  matrix.Add(0, 1, 7);
  EXPECT_EQ(ToJson(matrix, {"chair"}, "other").dump(),
            R"({"names":["chair","other"],"counts":[[0,7],[0,0]]})");
}

TEST(ReportJsonTest, TimeIsPerImage) {
  EXPECT_EQ(ToJson(StageTiming{"x", 3, 1.5, 2.5}).dump(),
            R"({"images":3,"median_ms":1.5,"p95_ms":2.5})");
}

}  // namespace
}  // namespace semantic_slam
