#include "semantic_slam/map/map_contents.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

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
  std::vector<PointId> new_id(points_.size(), kNoPoint);  // without the gaps of erased ones
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (points_[i] == nullptr) continue;
    new_id[i] = static_cast<PointId>(contents.points.size());
    MapPoint& point = contents.points.emplace_back(*points_[i]);
    point.id = new_id[i];
    point.observations.clear();
  }
  for (const auto& [id, original] : keyframes_) {
    Keyframe& keyframe = contents.keyframes.emplace_back(*original);
    keyframe.covisible.clear();
    for (PointId& point : keyframe.points) {
      if (point != kNoPoint) point = new_id[point - first_point_];
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
  for (MapPoint point : contents.points) {
    point.id += first_point_;
    point.map_id = new_map_id.at(point.map_id);
    point.reference = Shifted(point.reference, kNoKeyframe, shift);
    points_.push_back(std::make_unique<MapPoint>(std::move(point)));
  }
  point_count_ = points_.size();
  for (Keyframe keyframe : contents.keyframes) {
    keyframe.id += shift;
    keyframe.map_id = new_map_id.at(keyframe.map_id);
    keyframe.parent = Shifted(keyframe.parent, kNoKeyframe, shift);
    for (std::size_t i = 0; i < keyframe.points.size(); ++i) {
      if (keyframe.points[i] == kNoPoint) continue;
      const Observation observation{keyframe.id, static_cast<int>(i)};
      points_[keyframe.points[i]]->observations.push_back(observation);
      keyframe.points[i] += first_point_;
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
