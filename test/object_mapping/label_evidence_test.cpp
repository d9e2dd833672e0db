#include "semantic_slam/object_mapping/label_evidence.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr LabelId kTv = 25, kLaptop = 41;
constexpr int kClasses = 64;

TEST(LabelEvidenceTest, OneDetectionSaysWhatItSays) {
  LabelEvidence evidence(kClasses);
  evidence.Add(kTv, 0.7f);
  ASSERT_EQ(evidence.Probabilities().size(), 1u);
  EXPECT_EQ(evidence.Best(), kTv);
  EXPECT_NEAR(evidence.Probabilities()[0].probability, 0.7, 1e-6);  // a float
}

TEST(LabelEvidenceTest, TwoFollowBayesRule) {
  LabelEvidence evidence(3);
  evidence.Add(1, 0.6f);
  evidence.Add(2, 0.5f);
  // Likelihoods of the three classes: 0.2 * 0.25, 0.6 * 0.25, 0.2 * 0.5.
  const double sum = 0.05 + 0.15 + 0.1;
  const auto probabilities = evidence.Probabilities();
  EXPECT_EQ(probabilities[0].label, 1);
  EXPECT_NEAR(probabilities[0].probability, 0.15 / sum, 1e-6);
  EXPECT_NEAR(probabilities[1].probability, 0.1 / sum, 1e-6);
}

TEST(LabelEvidenceTest, ManyAgreeingOnesNeverMakeItCertain) {
  LabelEvidence evidence(kClasses);
  for (int i = 0; i < 100000; ++i) evidence.Add(kTv, 1.0f);
  EXPECT_NEAR(evidence.Probabilities()[0].probability, 0.99, 1e-6);
  for (int i = 0; i < 4; ++i) evidence.Add(kLaptop, 0.8f);
  EXPECT_EQ(evidence.Best(), kLaptop);
}

TEST(LabelEvidenceTest, ProbabilitiesAreSortedAndSumToAtMostOne) {
  LabelEvidence evidence(kClasses);
  for (int i = 0; i < 300; ++i) {
    evidence.Add(static_cast<LabelId>(i * 7 % kClasses), 0.01f * static_cast<float>(i % 100));
    float sum = 0.0f, last = 1.0f;
    for (const LabelProbability& label : evidence.Probabilities()) {
      EXPECT_TRUE(std::isfinite(label.probability));
      EXPECT_LE(label.probability, last);
      last = label.probability;
      sum += label.probability;
    }
    EXPECT_LE(sum, 1.0f + 1e-5f);  // floats
  }
  EXPECT_LE(evidence.Probabilities().size(), static_cast<std::size_t>(kClasses));
}

TEST(LabelEvidenceTest, TwoObjectsThatAreOneKnowWhatBothKnew) {
  LabelEvidence a(kClasses), b(kClasses), both(kClasses);
  a.Add(kTv, 0.6f), b.Add(kLaptop, 0.5f);
  both.Add(kTv, 0.6f), both.Add(kLaptop, 0.5f);
  a.Add(b);
  EXPECT_FLOAT_EQ(a.Probabilities()[0].probability, both.Probabilities()[0].probability);
}

}  // namespace
}  // namespace semantic_slam
