#include "semantic_slam/scan/beam_histogram.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr float kRounding = 1e-3f;  // of a bin: an interval that ends a hair short of it reaches it

}  // namespace

BeamHistogram::BeamHistogram(int beams, float max_range_m)
    : max_range_m_(max_range_m),
      bins_(std::max(1, static_cast<int>(max_range_m / kBinM + kRounding))),
      inside_(static_cast<std::size_t>(beams) * (bins_ + 1)),
      free_(inside_.size()),
      hits_(inside_.size()),
      hit_sum_m_(inside_.size()) {}

void BeamHistogram::AddHit(int beam, float range_m) {
  const std::size_t index = Index(beam, std::min(static_cast<int>(range_m / kBinM), bins_ - 1));
  ++hits_[index];
  hit_sum_m_[index] += range_m;
}

void BeamHistogram::AddTo(std::vector<int>& counts, int beam, const RangeInterval& interval) const {
  const int begin = static_cast<int>(interval.from_m / kBinM + 1.0f - kRounding);
  const int end = std::min(static_cast<int>(interval.to_m / kBinM + kRounding), bins_);
  if (begin >= end) return;
  ++counts[Index(beam, begin)];
  --counts[Index(beam, end)];
}

RangeInterval BeamHistogram::FreeStretch(int beam, int min_rays, float min_share) const {
  int inside = 0, free = 0, begin = -1, bin = 0;
  for (; bin < bins_; ++bin) {
    inside += inside_[Index(beam, bin)];
    free += free_[Index(beam, bin)];
    if (begin < 0 && inside < min_rays) continue;  // the band has not come into view yet
    const bool is_free = free >= min_rays && static_cast<float>(free) >= min_share * inside;
    if (!is_free) break;
    if (begin < 0) begin = bin;
  }
  if (begin < 0) return {};
  return {BinStart(begin), bin < bins_ ? BinStart(bin) : max_range_m_};
}

int BeamHistogram::EndBin(int bin, float depth_m) const {
  return std::min(bin + std::max(1, static_cast<int>(std::ceil(depth_m / kBinM))), bins_);
}

int BeamHistogram::CountHits(int beam, int begin, int end) const {
  int count = 0;
  for (int bin = begin; bin < end; ++bin) count += hits_[Index(beam, bin)];
  return count;
}

float BeamHistogram::MeanHit(int beam, int begin, int end) const {
  float sum_m = 0.0f;
  for (int bin = begin; bin < end; ++bin) sum_m += hit_sum_m_[Index(beam, bin)];
  return sum_m / static_cast<float>(CountHits(beam, begin, end));
}

}  // namespace semantic_slam
