#pragma once

#include <string>

#include "semantic_slam/common/options.h"
#include "semantic_slam/semantic_fusion/label_distribution.h"

namespace semantic_slam {

enum class FusionRule { kBayes, kThesisLiteral, kMaxWithMemory, kVotes };

// Throws ConfigError, listing the names, if `name` is none of "bayes", "thesis_literal",
// "max_with_memory", "votes".
FusionRule FusionRuleFromName(const std::string& name);

struct LabelFusionOptions {
  std::string rule = "bayes";      // or thesis_literal, max_with_memory, votes
  double min_probability = 1e-4;   // no label is ever less probable, so that it can come back
  double max_probability = 0.999;  // nor more, so that it can be given up
  // Part of the others' probability that a label gets where it is missing; 0: an equal part, which
  // is too little, as a network spreads what is left over few classes.
  double alpha = 0.3;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("rule", self.rule);
    visit("min_probability", self.min_probability, 1e-4, 0.1);
    visit("max_probability", self.max_probability, 0.5, 0.999);
    visit("alpha", self.alpha, 0.0, 1.0);
  }
};

// Fuses what several views say of the class of one place, thesis Algorithm 3.1. By rule:
//
//   bayes            the algorithm with its ERRATA: the product of both sides, label by label, also
//   of
//                    "others", and normalised
//   thesis_literal   the algorithm to the letter: equal sets of labels leave the state as it is,
//   missing
//                    labels take their part of what is left one after the other, and others have no
//                    part
//   max_with_memory  the most confident label alone; agreement raises its confidence as independent
//                    witnesses would, each view that disagrees takes a tenth of it
//   votes            the mean over the last views, about sixty
//
// No rule brings up a label that was in neither argument. Immutable, so safe from any thread.
class LabelFusion {
 public:
  // `class_count` is K: the labels that a place may have, "unknown" not counted. Throws ConfigError
  // if an option is out of range, the rule is unknown or class_count is below 1.
  LabelFusion(const LabelFusionOptions& options, int class_count);

  // The state after one more observation. A state of no labels becomes the observation; an
  // observation of no labels changes nothing.
  LabelDistribution Fuse(const LabelDistribution& state,
                         const LabelDistribution& observation) const;

 private:
  float Bounded(float probability) const;
  float Alpha(int listed) const;
  float MissingProbability(const LabelDistribution& side) const;
  LabelDistribution Product(const LabelDistribution& state,
                            const LabelDistribution& observation) const;
  LabelDistribution LiteralProduct(const LabelDistribution& state,
                                   const LabelDistribution& observation) const;
  LabelDistribution Maximum(const LabelDistribution& state,
                            const LabelDistribution& observation) const;
  LabelDistribution Mean(const LabelDistribution& state,
                         const LabelDistribution& observation) const;

  const LabelFusionOptions options_;
  const FusionRule rule_;
  const int class_count_;
};

}  // namespace semantic_slam
