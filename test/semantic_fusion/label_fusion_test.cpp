#include "semantic_slam/semantic_fusion/label_fusion.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr int kClasses = 52;
constexpr LabelId kA = 5, kB = 9, kC = 12;
const char* const kRules[] = {"bayes", "thesis_literal", "max_with_memory", "votes"};

LabelFusion Fusion(const std::string& rule) {
  LabelFusionOptions options;
  options.rule = rule;
  return LabelFusion(options, kClasses);
}

// Bounds and alpha for which results are worked out by hand below.
LabelFusion HandFusion(const std::string& rule) {
  LabelFusionOptions options;
  options.rule = rule;
  options.min_probability = 0.005;
  options.max_probability = 0.99;
  options.alpha = 0.0;
  return LabelFusion(options, kClasses);
}

LabelDistribution Seen(std::initializer_list<std::pair<LabelId, float>> labels) {
  LabelDistribution distribution;
  int i = 0;
  for (const auto& [label, probability] : labels) {
    distribution.labels[i] = label;
    distribution.probabilities[i++] = probability;
  }
  return distribution;
}

LabelDistribution RandomDistribution(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const float a = 0.3f + 0.69f * unit(random), b = std::min(a, 1.0f - a) * unit(random);
  const float c = std::min(b, 1.0f - a - b) * unit(random);
  const auto first = static_cast<LabelId>(1 + random() % 10);
  return Seen(
      {{first, a}, {static_cast<LabelId>(first + 10), b}, {static_cast<LabelId>(first + 20), c}});
}

// What the octree does: the state goes through its compact form.
LabelDistribution Stored(const LabelDistribution& state) {
  return CompactLabels(state).Unpacked();
}

// How many observations of B it takes after `count` of A until B is the label held; 1000 if never.
int FlipTime(const LabelFusion& fusion, int count, float probability) {
  LabelDistribution state;
  for (int i = 0; i < count; ++i) state = Stored(fusion.Fuse(state, Seen({{kA, probability}})));
  EXPECT_EQ(state.top(), kA);
  for (int i = 1; i < 1000; ++i) {
    state = Stored(fusion.Fuse(state, Seen({{kB, probability}})));
    if (state.top() == kB) return i;
  }
  return 1000;
}

TEST(LabelFusionTest, AlwaysADistributionOfLabelsThatWereSeen) {
  for (const char* rule : kRules) {
    const LabelFusion fusion = Fusion(rule);
    std::mt19937 random(23);
    for (int place = 0; place < 50; ++place) {
      LabelDistribution state;
      std::set<LabelId> seen{kUnknownLabel};
      for (int view = 0; view < 30; ++view) {
        const LabelDistribution observation = RandomDistribution(random);
        seen.insert(observation.labels.begin(), observation.labels.end());
        state = Stored(fusion.Fuse(state, observation));
        float sum = state.others();
        for (int i = 0; i < kTopLabels; ++i) {
          sum += state.probabilities[i];
          EXPECT_GE(state.probabilities[i], 0.0f);
          EXPECT_EQ(seen.count(state.labels[i]), 1u) << rule;
        }
        EXPECT_TRUE(std::is_sorted(state.probabilities.rbegin(), state.probabilities.rend()))
            << rule;
        EXPECT_NEAR(sum, 1.0f, 1e-6f);  // rounding of four floats
        EXPECT_GE(state.size(), 1);
        EXPECT_TRUE(CompactLabels(state).IsValid());
      }
    }
  }
}

TEST(LabelFusionTest, AnAgreementMakesSure) {
  for (const char* rule : {"bayes", "max_with_memory"}) {
    const LabelFusion fusion = Fusion(rule);
    LabelDistribution state;
    for (int view = 0; view < 10; ++view)
      state = fusion.Fuse(state, Seen({{kA, 0.6f}, {kB, 0.2f}}));
    EXPECT_EQ(state.top(), kA);
    EXPECT_GT(state.probabilities[0], 0.95f) << rule;
    EXPECT_LE(state.probabilities[0], 0.999f) << rule;
  }
}

// Algorithm 3.1 with ERRATA by hand. State A 0.6, B 0.3, so p-bar 0.1; observation A 0.5, C 0.3, so
// p-bar 0.2. alpha is 1/50 on both sides. B gets max(0.2 / 50, 0.005), C max(0.1 / 50, 0.005).
//   A 0.6 * 0.5 = 0.3    B 0.3 * 0.005 = 0.0015    C 0.005 * 0.3 = 0.0015    others 0.1 * 0.2 =
//   0.02
TEST(LabelFusionTest, BayesIsTheProductRuleOfAlgorithm31) {
  const LabelDistribution fused =
      HandFusion("bayes").Fuse(Seen({{kA, 0.6f}, {kB, 0.3f}}), Seen({{kA, 0.5f}, {kC, 0.3f}}));
  const float total = 0.3f + 0.0015f + 0.0015f + 0.02f;
  EXPECT_EQ(fused.labels, (std::array<LabelId, 3>{kA, kB, kC}));
  EXPECT_NEAR(fused.probabilities[0], 0.3f / total, 1e-5f);
  EXPECT_NEAR(fused.probabilities[1], 0.005f,
              1e-5f);  // 0.0015 / total is less than any label keeps
  EXPECT_NEAR(fused.others(), 1.0f - 0.3f / total - 0.01f, 1e-5f);
}

TEST(LabelFusionTest, AlphaIsAnOption) {
  LabelFusionOptions options;
  options.alpha = 0.5;
  const LabelDistribution fused =
      LabelFusion(options, kClasses).Fuse(Seen({{kA, 0.6f}}), Seen({{kB, 0.6f}}));
  // A 0.6 * 0.5 * 0.4, B the same, others 0.4 * 0.4.
  EXPECT_NEAR(fused.probabilities[0], 0.12f / 0.4f, 1e-5f);
  EXPECT_NEAR(fused.others(), 0.16f / 0.4f, 1e-5f);
}

TEST(LabelFusionTest, BayesDoesNotDependOnWhichSideIsTheState) {
  const LabelFusion fusion = Fusion("bayes");
  std::mt19937 random(29);
  for (int i = 0; i < 200; ++i) {
    const LabelDistribution a = RandomDistribution(random), b = RandomDistribution(random);
    const LabelDistribution ab = fusion.Fuse(a, b), ba = fusion.Fuse(b, a);
    for (int k = 0; k < kTopLabels; ++k) {
      // Sums of floats in another order.
      EXPECT_NEAR(ab.probabilities[k], ba.probabilities[k], 1e-6f);
    }
  }
}

TEST(LabelFusionTest, TheLiteralRuleKeepsTheStateWhereLabelsAreTheSame) {
  const LabelFusion fusion = Fusion("thesis_literal");
  const LabelDistribution state = Seen({{kA, 0.5f}, {kB, 0.4f}});
  const LabelDistribution fused = fusion.Fuse(state, Seen({{kB, 0.9f}, {kA, 0.05f}}));
  EXPECT_EQ(fused.labels, state.labels);
  EXPECT_EQ(fused.probabilities, state.probabilities);
}

// Lines 4 to 17 by hand with alpha = 1/51 for the first label missing: A 0.6, others 0.4; B 0.7.
TEST(LabelFusionTest, TheLiteralRuleLeavesOthersOut) {
  const LabelDistribution fused =
      HandFusion("thesis_literal").Fuse(Seen({{kA, 0.6f}}), Seen({{kB, 0.7f}}));
  const float a = 0.6f * (0.3f / 51.0f), b = 0.7f * (0.4f / 51.0f);
  EXPECT_EQ(fused.top(), kB);
  EXPECT_NEAR(fused.probabilities[0], b / (a + b), 1e-5f);
  EXPECT_NEAR(fused.others(), 0.0f, 1e-5f);
}

// The ancestor of this method forgot 101 views of A at 0.6 for a single one of B at 0.61, or never
// changed its mind again. Neither here.
TEST(LabelFusionTest, ChangesItsMindInBoundedTimeButNotAtOnce) {
  // Each view of B makes B five times as probable against A, for which it leaves 0.3 * 0.4; from
  // 1e-4 against 0.999 that takes ln 9990 / ln 5 = 5.7 views.
  const int bayes = FlipTime(Fusion("bayes"), 101, 0.6f);
  EXPECT_EQ(bayes, 6);
  EXPECT_EQ(FlipTime(Fusion("bayes"), 10000, 0.6f), bayes);
  const int memory = FlipTime(Fusion("max_with_memory"), 101, 0.6f);
  EXPECT_EQ(memory, 5);  // 0.999 * 0.9^5 < 0.6
  const int votes = FlipTime(Fusion("votes"), 101, 0.6f);
  EXPECT_GE(votes, 30);
  EXPECT_LE(votes, 50);  // half of what a mean over 63 remembers: 63 ln 2 = 44
  EXPECT_LE(FlipTime(Fusion("thesis_literal"), 101, 0.6f), 3);
}

TEST(LabelFusionTest, OneDoubtfulViewAmongManyTakesNothing) {
  for (const char* rule : {"bayes", "max_with_memory", "votes"}) {
    const LabelFusion fusion = Fusion(rule);
    LabelDistribution state;
    for (int view = 0; view < 101; ++view)
      state = Stored(fusion.Fuse(state, Seen({{kA, 0.6f}, {kC, 0.3f}})));
    state = Stored(fusion.Fuse(state, Seen({{kB, 0.61f}, {kA, 0.3f}})));
    EXPECT_EQ(state.top(), kA) << rule;
  }
}

TEST(LabelFusionTest, AnObservationWithoutLabelsChangesNothing) {
  for (const char* rule : kRules) {
    const LabelDistribution state = Seen({{kA, 0.7f}});
    const LabelDistribution fused = Fusion(rule).Fuse(state, {});
    EXPECT_EQ(fused.labels, state.labels);
    EXPECT_EQ(fused.probabilities, state.probabilities);
    EXPECT_EQ(fused.observations, state.observations);
  }
}

TEST(LabelFusionTest, TheFirstObservationIsTheStateWithinBounds) {
  const LabelDistribution fused = Fusion("bayes").Fuse({}, Seen({{kA, 0.9999f}}));
  EXPECT_FLOAT_EQ(fused.probabilities[0], 0.999f);
  EXPECT_EQ(fused.observations, 1);
}

TEST(LabelFusionTest, VotesAreTheMean) {
  const LabelFusion fusion = Fusion("votes");
  LabelDistribution state;
  for (const float probability : {0.8f, 0.6f, 0.4f})
    state = fusion.Fuse(state, Seen({{kA, probability}}));
  EXPECT_NEAR(state.probabilities[0], 0.6f, 1e-6f);
  state = fusion.Fuse(state, Seen({{kB, 0.8f}}));
  EXPECT_NEAR(state.probabilities[0], 0.45f, 1e-6f);
  EXPECT_NEAR(state.probabilities[1], 0.2f, 1e-6f);
  EXPECT_EQ(state.observations, 4);
}

TEST(LabelFusionTest, WorksWithASingleClass) {
  const LabelFusion fusion({}, 1);
  EXPECT_EQ(fusion.Fuse(Seen({{1, 0.6f}}), Seen({{1, 0.6f}})).top(), 1);
}

TEST(LabelFusionTest, ChecksItsOptions) {
  EXPECT_EQ(MessageOf<ConfigError>([] { Fusion("mean"); }),
            "rule = mean, but must be one of: bayes, thesis_literal, max_with_memory, votes");
  EXPECT_NE(MessageOf<ConfigError>([] { LabelFusion({}, 0); }), "");
}

}  // namespace
}  // namespace semantic_slam
