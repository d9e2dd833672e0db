#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>

#include "semantic_slam/map/map.h"

// How maps begin, lie dormant, are joined and forgotten.

namespace semantic_slam {

void Map::Clear() {
  ForgetAll();
  ++map_id_;
  BumpRevision(RevisionReason::kReset);
}

void Map::ForgetAll() {
  keyframes_.clear();
  culled_.clear();
  loop_edges_.clear();
  points_.Clear();
  merges_.clear();
  earlier_merges_.clear();
}

void Map::BeginNew(std::size_t max_dormant_keyframes) {
  ++map_id_;
  std::map<int, std::size_t> sizes;  // by map
  for (const auto& [id, keyframe] : keyframes_) ++sizes[keyframe->map_id];
  std::size_t total = keyframes_.size();
  for (const auto& [id, size] : sizes) {
    if (total <= max_dormant_keyframes) break;
    Forget(id);
    total -= size;
  }
  BumpRevision(RevisionReason::kLost);
}

void Map::Forget(int map_id) {
  points_.ForEach([&](const MapPoint& point) {
    if (point.map_id == map_id) points_.Erase(point.id);
  });
  const auto erase_from = [map_id](auto& entries, auto&& map_of) {
    for (auto it = entries.begin(); it != entries.end();) {
      it = map_of(it->second) == map_id ? entries.erase(it) : std::next(it);
    }
  };
  erase_from(keyframes_, [](const auto& keyframe) { return keyframe->map_id; });
  erase_from(culled_, [](const Culled& culled) { return culled.map_id; });
  ForgetLoopEdges();
}

void Map::JoinTo(KeyframeId place, const Rigid3d& T_dormant_present) {
  const int dormant = FindKeyframe(place)->map_id;
  assert(dormant != map_id_);
  for (auto& [id, keyframe] : keyframes_) {
    if (keyframe->map_id == dormant) {
      keyframe->map_id = map_id_;
    } else if (IsPresent(*keyframe)) {
      keyframe->T_map_camera = Orthonormalised(T_dormant_present * keyframe->T_map_camera);
      if (keyframe->parent != kNoKeyframe) continue;
      keyframe->parent = place;
      keyframe->is_joint = true;
    }
  }
  for (auto& [id, culled] : culled_) {
    if (culled.map_id == dormant) culled.map_id = map_id_;
  }
  ForEachPoint([&](MapPoint& point) {
    if (point.map_id == dormant) {
      point.map_id = map_id_;
    } else if (point.map_id == map_id_) {
      point.position = T_dormant_present * point.position;
      point.view_direction = T_dormant_present.linear() * point.view_direction;
    }
  });
  merge_ = MapMerge{dormant, map_id_, Rigid3d::Identity()};
  BumpRevision(RevisionReason::kMerge);
}

std::size_t Map::dormant_keyframes() const {
  return static_cast<std::size_t>(
      std::count_if(keyframes_.begin(), keyframes_.end(),
                    [this](const auto& entry) { return !IsPresent(*entry.second); }));
}

}  // namespace semantic_slam
