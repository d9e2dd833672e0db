#include "semantic_slam/semantic_fusion/label_distribution.h"

#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// Half a step of the compact form.
constexpr float kStep = 0.5f / CompactLabels::kProbabilityOne;

TEST(LabelDistributionTest, KnowsNothingAtFirst) {
  const LabelDistribution nothing;
  EXPECT_EQ(nothing.size(), 0);
  EXPECT_EQ(nothing.top(), kUnknownLabel);
  EXPECT_EQ(nothing.others(), 1.0f);
  EXPECT_EQ(nothing.Probability(kUnknownLabel), 0.0f);
}

TEST(LabelDistributionTest, OthersAreWhatIsMissingToOne) {
  LabelDistribution distribution;
  distribution.labels = {4, 9, kUnknownLabel};
  distribution.probabilities = {0.5f, 0.25f, 0.0f};
  EXPECT_EQ(distribution.size(), 2);
  EXPECT_FLOAT_EQ(distribution.others(), 0.25f);
  EXPECT_FLOAT_EQ(distribution.Probability(9), 0.25f);
  EXPECT_EQ(distribution.Probability(5), 0.0f);
}

TEST(CompactLabelsTest, KeepsWhatItWasGivenToHalfAStep) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (int i = 0; i < 1000; ++i) {
    LabelDistribution distribution;
    distribution.labels = {static_cast<LabelId>(1 + i % 250), 251, 252};
    const float a = 0.34f + 0.65f * unit(random), b = (1.0f - a) * (0.5f + 0.5f * unit(random));
    distribution.probabilities = {a, b, (1.0f - a - b) * unit(random)};
    distribution.observations = i % 64;
    const CompactLabels compact(distribution);
    const LabelDistribution back = compact.Unpacked();
    EXPECT_EQ(back.labels, distribution.labels);
    EXPECT_EQ(back.observations, distribution.observations);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(back.probabilities[k], distribution.probabilities[k], 2 * kStep);
    EXPECT_GE(back.others(), 0.0f);
    EXPECT_TRUE(CompactLabels(back) == compact);  // packing again loses nothing more
  }
}

TEST(CompactLabelsTest, ItsSumIsAtMostOne) {
  LabelDistribution distribution;
  distribution.labels = {1, 2, 3};
  distribution.probabilities = {0.33334f, 0.33333f, 0.33333f};
  const CompactLabels compact(distribution);
  EXPECT_LE(
      compact.scaled_probability(0) + compact.scaled_probability(1) + compact.scaled_probability(2),
      CompactLabels::kProbabilityOne);
  EXPECT_TRUE(compact.IsValid());
}

TEST(CompactLabelsTest, CountsNoFurtherThan63) {
  LabelDistribution distribution;
  distribution.observations = 1000;
  EXPECT_EQ(CompactLabels(distribution).observations(), 63);
}

TEST(CompactLabelsTest, TellsBytesThatAreNoDistribution) {
  EXPECT_TRUE(CompactLabels().IsValid());
  // Probabilities of 1 and 1; a probability without a label; the second larger than the first.
  EXPECT_FALSE(CompactLabels::FromBytes({0xff, 0x3f, 0xff, 0x3f, 0, 0, 1, 2, 0}).IsValid());
  EXPECT_FALSE(CompactLabels::FromBytes({0xff, 0x3f, 0, 0, 0, 0, 0, 0, 0}).IsValid());
  EXPECT_FALSE(CompactLabels::FromBytes({1, 0, 2, 0, 0, 0, 1, 2, 0}).IsValid());
  EXPECT_TRUE(CompactLabels::FromBytes({2, 0, 1, 0, 0, 0, 1, 2, 0}).IsValid());
}

}  // namespace
}  // namespace semantic_slam
