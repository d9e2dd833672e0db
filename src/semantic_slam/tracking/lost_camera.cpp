#include "semantic_slam/tracking/lost_camera.h"

#include <algorithm>

namespace semantic_slam {

int LostCamera::MinInliers() const {
  return images_since_found_ < kCautiousImages ? options_.min_relocalization_inliers
                                               : options_.min_inliers;
}

bool LostCamera::CanBeginMap(const FrameFeatures& features) const {
  int with_depth = 0;
  for (const Feature& feature : features.features()) with_depth += feature.has_depth();
  return with_depth >= options_.min_initial_points;
}

bool LostCamera::IsLostForLong(const FrameFeatures& features) {
  if (!CanBeginMap(features)) {
    unknown_since_.reset();
    return false;
  }
  if (!unknown_since_) unknown_since_ = features.stamp();
  return SecondsBetween(*unknown_since_, features.stamp()) >= options_.new_map_after_s;
}

std::vector<KeyframeId> LostCamera::Candidates(const FrameFeatures& features, const Map& map) {
  const std::size_t limit = options_.relocalization_keyframes;
  std::vector<KeyframeId> candidates;
  for (const PlaceScore& place : index_.Query(features)) {
    if (candidates.size() >= (limit + 1) / 2) break;
    const Keyframe* keyframe = map.FindKeyframe(place.keyframe);
    if (keyframe != nullptr && map.IsPresent(*keyframe)) candidates.push_back(place.keyframe);
  }
  std::vector<KeyframeId> others;
  for (const auto& entry : map.keyframes()) {
    const auto end = candidates.end();
    if (!map.IsPresent(*entry.second)) continue;
    if (std::find(candidates.begin(), end, entry.first) == end) others.push_back(entry.first);
  }
  std::reverse(others.begin(), others.end());  // the latest first
  const std::size_t turns = std::min(limit - candidates.size(), others.size());
  for (std::size_t i = 0; i < turns; ++i) {
    candidates.push_back(others[next_old_keyframe_++ % others.size()]);
  }
  return candidates;
}

}  // namespace semantic_slam
