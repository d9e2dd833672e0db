#include "semantic_slam/features/matching.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr float kTwoPi = 6.28318530718f;

struct Nearest {
  int index = -1;
  int distance = kMaxDescriptorDistance;
  int second_distance = kMaxDescriptorDistance;
};

Nearest FindNearest(const Descriptor& descriptor, const std::vector<Descriptor>& others) {
  Nearest nearest;
  for (int i = 0; i < static_cast<int>(others.size()); ++i) {
    const int distance = HammingDistance(descriptor, others[i]);
    if (distance < nearest.distance) {
      nearest.second_distance = nearest.distance;
      nearest.distance = distance;
      nearest.index = i;
    } else if (distance < nearest.second_distance) {
      nearest.second_distance = distance;
    }
  }
  return nearest;
}

std::vector<FeatureMatch> KeepRotationConsistent(const std::vector<FeatureMatch>& matches,
                                                 const FrameFeatures& a, const FrameFeatures& b) {
  RotationConsistency rotation;
  for (const FeatureMatch& match : matches) {
    rotation.Add(a[match.a].angle_rad, b[match.b].angle_rad);
  }
  const std::vector<bool> consistent = rotation.Consistent();
  std::vector<FeatureMatch> kept;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (consistent[i]) kept.push_back(matches[i]);
  }
  return kept;
}

}  // namespace

std::vector<FeatureMatch> MatchDescriptors(const FrameFeatures& a,
                                           const std::vector<int>& candidates_a,
                                           const FrameFeatures& b,
                                           const DescriptorMatchingOptions& options) {
  std::vector<FeatureMatch> matches;
  std::vector<int> match_of_b(b.size(), -1);
  for (const int i : candidates_a) {
    const Nearest nearest = FindNearest(a.descriptor(i), b.descriptors());
    if (nearest.distance > options.max_distance ||
        nearest.distance > options.max_ratio * nearest.second_distance) {
      continue;
    }
    int& taken = match_of_b[nearest.index];
    if (taken < 0) {
      taken = static_cast<int>(matches.size());
      matches.push_back({i, nearest.index, nearest.distance});
    } else if (nearest.distance < matches[taken].distance) {
      matches[taken] = {i, nearest.index, nearest.distance};
    }
  }
  std::sort(matches.begin(), matches.end(),
            [](const FeatureMatch& x, const FeatureMatch& y) { return x.a < y.a; });
  return options.check_rotation ? KeepRotationConsistent(matches, a, b) : matches;
}

void RotationConsistency::Add(float angle_a_rad, float angle_b_rad) {
  float difference = angle_a_rad - angle_b_rad;
  difference -= kTwoPi * std::floor(difference / kTwoPi);
  bins_.push_back(static_cast<int>(std::lround(difference / kTwoPi * kBins)) % kBins);
}

std::vector<bool> RotationConsistency::Consistent() const {
  std::array<int, kBins> votes{};
  for (const int bin : bins_) ++votes[bin];
  std::array<int, kBins> order;
  for (int i = 0; i < kBins; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return votes[a] > votes[b]; });
  std::array<bool, kBins> good{};
  for (int rank = 0; rank < 3; ++rank) {
    // A second or third bin with hardly any vote is noise, not a spread-out majority.
    good[order[rank]] = rank == 0 || votes[order[rank]] >= 0.1 * votes[order[0]];
  }
  std::vector<bool> consistent(bins_.size());
  for (std::size_t i = 0; i < bins_.size(); ++i) consistent[i] = good[bins_[i]];
  return consistent;
}

}  // namespace semantic_slam
