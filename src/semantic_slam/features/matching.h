#pragma once

#include <vector>

#include "semantic_slam/features/frame_features.h"

namespace semantic_slam {

struct FeatureMatch {
  int a;  // index into the first image's features
  int b;  // index into the second's
  int distance;
};

struct DescriptorMatchingOptions {
  int max_distance = 50;     // of 256
  double max_ratio = 0.75;   // best over second best
  bool check_rotation = true;  // keep only matches that agree on the image's rotation
};

// Matches two images by appearance alone, wherever the features lie: for a camera that is lost. Of
// the first image only the features listed in `candidates_a` take part. One to one; by ascending a.
std::vector<FeatureMatch> MatchDescriptors(const FrameFeatures& a,
                                           const std::vector<int>& candidates_a,
                                           const FrameFeatures& b,
                                           const DescriptorMatchingOptions& options);

// Votes for the image rotation between two views: a match whose angle difference is not in one of
// the three fullest of 30 bins is wrong (Mur-Artal et al., ORB-SLAM, 2015).
class RotationConsistency {
 public:
  void Add(float angle_a_rad, float angle_b_rad);

  // For each match added, whether it agrees with the majority.
  std::vector<bool> Consistent() const;

 private:
  static constexpr int kBins = 30;
  std::vector<int> bins_;  // of each match
};

}  // namespace semantic_slam
