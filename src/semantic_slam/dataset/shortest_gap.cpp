#include "semantic_slam/dataset/shortest_gap.h"

#include <algorithm>
#include <cassert>

namespace semantic_slam {
namespace {

constexpr std::size_t kRememberedGaps = 100;
constexpr std::size_t kEnoughGaps = 10;

}  // namespace

void ShortestGap::Add(Stamp stamp) {
  if (newest_) {
    assert(stamp > *newest_);
    gaps_ns_.push_back(stamp.ns - newest_->ns);
    if (gaps_ns_.size() > kRememberedGaps) gaps_ns_.pop_front();
  }
  newest_ = stamp;
}

std::optional<std::int64_t> ShortestGap::ns() const {
  if (gaps_ns_.size() < kEnoughGaps) return std::nullopt;
  return *std::min_element(gaps_ns_.begin(), gaps_ns_.end());
}

}  // namespace semantic_slam
