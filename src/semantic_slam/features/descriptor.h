#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace semantic_slam {

// 256 binary intensity tests (Rublee et al., ORB, ICCV 2011).
using Descriptor = std::array<std::uint64_t, 4>;

constexpr int kMaxDescriptorDistance = 256;

// Number of tests in which the two differ, 0..256.
inline int HammingDistance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    distance += __builtin_popcountll(a[i] ^ b[i]);
  }
  return distance;
}

// Index of the descriptor whose median distance to all others is least: what a map point seen in
// many images looks like. Ties go to the lowest index. Precondition: not empty.
std::size_t MedianDescriptor(const std::vector<Descriptor>& descriptors);

}  // namespace semantic_slam
