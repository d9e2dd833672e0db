#pragma once

#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"

namespace semantic_slam {

// What an object's detections say together about its class: Bayes' rule over all classes, for a
// detector that names the class with probability `confidence` and any of the others alike. It never
// becomes surer than 0.99, so that a few detections of another class can change its mind. Not
// thread-safe.
class LabelEvidence {
 public:
  // `classes`: how many there are, at least 2.
  explicit LabelEvidence(int classes) : classes_(classes) {}

  // One detection; confidences are taken to be within [0.05, 0.95].
  void Add(LabelId label, float confidence);

  // All that was seen of another object that turned out to be this one.
  void Add(const LabelEvidence& other);

  // Classes that were detected, by descending probability, of equal ones the lower id first.
  std::vector<LabelProbability> Probabilities() const;

  // The most probable class. Precondition: something was added.
  LabelId Best() const;

 private:
  struct Weight {
    LabelId label;
    double log_odds;  // against a class that was never detected
  };

  void AddLogOdds(LabelId label, double log_odds);
  void Limit();

  int classes_;
  std::vector<Weight> weights_;  // by ascending label
};

}  // namespace semantic_slam
