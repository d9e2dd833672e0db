#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "semantic_slam/common/random_stream.h"

namespace semantic_slam {

inline double Between(RandomStream& random, double low, double high) {
  return low + (high - low) * random.Uniform();
}

inline bool Chance(RandomStream& random, double probability) {
  return random.Uniform() < probability;
}

// low, low + 1 ... high.
inline int WholeBetween(RandomStream& random, int low, int high) {
  return std::min(high, low + static_cast<int>(random.Uniform() * (high - low + 1)));
}

// Precondition: there is one.
template <typename Item>
const Item& OneOf(RandomStream& random, const std::vector<Item>& items) {
  return items[WholeBetween(random, 0, static_cast<int>(items.size()) - 1)];
}

// By the items' member `weight`. Precondition: there is one.
template <typename Item>
const Item& WeightedOneOf(RandomStream& random, const std::vector<Item>& items) {
  double sum = 0.0;
  for (const Item& item : items) sum += item.weight;
  double left = random.Uniform() * sum;
  for (const Item& item : items) {
    left -= item.weight;
    if (left < 0.0) return item;
  }
  return items.back();
}

}  // namespace semantic_slam
