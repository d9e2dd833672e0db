#include "semantic_slam/map/map_contents.h"

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace semantic_slam {
namespace {

// Adds `shift` to an id, unless it is the one that stands for none.
std::int64_t Shifted(std::int64_t id, std::int64_t none, std::int64_t shift) {
  return id == none ? none : id + shift;
}

// Of keyframes that are there and that were; ids below it were given away by earlier maps.
KeyframeId LeastId(const MapContents& contents) {
  KeyframeId least = contents.next_keyframe;
  for (const Keyframe& keyframe : contents.keyframes) least = std::min(least, keyframe.id);
  for (const CulledKeyframe& culled : contents.culled) {
    least = std::min({least, culled.id, culled.parent});
  }
  return least;
}

}  // namespace

MapContents Map::Contents() const {
  MapContents contents;
  contents.map_id = map_id_;
  contents.next_keyframe = next_keyframe_;
  std::unordered_map<PointId, PointId> new_id;  // in a row
  ForEachPoint([&](const MapPoint& original) {
    MapPoint& point = contents.points.emplace_back(original);
    point.id = static_cast<PointId>(contents.points.size() - 1);
    point.observations.clear();
    new_id[original.id] = point.id;
  });
  for (const auto& [id, original] : keyframes_) {
    Keyframe& keyframe = contents.keyframes.emplace_back(*original);
    keyframe.covisible.clear();
    for (PointId& point : keyframe.points) {
      if (point != kNoPoint) point = new_id.at(point);
    }
  }
  for (const auto& [id, culled] : culled_) {
    contents.culled.push_back(
        {id, culled.map_id, culled.stamp, culled.parent, culled.T_parent_keyframe});
  }
  for (const LoopEdge& edge : loop_edges_) {
    if (keyframes_.count(edge.a) + keyframes_.count(edge.b) == 2) {
      contents.loop_edges.push_back(edge);
    }
  }
  return contents;
}

void Map::Load(const MapContents& contents) {
  ForgetAll();
  std::map<int, int> new_map_id;
  for (const Keyframe& keyframe : contents.keyframes) new_map_id[keyframe.map_id];
  for (auto& entry : new_map_id) entry.second = ++map_id_;
  const KeyframeId shift = next_keyframe_ - LeastId(contents);
  std::vector<MapPoint*> points;
  for (const MapPoint& original : contents.points) {
    MapPoint& point = points_.Add();
    const PointId id = point.id;
    point = original;
    point.id = id;
    point.map_id = new_map_id.at(point.map_id);
    point.reference = Shifted(point.reference, kNoKeyframe, shift);
    points.push_back(&point);
  }
  for (Keyframe keyframe : contents.keyframes) {
    keyframe.id += shift;
    keyframe.map_id = new_map_id.at(keyframe.map_id);
    keyframe.parent = Shifted(keyframe.parent, kNoKeyframe, shift);
    for (std::size_t i = 0; i < keyframe.points.size(); ++i) {
      if (keyframe.points[i] == kNoPoint) continue;
      const Observation observation{keyframe.id, static_cast<int>(i)};
      MapPoint& point = *points[keyframe.points[i]];
      point.observations.push_back(observation);
      keyframe.points[i] = point.id;
    }
    const KeyframeId id = keyframe.id;
    keyframes_.emplace(id, std::make_unique<Keyframe>(std::move(keyframe)));
  }
  for (const CulledKeyframe& culled : contents.culled) {
    culled_[culled.id + shift] = {new_map_id.at(culled.map_id), culled.stamp, culled.parent + shift,
                                  culled.T_parent_keyframe};
  }
  for (LoopEdge edge : contents.loop_edges) {
    edge.a += shift;
    edge.b += shift;
    loop_edges_.push_back(edge);
  }
  for (auto& entry : keyframes_) CountCovisible(*entry.second);
  next_keyframe_ = contents.next_keyframe + shift;
  BumpRevision(RevisionReason::kLoad);
}

}  // namespace semantic_slam
