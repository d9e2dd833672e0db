#include "semantic_slam/map/map_check.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

// So that ids of this map and of many others after it fit into 64 bits.
constexpr KeyframeId kMaxId = std::int64_t{1} << 48;
// What rounding leaves of a rotation that was multiplied many times.
constexpr double kRotationTolerance = 1e-6;

using KeyframesById = std::map<KeyframeId, const Keyframe*>;

void Expect(bool is_sound, const std::string& otherwise) {
  if (!is_sound) throw InputError(otherwise);
}

std::string Name(const Keyframe& keyframe) {
  return "keyframe " + std::to_string(keyframe.id);
}

bool IsRigid(const Rigid3d& T) {
  const Eigen::Matrix3d& R = T.linear();
  return IsFinite(T) && R.determinant() > 0.0 &&
         (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < kRotationTolerance;
}

KeyframesById CheckIds(const MapContents& contents) {
  Expect(contents.next_keyframe >= 0 && contents.next_keyframe <= kMaxId,
         "its next keyframe would be " + std::to_string(contents.next_keyframe));
  KeyframesById by_id;
  KeyframeId previous = kNoKeyframe;
  bool has_present = false;
  for (const Keyframe& keyframe : contents.keyframes) {
    Expect(keyframe.id > previous && keyframe.id < contents.next_keyframe,
           Name(keyframe) + " is out of order");
    Expect(keyframe.map_id >= 0 && keyframe.map_id <= contents.map_id,
           Name(keyframe) + " is of map " + std::to_string(keyframe.map_id) + ", which is none");
    has_present = has_present || keyframe.map_id == contents.map_id;
    previous = keyframe.id;
    by_id.emplace_hint(by_id.end(), keyframe.id, &keyframe);
  }
  Expect(has_present, "its map has no keyframe");
  return by_id;
}

// Whether `id` names a keyframe of that map.
bool IsIn(const KeyframesById& by_id, KeyframeId id, int map_id) {
  const auto found = by_id.find(id);
  return found != by_id.end() && found->second->map_id == map_id;
}

// Whether every keyframe's ancestors end with one that has no parent.
void CheckTree(const KeyframesById& by_id) {
  std::set<KeyframeId> rooted;
  for (const auto& [id, keyframe] : by_id) {
    std::set<KeyframeId> path;
    for (KeyframeId at = id; at != kNoKeyframe && rooted.count(at) == 0;) {
      Expect(path.insert(at).second, Name(*keyframe) + " is among its own ancestors");
      at = by_id.at(at)->parent;
    }
    rooted.insert(path.begin(), path.end());
  }
}

void CheckKeyframes(const MapContents& contents, const KeyframesById& by_id) {
  for (const Keyframe& keyframe : contents.keyframes) {
    Expect(IsRigid(keyframe.T_map_camera), Name(keyframe) + " has a pose that is none");
    Expect(keyframe.parent == kNoKeyframe || IsIn(by_id, keyframe.parent, keyframe.map_id),
           Name(keyframe) + " has a parent that is not there");
  }
  CheckTree(by_id);
}

void CheckCulled(const MapContents& contents, const KeyframesById& by_id) {
  KeyframeId previous = kNoKeyframe;
  for (const CulledKeyframe& culled : contents.culled) {
    const std::string name = "culled keyframe " + std::to_string(culled.id);
    Expect(
        culled.id > previous && culled.id < contents.next_keyframe && by_id.count(culled.id) == 0,
        name + " is out of order");
    Expect(IsIn(by_id, culled.parent, culled.map_id), name + " has a parent that is not there");
    Expect(IsRigid(culled.T_parent_keyframe), name + " has a pose that is none");
    previous = culled.id;
  }
}

// Who sees which point. Each must be seen, and by a keyframe no more than once.
void CheckViews(const MapContents& contents) {
  std::vector<KeyframeId> seen_by(contents.points.size(), kNoKeyframe);  // the last one
  for (const Keyframe& keyframe : contents.keyframes) {
    Expect(keyframe.features != nullptr && keyframe.points.size() == keyframe.features->size(),
           Name(keyframe) + " does not say of each feature which point it shows");
    for (const PointId id : keyframe.points) {
      if (id == kNoPoint) continue;
      Expect(id >= 0 && id < static_cast<PointId>(contents.points.size()) &&
                 contents.points[id].map_id == keyframe.map_id,
             Name(keyframe) + " shows a point that is not there");
      Expect(seen_by[id] != keyframe.id, Name(keyframe) + " shows a point twice");
      seen_by[id] = keyframe.id;
    }
  }
  Expect(std::count(seen_by.begin(), seen_by.end(), kNoKeyframe) == 0,
         "a point is seen by no keyframe");
}

void CheckPoints(const MapContents& contents, const KeyframesById& by_id) {
  for (std::size_t i = 0; i < contents.points.size(); ++i) {
    const MapPoint& point = contents.points[i];
    const std::string name = "point " + std::to_string(i);
    Expect(point.id == static_cast<PointId>(i), name + " is out of order");
    Expect(point.position.allFinite() && point.view_direction.allFinite() &&
               point.min_distance_m >= 0.0 && point.max_distance_m >= point.min_distance_m &&
               point.max_distance_m < 1e9,
           name + " lies nowhere");
    Expect(point.visible >= 0 && point.found >= 0, name + " was seen less than never");
    Expect(IsIn(by_id, point.reference, point.map_id), name + " has no reference keyframe");
  }
}

void CheckLoopEdges(const MapContents& contents, const KeyframesById& by_id) {
  for (const LoopEdge& edge : contents.loop_edges) {
    const auto a = by_id.find(edge.a);
    Expect(a != by_id.end() && IsIn(by_id, edge.b, a->second->map_id) && IsRigid(edge.T_a_b),
           "a loop ties keyframes that are not there");
  }
}

}  // namespace

void CheckMapContents(const MapContents& contents) {
  const KeyframesById by_id = CheckIds(contents);
  CheckKeyframes(contents, by_id);
  CheckCulled(contents, by_id);
  CheckViews(contents);
  CheckPoints(contents, by_id);
  CheckLoopEdges(contents, by_id);
}

}  // namespace semantic_slam
