#include "semantic_slam/map/map.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace semantic_slam {

Map::Map(std::vector<float> scales) : scales_(std::move(scales)) {}

Keyframe& Map::AddKeyframe(std::shared_ptr<const FrameFeatures> features,
                           const Rigid3d& T_map_camera) {
  auto keyframe = std::make_unique<Keyframe>();
  keyframe->id = next_keyframe_++;
  keyframe->map_id = map_id_;
  keyframe->points.assign(features->size(), kNoPoint);
  keyframe->features = std::move(features);
  keyframe->T_map_camera = T_map_camera;
  Keyframe& added = *keyframe;
  keyframes_.emplace(added.id, std::move(keyframe));
  earlier_merges_ = std::move(merges_);
  merges_.clear();
  return added;
}

void Map::CullKeyframe(KeyframeId id) {
  const Keyframe& keyframe = *FindKeyframe(id);
  assert(keyframe.parent != kNoKeyframe);
  const std::vector<PointId> points = keyframe.points;
  for (const PointId point : points) {
    if (point != kNoPoint) RemoveObservation(point, id);
  }
  for (const auto& [other, shared] : keyframe.covisible) {
    if (Keyframe* neighbour = FindKeyframe(other)) neighbour->covisible.erase(id);
  }
  AdoptChildrenOf(keyframe);
  const Rigid3d& T_map_parent = FindKeyframe(keyframe.parent)->T_map_camera;
  culled_[id] = {keyframe.map_id, keyframe.features->stamp(), keyframe.parent,
                 T_map_parent.inverse() * keyframe.T_map_camera};
  keyframes_.erase(id);
  ForgetLoopEdges();
}

// Those of keyframes that are gone.
void Map::ForgetLoopEdges() {
  const auto is_gone = [this](const LoopEdge& edge) {
    return FindKeyframe(edge.a) == nullptr || FindKeyframe(edge.b) == nullptr;
  };
  loop_edges_.erase(std::remove_if(loop_edges_.begin(), loop_edges_.end(), is_gone),
                    loop_edges_.end());
}

void Map::AdoptChildrenOf(const Keyframe& keyframe) {
  for (auto& [id, other] : keyframes_) {
    if (other->parent == keyframe.id) other->parent = keyframe.parent;
  }
  const Rigid3d T_parent_keyframe =
      FindKeyframe(keyframe.parent)->T_map_camera.inverse() * keyframe.T_map_camera;
  for (auto& [id, other] : culled_) {
    if (other.parent != keyframe.id) continue;
    other.parent = keyframe.parent;
    other.T_parent_keyframe = T_parent_keyframe * other.T_parent_keyframe;
  }
}

void Map::UpdateCovisibility(KeyframeId id) {
  Keyframe& keyframe = *FindKeyframe(id);
  for (const auto& [other, shared] : keyframe.covisible) {
    if (Keyframe* neighbour = FindKeyframe(other)) neighbour->covisible.erase(id);
  }
  CountCovisible(keyframe);
  for (const auto& [other, shared] : keyframe.covisible) {
    FindKeyframe(other)->covisible[id] = shared;
  }
  const auto it = keyframes_.find(id);
  const bool is_first =
      it == keyframes_.begin() || std::prev(it)->second->map_id != keyframe.map_id;
  if (keyframe.parent != kNoKeyframe || is_first) return;
  KeyframeId parent = kNoKeyframe;
  int most_shared = 0;
  for (const auto& [other, shared] : keyframe.covisible) {
    if (other < id && shared > most_shared) parent = other, most_shared = shared;
  }
  // A view that shares nothing hangs on the one before it: the tree must reach every keyframe.
  keyframe.parent = parent != kNoKeyframe ? parent : std::prev(it)->first;
}

void Map::CountCovisible(Keyframe& keyframe) const {
  keyframe.covisible.clear();
  for (const PointId point_id : keyframe.points) {
    const MapPoint* point = FindPoint(point_id);
    if (point == nullptr) continue;
    for (const Observation& o : point->observations) {
      if (o.keyframe != keyframe.id) ++keyframe.covisible[o.keyframe];
    }
  }
}

Keyframe* Map::FindKeyframe(KeyframeId id) {
  const auto it = keyframes_.find(id);
  return it == keyframes_.end() ? nullptr : it->second.get();
}

const Keyframe* Map::FindKeyframe(KeyframeId id) const {
  return const_cast<Map*>(this)->FindKeyframe(id);
}

std::vector<KeyframeId> Map::BestCovisible(KeyframeId id, int limit, int min_shared) const {
  std::vector<std::pair<int, KeyframeId>> order;  // ascending: most shared first, then oldest
  for (const auto& [other, shared] : FindKeyframe(id)->covisible) {
    if (shared >= min_shared) order.emplace_back(-shared, other);
  }
  std::sort(order.begin(), order.end());
  if (static_cast<int>(order.size()) > limit) order.resize(limit);
  std::vector<KeyframeId> best;
  for (const auto& entry : order) best.push_back(entry.second);
  return best;
}

Rigid3d Map::KeyframePose(KeyframeId id) const {
  if (const Keyframe* keyframe = FindKeyframe(id)) return keyframe->T_map_camera;
  const Culled& culled = culled_.at(id);
  return KeyframePose(culled.parent) * culled.T_parent_keyframe;
}

void Map::BumpRevision(RevisionReason reason) {
  ++revision_;
  reason_ = reason;
}

KeyframeGraph Map::Graph() const {
  KeyframeGraph graph;
  graph.map_id = map_id_;
  graph.revision = revision_;
  graph.reason = reason_;
  if (reason_ == RevisionReason::kMerge) graph.merge = merge_;
  for (const auto& [id, keyframe] : keyframes_) {
    if (!IsPresent(*keyframe)) continue;
    KeyframeNode node;
    node.id = id;
    node.stamp = keyframe->features->stamp();
    node.T_map_keyframe = keyframe->T_map_camera;
    node.parent_id = keyframe->parent;
    if (node.parent_id != kNoKeyframe) {
      node.T_parent_keyframe = KeyframePose(node.parent_id).inverse() * node.T_map_keyframe;
    }
    graph.keyframes.push_back(node);
  }
  for (const auto& [id, culled] : culled_) {
    if (culled.map_id != map_id_) continue;
    graph.keyframes.push_back(
        {id, culled.stamp, KeyframePose(id), culled.parent, culled.T_parent_keyframe, true});
  }
  std::sort(graph.keyframes.begin(), graph.keyframes.end(),
            [](const KeyframeNode& a, const KeyframeNode& b) { return a.id < b.id; });
  return graph;
}

}  // namespace semantic_slam
