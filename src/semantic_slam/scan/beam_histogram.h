#pragma once

#include <limits>
#include <vector>

#include "semantic_slam/scan/planar_scan.h"

namespace semantic_slam {

// A stretch of horizontal distance [m]; empty unless from_m < to_m.
struct RangeInterval {
  float from_m = 0.0f;
  float to_m = 0.0f;
};

// What the pixels of one image say about each beam, by distance: how much of the band of heights
// was seen to be free there, and where rays ended on something.
class BeamHistogram {
 public:
  BeamHistogram(int beams, float max_range_m);

  // A pixel's ray is inside the band and free here. It stands for `slope` metres of height per
  // metre of distance. Only bins that lie in the interval as a whole count.
  void AddFree(int beam, const RangeInterval& interval, float slope);
  // A ray ends on something inside the band. Precondition: 0 <= range_m <= max_range_m.
  void AddHit(int beam, float range_m);

  // Distance of the nearest surface: the mean of the hits within the surface's depth of the nearest
  // hit that has at least `min_hits` there. NaN if there is none. `surface_depth_m(range)` tells
  // how far the hits of one surface spread.
  template <typename SurfaceDepth>
  float NearestSurface(int beam, int min_hits, SurfaceDepth&& surface_depth_m) const {
    for (int bin = 0; bin < bins_; ++bin) {
      if (hits_[Index(beam, bin)] == 0) continue;
      const int end = EndBin(bin, surface_depth_m(BinStart(bin)));
      if (CountHits(beam, bin, end) >= min_hits) return MeanHit(beam, bin, end);
    }
    return std::numeric_limits<float>::quiet_NaN();
  }

  // The nearest stretch in which at least `height_m` of height, by the rays of at least `min_rays`
  // pixels, was seen to be free. Empty if there is none.
  RangeInterval FreeStretch(int beam, int min_rays, float height_m) const;

 private:
  static constexpr float kBinM = 0.05f;

  static float BinStart(int bin) { return static_cast<float>(bin) * kBinM; }
  std::size_t Index(int beam, int bin) const {
    return static_cast<std::size_t>(beam) * (bins_ + 1) + bin;
  }
  int EndBin(int bin, float depth_m) const;
  int CountHits(int beam, int begin, int end) const;
  float MeanHit(int beam, int begin, int end) const;

  const float max_range_m_;
  const int bins_;  // per beam, plus one that takes what ends with the last
  // Differences from bin to bin: their running sums are the number of free rays, and the slopes
  // they stand for.
  std::vector<int> free_rays_;
  std::vector<float> free_slope_;
  std::vector<int> hits_;
  std::vector<float> hit_sum_m_;
};

}  // namespace semantic_slam
