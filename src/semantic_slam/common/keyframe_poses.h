#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "semantic_slam/common/keyframe_graph.h"

namespace semantic_slam {

// Where the keyframes of a map are now, by id: what maps ask when the graph has changed.
class KeyframePoses {
 public:
  KeyframePoses() = default;
  explicit KeyframePoses(const KeyframeGraph& graph);

  int map_id() const { return map_id_; }
  std::uint64_t revision() const { return revision_; }
  std::size_t size() const { return poses_.size(); }

  // T_map_keyframe, also of culled keyframes; nullopt if the graph does not list it.
  std::optional<Rigid3d> Find(KeyframeId id) const;

 private:
  int map_id_ = 0;
  std::uint64_t revision_ = 0;
  std::unordered_map<KeyframeId, Rigid3d> poses_;
};

// How far a point within `reach_m` of the frame moves at most when its pose changes from `before` to
// `after` [m]: the shift of the origin, and the arc of the rotation.
double Displacement(const Rigid3d& before, const Rigid3d& after, double reach_m);

}  // namespace semantic_slam
