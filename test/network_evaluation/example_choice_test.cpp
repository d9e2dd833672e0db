#include "semantic_slam/network_evaluation/example_choice.h"

#include <limits>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<std::size_t> Chosen(const std::vector<double>& scores) {
  std::vector<std::size_t> indices;
  for (const Example& example : ChooseExamples(scores)) indices.push_back(example.index);
  return indices;
}

TEST(ExampleChoiceTest, TakesBestMedianAndWorst) {
  const std::vector<Example> examples = ChooseExamples({0.5, kNone, 0.9, 0.1, 0.6, 0.2});
  ASSERT_EQ(examples.size(), 3u);
  EXPECT_EQ(examples[0].name, "best");
  EXPECT_EQ(examples[0].index, 2u);
  EXPECT_EQ(examples[0].score, 0.9);
  EXPECT_EQ(examples[1].name, "median");
  EXPECT_EQ(examples[1].index, 0u);
  EXPECT_EQ(examples[2].name, "worst");
  EXPECT_EQ(examples[2].index, 3u);
}

TEST(ExampleChoiceTest, NoneTwiceAndOfEqualOnesTheEarliest) {
  EXPECT_EQ(Chosen({0.4}), (std::vector<std::size_t>{0}));
  EXPECT_EQ(Chosen({0.4, 0.9}), (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(Chosen({0.1, 0.9, 0.1, 0.1}), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(ExampleChoiceTest, NoScoresNoExamples) {
  EXPECT_TRUE(ChooseExamples({}).empty());
  EXPECT_TRUE(ChooseExamples({kNone}).empty());
}

}  // namespace
}  // namespace semantic_slam
