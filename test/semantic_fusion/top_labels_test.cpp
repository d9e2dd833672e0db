#include "semantic_slam/semantic_fusion/top_labels.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(TopLabelsTest, KeepsTheThreeHeaviest) {
  TopLabels<int> top;
  for (const auto& [label, weight] :
       {std::pair<LabelId, int>{200, 5}, {9, 20}, {7, 35}, {3, 20}, {4, 0}}) {
    top.Offer(label, weight);
  }
  EXPECT_EQ(top.labels(), (std::array<LabelId, 3>{7, 3, 9}));
  EXPECT_EQ(top.weights(), (std::array<int, 3>{35, 20, 20}));
}

TEST(TopLabelsTest, WhatWeighsNothingIsNone) {
  TopLabels<float> top;
  top.Offer(3, 0.0f);
  top.Offer(8, 0.5f);
  EXPECT_EQ(top.labels(), (std::array<LabelId, 3>{8, 0, 0}));
}

}  // namespace
}  // namespace semantic_slam
