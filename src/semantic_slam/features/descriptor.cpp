#include "semantic_slam/features/descriptor.h"

#include <algorithm>
#include <cassert>

namespace semantic_slam {

std::size_t MedianDescriptor(const std::vector<Descriptor>& descriptors) {
  assert(!descriptors.empty());
  const std::size_t n = descriptors.size();
  std::vector<int> distances(n);
  std::size_t best = 0;
  int best_median = kMaxDescriptorDistance + 1;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      distances[j] = HammingDistance(descriptors[i], descriptors[j]);
    }
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>((n - 1) / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    if (*middle < best_median) {
      best_median = *middle;
      best = i;
    }
  }
  return best;
}

}  // namespace semantic_slam
