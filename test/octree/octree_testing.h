#pragma once

#include <memory>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/semantic_fusion/label_fusion.h"
#include "semantic_slam/semantic_fusion/voxel_observation.h"

namespace semantic_slam {

inline LabelFusion Bayes() {
  return LabelFusion({}, 52);
}

inline LabelDistribution Distribution(LabelId label, float probability) {
  LabelDistribution distribution;
  distribution.labels[0] = label;
  distribution.probabilities[0] = probability;
  return distribution;
}

// One point of one label, grey.
inline VoxelObservation Observation(const Eigen::Vector3f& position, LabelId label,
                                    float probability) {
  return {position, {100, 100, 100}, CompactLabels(Distribution(label, probability)), 1, false};
}

inline std::shared_ptr<const LabelVocabulary> SmallVocabulary() {
  return std::make_shared<const LabelVocabulary>(
      std::vector<LabelClass>{{0, "unknown", {120, 120, 120}},
                              {2, "floor", {150, 110, 80}},
                              {5, "chair", {214, 39, 40}},
                              {7, "table", {255, 127, 14}},
                              {22, "ceiling", {225, 225, 235}},
                              {31, "person", {255, 0, 200}}});
}

// Makes the smallest voxel around `p` occupied, of that class and colour.
inline void AddVoxel(SemanticOcTree& tree, const Eigen::Vector3d& p, LabelId label,
                     const SemanticNode::Rgb& rgb = {10, 20, 30}) {
  SemanticNode* node = tree.setNodeValue(p.x(), p.y(), p.z(), 2.0f, true);
  node->SetLabels(CompactLabels(Distribution(label, 0.8f)));
  node->SetRgb(rgb);
}

// A floor of 2 m x 1 m at z = 0, a table 0.5 m x 0.5 m at 0.7 m, and a ceiling over both at 2.5 m.
inline void AddRoom(SemanticOcTree& tree) {
  const double step = tree.getResolution();
  for (double x = 0.5 * step; x < 2.0; x += step) {
    for (double y = 0.5 * step; y < 1.0; y += step) {
      AddVoxel(tree, {x, y, 0.01}, 2);
      AddVoxel(tree, {x, y, 2.51}, 22);
      if (x > 0.5 && x < 1.0 && y > 0.25 && y < 0.75) AddVoxel(tree, {x, y, 0.71}, 7);
    }
  }
  tree.updateInnerOccupancy();
}

}  // namespace semantic_slam
