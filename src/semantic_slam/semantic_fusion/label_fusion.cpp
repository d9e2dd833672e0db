#include "semantic_slam/semantic_fusion/label_fusion.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "semantic_slam/semantic_fusion/top_labels.h"

namespace semantic_slam {
namespace {

// Each view that disagrees leaves this part of the confidence (max_with_memory).
constexpr float kDisagreement = 0.9f;

// The labels of two distributions with a weight each.
class Candidates {
 public:
  struct Entry {
    LabelId label;
    float weight;
  };

  bool Has(LabelId label) const {
    return std::any_of(begin(), end(), [&](const Entry& entry) { return entry.label == label; });
  }
  void Add(LabelId label, float weight) { entries_[count_++] = {label, weight}; }
  float Sum() const {
    float sum = 0.0f;
    for (const Entry& entry : *this) sum += entry.weight;
    return sum;
  }
  int size() const { return count_; }
  Entry* begin() { return entries_.data(); }
  Entry* end() { return entries_.data() + count_; }
  const Entry* begin() const { return entries_.data(); }
  const Entry* end() const { return entries_.data() + count_; }

  // The heaviest three, divided by `total`.
  LabelDistribution Top(float total) const {
    TopLabels<float> heaviest;
    for (const Entry& entry : *this) heaviest.Offer(entry.label, entry.weight);
    LabelDistribution top;
    top.labels = heaviest.labels();
    for (int i = 0; i < kTopLabels; ++i) top.probabilities[i] = heaviest.weights()[i] / total;
    return top;
  }

 private:
  std::array<Entry, 2 * kTopLabels> entries_{};
  int count_ = 0;
};

bool SameLabels(const LabelDistribution& a, const LabelDistribution& b) {
  auto labels_a = a.labels, labels_b = b.labels;
  std::sort(labels_a.begin(), labels_a.end());
  std::sort(labels_b.begin(), labels_b.end());
  return labels_a == labels_b;
}

}  // namespace

FusionRule FusionRuleFromName(const std::string& name) {
  if (name == "bayes") return FusionRule::kBayes;
  if (name == "thesis_literal") return FusionRule::kThesisLiteral;
  if (name == "max_with_memory") return FusionRule::kMaxWithMemory;
  if (name == "votes") return FusionRule::kVotes;
  throw ConfigError("rule = " + name +
                    ", but must be one of: bayes, thesis_literal, max_with_memory, votes");
}

LabelFusion::LabelFusion(const LabelFusionOptions& options, int class_count)
    : options_(Validated(options)),
      rule_(FusionRuleFromName(options.rule)),
      class_count_(class_count) {
  CheckInRange("class_count", class_count, 1, 255);
}

LabelDistribution LabelFusion::Fuse(const LabelDistribution& state,
                                    const LabelDistribution& observation) const {
  if (observation.size() == 0) return state;
  LabelDistribution fused;
  if (state.size() == 0) {
    fused = observation;
  } else if (rule_ == FusionRule::kBayes) {
    fused = Product(state, observation);
  } else if (rule_ == FusionRule::kThesisLiteral) {
    fused = LiteralProduct(state, observation);
  } else if (rule_ == FusionRule::kMaxWithMemory) {
    fused = Maximum(state, observation);
  } else {
    fused = Mean(state, observation);
  }
  float sum = 0.0f;
  for (int i = 0; i < fused.size(); ++i)
    sum += fused.probabilities[i] = Bounded(fused.probabilities[i]);
  if (sum > 1.0f) {
    for (float& probability : fused.probabilities) probability /= sum;
  }
  fused.observations = std::min(state.observations + 1, CompactLabels::kMaxObservations);
  return fused;
}

float LabelFusion::Bounded(float probability) const {
  return std::clamp(probability, static_cast<float>(options_.min_probability),
                    static_cast<float>(options_.max_probability));
}

float LabelFusion::Alpha(int listed) const {
  if (options_.alpha > 0.0) return static_cast<float>(options_.alpha);
  return 1.0f / static_cast<float>(std::max(class_count_ - listed, 1));
}

// What `side` says of a label that it does not list.
float LabelFusion::MissingProbability(const LabelDistribution& side) const {
  return Bounded(Alpha(side.size()) * Bounded(side.others()));
}

// Algorithm 3.1 with its ERRATA: p-bar of each side is taken once, and takes part.
LabelDistribution LabelFusion::Product(const LabelDistribution& state,
                                       const LabelDistribution& observation) const {
  const float missing_in_state = MissingProbability(state);
  const float missing_in_observation = MissingProbability(observation);
  Candidates candidates;
  for (int i = 0; i < state.size(); ++i) {
    const float seen = observation.Probability(state.labels[i]);
    candidates.Add(state.labels[i], Bounded(state.probabilities[i]) *
                                        (seen > 0.0f ? Bounded(seen) : missing_in_observation));
  }
  for (int i = 0; i < observation.size(); ++i) {
    if (candidates.Has(observation.labels[i])) continue;
    candidates.Add(observation.labels[i], missing_in_state * Bounded(observation.probabilities[i]));
  }
  const float others = Bounded(state.others()) * Bounded(observation.others());
  return candidates.Top(candidates.Sum() + others);
}

// Algorithm 3.1 line by line; the probabilities are bounded, or two sure views that differ would
// give 0/0.
LabelDistribution LabelFusion::LiteralProduct(const LabelDistribution& state,
                                              const LabelDistribution& observation) const {
  if (SameLabels(state, observation)) return state;  // lines 1, 2
  const auto completed = [this](const LabelDistribution& side, const LabelDistribution& other) {
    Candidates candidates;
    for (int i = 0; i < side.size(); ++i)
      candidates.Add(side.labels[i], Bounded(side.probabilities[i]));
    for (int i = 0; i < other.size(); ++i) {  // lines 4 to 15
      if (candidates.Has(other.labels[i])) continue;
      const float rest = std::max(0.0f, 1.0f - candidates.Sum());
      candidates.Add(other.labels[i], Bounded(Alpha(candidates.size()) * rest));
    }
    return candidates;
  };
  Candidates fused = completed(state, observation);
  const Candidates seen = completed(observation, state);
  assert(fused.size() == seen.size());
  for (auto& entry : fused) {  // lines 16, 17
    const auto* match = std::find_if(seen.begin(), seen.end(), [&](const Candidates::Entry& other) {
      return other.label == entry.label;
    });
    entry.weight *= match->weight;
  }
  const float total = fused.Sum();
  return fused.Top(total);
}

LabelDistribution LabelFusion::Maximum(const LabelDistribution& state,
                                       const LabelDistribution& observation) const {
  const float held = state.probabilities[0], seen = observation.probabilities[0];
  LabelDistribution fused;
  fused.labels[0] = state.top();
  if (state.top() == observation.top()) {
    fused.probabilities[0] = 1.0f - (1.0f - held) * (1.0f - seen);
  } else if (kDisagreement * held >= seen) {
    fused.probabilities[0] = kDisagreement * held;
  } else {
    fused.labels[0] = observation.top();
    fused.probabilities[0] = seen;
  }
  return fused;
}

LabelDistribution LabelFusion::Mean(const LabelDistribution& state,
                                    const LabelDistribution& observation) const {
  const auto views =
      static_cast<float>(std::min(state.observations, CompactLabels::kMaxObservations - 1));
  Candidates candidates;
  for (int i = 0; i < state.size(); ++i) {
    candidates.Add(state.labels[i],
                   views * state.probabilities[i] + observation.Probability(state.labels[i]));
  }
  for (int i = 0; i < observation.size(); ++i) {
    if (!candidates.Has(observation.labels[i]))
      candidates.Add(observation.labels[i], observation.probabilities[i]);
  }
  return candidates.Top(views + 1.0f);
}

}  // namespace semantic_slam
