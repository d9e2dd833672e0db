#include <algorithm>
#include <cassert>
#include <utility>

#include "semantic_slam/map/map.h"

// What Map does with points and their observations.

namespace semantic_slam {
namespace {

std::vector<Observation>::iterator FindObservation(MapPoint& point, KeyframeId keyframe) {
  auto it = std::lower_bound(point.observations.begin(), point.observations.end(), keyframe,
                             [](const Observation& o, KeyframeId id) { return o.keyframe < id; });
  return it != point.observations.end() && it->keyframe == keyframe ? it : point.observations.end();
}

}  // namespace

MapPoint& Map::AddPoint(const Eigen::Vector3d& position, KeyframeId keyframe, int feature) {
  MapPoint& point = points_.Add();
  point.map_id = FindKeyframe(keyframe)->map_id;
  point.position = position;
  point.reference = keyframe;
  point.rgb = (*FindKeyframe(keyframe)->features)[feature].rgb;
  AddObservation(point.id, keyframe, feature);
  UpdatePointAppearance(point.id);
  UpdatePointGeometry(point.id);
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
  points_.Erase(point_id);
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

MapPoint* Map::FindPoint(PointId id) {
  return points_.Find(id);
}

const MapPoint* Map::FindPoint(PointId id) const {
  return points_.Find(id);
}

PointId Map::Resolve(PointId id) const {
  for (const auto* merges : {&earlier_merges_, &merges_}) {
    for (auto it = merges->find(id); it != merges->end(); it = merges->find(id)) id = it->second;
  }
  return FindPoint(id) != nullptr ? id : kNoPoint;
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

std::vector<ColouredPoint> Map::ColouredPoints() const {
  std::vector<ColouredPoint> coloured;
  coloured.reserve(points_.size());
  ForEachPoint([&](const MapPoint& point) {
    if (point.map_id != map_id_) return;
    coloured.push_back({point.position.cast<float>(), point.rgb});
  });
  return coloured;
}

}  // namespace semantic_slam
