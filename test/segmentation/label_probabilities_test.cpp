#include "semantic_slam/segmentation/label_probabilities.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// 1 x K x 1 x w, from one list of K scores per cell.
cv::Mat Scores(const std::vector<std::vector<float>>& cells) {
  const int classes = static_cast<int>(cells[0].size()), width = static_cast<int>(cells.size());
  cv::Mat scores({1, classes, 1, width}, CV_32F);
  for (int k = 0; k < classes; ++k) {
    for (int x = 0; x < width; ++x) scores.ptr<float>(0, k, 0)[x] = cells[x][k];
  }
  return scores;
}

// The probability of each label in a cell, in the order of the labels.
std::vector<float> CellOf(const LabelProbabilities& probabilities, int x) {
  const float* cell = probabilities.Cell(x, 0);
  return {cell, cell + probabilities.labels.size()};
}

void ExpectNear(const std::vector<float>& actual, const std::vector<float>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_NEAR(actual[i], expected[i], 1e-6) << i;  // single precision
  }
}

TEST(ClassScoresTest, IsTheSoftmaxOfEquation315) {
  ClassScores scores({1, 2, 3}, Vocabulary(), Activation::kSoftmax);
  const LabelProbabilities& found = scores.ToProbabilities(Scores({{1, 2, 3}, {0, 0, 0}}));
  EXPECT_EQ(found.labels, (std::vector<LabelId>{0, 1, 2, 3}));
  const double sum = std::exp(1.0) + std::exp(2.0) + std::exp(3.0);
  ExpectNear(CellOf(found, 0),
             {0.0f, static_cast<float>(std::exp(1.0) / sum),
              static_cast<float>(std::exp(2.0) / sum), static_cast<float>(std::exp(3.0) / sum)});
  ExpectNear(CellOf(found, 1), {0.0f, 1.0f / 3, 1.0f / 3, 1.0f / 3});
}

TEST(ClassScoresTest, SurvivesScoresFarApartAndLarge) {
  ClassScores scores({1, 2}, Vocabulary(), Activation::kSoftmax);
  const LabelProbabilities& found =
      scores.ToProbabilities(Scores({{1e30f, -1e30f}, {30000.0f, 30000.0f}}));
  ExpectNear(CellOf(found, 0), {0.0f, 1.0f, 0.0f});
  ExpectNear(CellOf(found, 1), {0.0f, 0.5f, 0.5f});
}

TEST(ClassScoresTest, SumsTheClassesOfOneLabel) {
  ClassScores scores({5, 0, 5, 2}, Vocabulary(), Activation::kNone);
  const LabelProbabilities& found = scores.ToProbabilities(Scores({{0.125f, 0.25f, 0.5f, 0.125f}}));
  EXPECT_EQ(found.labels, (std::vector<LabelId>{0, 2, 5}));
  ExpectNear(CellOf(found, 0), {0.25f, 0.125f, 0.625f});
}

TEST(ClassScoresTest, TakesProbabilitiesAsTheyAre) {
  ClassScores scores({1, 2}, Vocabulary(), Activation::kNone);
  const LabelProbabilities& found = scores.ToProbabilities(Scores({{0.2f, 0.7f}, {-1.0f, 9.0f}}));
  ExpectNear(CellOf(found, 0), {0.0f, 0.2f, 0.7f});
  ExpectNear(CellOf(found, 1), {0.0f, 0.0f, 1.0f});
}

TEST(ClassScoresTest, ACellWithAScoreThatIsNotFiniteIsUnknown) {
  for (const Activation activation : {Activation::kSoftmax, Activation::kNone}) {
    ClassScores scores({1, 2}, Vocabulary(), activation);
    const LabelProbabilities& found = scores.ToProbabilities(
        Scores({{kNan, 0.5f}, {0.5f, kNan}, {kInf, 0.5f}, {0.5f, -kInf}, {0.5f, 0.5f}}));
    for (int x = 0; x < 4; ++x) ExpectNear(CellOf(found, x), {1.0f, 0.0f, 0.0f});
    ExpectNear(CellOf(found, 4), {0.0f, 0.5f, 0.5f});
  }
}

TEST(ClassScoresTest, KnowsAtLeastThreeLabelsUnknownAmongThem) {
  ClassScores scores({200, 200}, LabelVocabulary({{0, "unknown"}, {9, "a"}, {200, "b"}}),
                     Activation::kSoftmax);
  const LabelProbabilities& found = scores.ToProbabilities(Scores({{0, 0}}));
  EXPECT_EQ(found.labels, (std::vector<LabelId>{0, 9, 200}));
  ExpectNear(CellOf(found, 0), {0.0f, 0.0f, 1.0f});
}

TEST(ClassScoresTest, RefusesAVocabularyWithoutThree) {
  const LabelVocabulary two({{0, "unknown"}, {1, "a"}});
  EXPECT_EQ(MessageOf<ConfigError>([&] { ClassScores({1}, two, Activation::kSoftmax); }),
            "labels: the vocabulary has 2 classes, expected at least 3");
}

}  // namespace
}  // namespace semantic_slam
