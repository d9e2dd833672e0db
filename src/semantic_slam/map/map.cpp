#include "semantic_slam/map/map.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace semantic_slam {
namespace {

std::vector<Observation>::iterator FindObservation(MapPoint& point, KeyframeId keyframe) {
  auto it = std::lower_bound(point.observations.begin(), point.observations.end(), keyframe,
                             [](const Observation& o, KeyframeId id) { return o.keyframe < id; });
  return it != point.observations.end() && it->keyframe == keyframe ? it : point.observations.end();
}

}  // namespace

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

MapPoint& Map::AddPoint(const Eigen::Vector3d& position, KeyframeId keyframe, int feature) {
  const PointId id = first_point_ + static_cast<PointId>(points_.size());
  points_.push_back(std::make_unique<MapPoint>());
  ++point_count_;
  MapPoint& point = *points_.back();
  point.id = id;
  point.map_id = FindKeyframe(keyframe)->map_id;
  point.position = position;
  point.reference = keyframe;
  point.rgb = (*FindKeyframe(keyframe)->features)[feature].rgb;
  AddObservation(id, keyframe, feature);
  UpdatePointAppearance(id);
  UpdatePointGeometry(id);
  return point;
}

void Map::AddObservation(PointId point_id, KeyframeId keyframe_id, int feature) {
  MapPoint& point = *FindPoint(point_id);
  Keyframe& keyframe = *FindKeyframe(keyframe_id);
  assert(keyframe.points[feature] == kNoPoint);
  if (FindObservation(point, keyframe_id) != point.observations.end()) return;
  const auto after =
      std::upper_bound(point.observations.begin(), point.observations.end(), keyframe_id,
                       [](KeyframeId id, const Observation& o) { return id < o.keyframe; });
  point.observations.insert(after, {keyframe_id, feature});
  keyframe.points[feature] = point_id;
}

void Map::RemoveObservation(PointId point_id, KeyframeId keyframe_id) {
  MapPoint* point = FindPoint(point_id);
  if (point == nullptr) return;
  const auto it = FindObservation(*point, keyframe_id);
  if (it == point->observations.end()) return;
  FindKeyframe(keyframe_id)->points[it->feature] = kNoPoint;
  point->observations.erase(it);
  if (point->observations.size() < 2) {
    ErasePoint(point_id);
  } else if (point->reference == keyframe_id) {
    point->reference = point->observations.front().keyframe;
    UpdatePointGeometry(point_id);
  }
}

void Map::ErasePoint(PointId point_id) {
  MapPoint* point = FindPoint(point_id);
  if (point == nullptr) return;
  for (const Observation& o : point->observations) {
    FindKeyframe(o.keyframe)->points[o.feature] = kNoPoint;
  }
  points_[point_id - first_point_].reset();
  --point_count_;
}

void Map::MergePoints(PointId from, PointId to) {
  if (from == to) return;
  const MapPoint& gone = *FindPoint(from);
  const std::vector<Observation> observations = gone.observations;
  MapPoint& kept = *FindPoint(to);
  kept.visible += gone.visible;
  kept.found += gone.found;
  ErasePoint(from);
  for (const Observation& o : observations) AddObservation(to, o.keyframe, o.feature);
  merges_[from] = to;
  UpdatePointAppearance(to);
  UpdatePointGeometry(to);
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

void Map::UpdatePointAppearance(PointId id) {
  MapPoint& point = *FindPoint(id);
  if (point.observations.empty()) return;
  std::vector<Descriptor> descriptors;
  for (const Observation& o : point.observations) {
    descriptors.push_back(FindKeyframe(o.keyframe)->features->descriptor(o.feature));
  }
  point.descriptor = descriptors[MedianDescriptor(descriptors)];
}

void Map::UpdatePointGeometry(PointId id) {
  MapPoint& point = *FindPoint(id);
  if (point.observations.empty()) return;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Observation* reference = &point.observations.front();
  for (const Observation& o : point.observations) {
    const Keyframe& keyframe = *FindKeyframe(o.keyframe);
    sum += (keyframe.T_map_camera.translation() - point.position).normalized();
    if (o.keyframe == point.reference) reference = &o;
  }
  point.view_direction = sum.normalized();
  const Keyframe& keyframe = *FindKeyframe(reference->keyframe);
  const double distance = (keyframe.T_map_camera.translation() - point.position).norm();
  const int octave = (*keyframe.features)[reference->feature].octave;
  // At max_distance_m the patch fits level 0; at min_distance_m it fits the last level.
  point.max_distance_m = distance * scales_[octave];
  point.min_distance_m = point.max_distance_m / scales_.back();
}

Keyframe* Map::FindKeyframe(KeyframeId id) {
  const auto it = keyframes_.find(id);
  return it == keyframes_.end() ? nullptr : it->second.get();
}

const Keyframe* Map::FindKeyframe(KeyframeId id) const {
  return const_cast<Map*>(this)->FindKeyframe(id);
}

MapPoint* Map::FindPoint(PointId id) {
  const PointId index = id - first_point_;
  if (index < 0 || index >= static_cast<PointId>(points_.size())) return nullptr;
  return points_[index].get();
}

const MapPoint* Map::FindPoint(PointId id) const {
  return const_cast<Map*>(this)->FindPoint(id);
}

PointId Map::Resolve(PointId id) const {
  for (const auto* merges : {&earlier_merges_, &merges_}) {
    for (auto it = merges->find(id); it != merges->end(); it = merges->find(id)) id = it->second;
  }
  return FindPoint(id) != nullptr ? id : kNoPoint;
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

int Map::CountPoints(KeyframeId id, int min_observations) const {
  int count = 0;
  for (const PointId point_id : FindKeyframe(id)->points) {
    const MapPoint* point = FindPoint(point_id);
    if (point != nullptr && static_cast<int>(point->observations.size()) >= min_observations) {
      ++count;
    }
  }
  return count;
}

Rigid3d Map::KeyframePose(KeyframeId id) const {
  if (const Keyframe* keyframe = FindKeyframe(id)) return keyframe->T_map_camera;
  const Culled& culled = culled_.at(id);
  return KeyframePose(culled.parent) * culled.T_parent_keyframe;
}

std::vector<ColouredPoint> Map::ColouredPoints() const {
  std::vector<ColouredPoint> coloured;
  coloured.reserve(point_count_);
  for (const auto& point : points_) {
    if (point == nullptr || point->map_id != map_id_) continue;
    coloured.push_back({point->position.cast<float>(), point->rgb});
  }
  return coloured;
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

void Map::Clear() {
  ForgetAll();
  ++map_id_;
  BumpRevision(RevisionReason::kReset);
}

void Map::ForgetAll() {
  keyframes_.clear();
  culled_.clear();
  loop_edges_.clear();
  first_point_ += static_cast<PointId>(points_.size());
  points_.clear();
  merges_.clear();
  earlier_merges_.clear();
  point_count_ = 0;
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
  for (auto& point : points_) {
    if (point == nullptr || point->map_id != map_id) continue;
    point.reset();
    --point_count_;
  }
  const auto erase_from = [map_id](auto& entries, auto&& map_of) {
    for (auto it = entries.begin(); it != entries.end();) {
      it = map_of(it->second) == map_id ? entries.erase(it) : std::next(it);
    }
  };
  erase_from(keyframes_, [](const auto& keyframe) { return keyframe->map_id; });
  erase_from(culled_, [](const Culled& culled) { return culled.map_id; });
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
  for (auto& point : points_) {
    if (point == nullptr) continue;
    if (point->map_id == dormant) {
      point->map_id = map_id_;
    } else if (point->map_id == map_id_) {
      point->position = T_dormant_present * point->position;
      point->view_direction = T_dormant_present.linear() * point->view_direction;
    }
  }
  merge_ = MapMerge{dormant, map_id_, Rigid3d::Identity()};
  BumpRevision(RevisionReason::kMerge);
}

std::size_t Map::dormant_keyframes() const {
  return static_cast<std::size_t>(
      std::count_if(keyframes_.begin(), keyframes_.end(),
                    [this](const auto& entry) { return !IsPresent(*entry.second); }));
}

}  // namespace semantic_slam
