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
      free_rays_(static_cast<std::size_t>(beams) * (bins_ + 1)),
      free_slope_(free_rays_.size()),
      hits_(free_rays_.size()),
      hit_sum_m_(free_rays_.size()) {}

void BeamHistogram::AddHit(int beam, float range_m) {
  const std::size_t index = Index(beam, std::min(static_cast<int>(range_m / kBinM), bins_ - 1));
  ++hits_[index];
  hit_sum_m_[index] += range_m;
}

void BeamHistogram::AddFree(int beam, const RangeInterval& interval, float slope) {
  const int begin = static_cast<int>(interval.from_m / kBinM + 1.0f - kRounding);
  const int end = std::min(static_cast<int>(interval.to_m / kBinM + kRounding), bins_);
  if (begin >= end) return;
  ++free_rays_[Index(beam, begin)];
  --free_rays_[Index(beam, end)];
  free_slope_[Index(beam, begin)] += slope;
  free_slope_[Index(beam, end)] -= slope;
}

RangeInterval BeamHistogram::FreeStretch(int beam, int min_rays, float height_m) const {
  int rays = 0, begin = -1, bin = 0;
  float slope = 0.0f;
  for (; bin < bins_; ++bin) {
    rays += free_rays_[Index(beam, bin)];
    slope += free_slope_[Index(beam, bin)];
    const float seen_m = slope * (BinStart(bin) + 0.5f * kBinM);
    const bool is_free = rays >= min_rays && seen_m >= height_m;
    if (is_free && begin < 0) begin = bin;
    if (!is_free && begin >= 0) break;
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
