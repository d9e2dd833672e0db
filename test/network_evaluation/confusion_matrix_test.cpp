#include "semantic_slam/network_evaluation/confusion_matrix.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(ConfusionMatrixTest, CountsByRowAndColumn) {
  ConfusionMatrix matrix(2);
  matrix.Add(0, 0, 5);
  matrix.Add(0, 1);
  matrix.Add(0, matrix.none(), 2);
  matrix.Add(matrix.none(), 1, 3);
  EXPECT_EQ(matrix.count(0, 1), 1);
  EXPECT_EQ(matrix.count(1, 0), 0);
  EXPECT_EQ(matrix.TruthCount(0), 8);
  EXPECT_EQ(matrix.TruthCount(1), 0);
  EXPECT_EQ(matrix.TruthCount(matrix.none()), 3);
  EXPECT_EQ(matrix.PredictedCount(0), 5);
  EXPECT_EQ(matrix.PredictedCount(1), 4);
  EXPECT_EQ(matrix.PredictedCount(matrix.none()), 2);
}

TEST(ConfusionMatrixTest, AddsUp) {
  ConfusionMatrix one(2), other(2);
  one.Add(0, 1, 2);
  other.Add(0, 1, 3);
  other.Add(1, 1, 4);
  one.Add(other);
  EXPECT_EQ(one.count(0, 1), 5);
  EXPECT_EQ(one.count(1, 1), 4);
}

}  // namespace
}  // namespace semantic_slam
