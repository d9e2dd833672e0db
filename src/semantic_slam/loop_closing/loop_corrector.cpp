#include "semantic_slam/loop_closing/loop_corrector.h"

#include <map>
#include <mutex>
#include <utility>

#include "semantic_slam/loop_closing/guided_matching.h"
#include "semantic_slam/loop_closing/map_motion.h"
#include "semantic_slam/loop_closing/place_points.h"

namespace semantic_slam {

LoopCorrector::LoopCorrector(const LoopCorrectorOptions& options, Map& map)
    : options_(Validated(options)), noise_{options.depth_sigma_at_1m_m}, map_(map) {}

bool LoopCorrector::Correct(const Loop& loop, const CameraModel& camera) {
  std::vector<Member> window;
  std::vector<MapPoint> place_points;
  Essential essential;
  RevisionReason reason = RevisionReason::kLoop;
  {
    std::lock_guard<std::mutex> lock(map_.mutex());
    const Keyframe* keyframe = map_.FindKeyframe(loop.keyframe);
    const Keyframe* place = map_.FindKeyframe(loop.place);
    if (keyframe == nullptr || place == nullptr || !map_.IsPresent(*keyframe)) return false;
    if (!map_.IsPresent(*place)) {
      map_.JoinTo(loop.place, loop.T_map_keyframe * keyframe->T_map_camera.inverse());
      reason = RevisionReason::kMerge;
    }
    window = SelectWindow(loop);
    place_points = PointsAround(loop.place, map_);
    essential = BuildEssentialGraph();
  }
  Join(place_points, camera, window);
  const std::vector<LoopEdge> ties =
      Tie(window, loop.place, essential.graph.poses[essential.index.at(loop.place)]);
  for (const LoopEdge& tie : ties) essential.Add(tie);
  OptimizePoseGraph(essential.graph, {options_.translation_sigma_m, options_.rotation_sigma_rad,
                                      options_.max_iterations});
  std::map<KeyframeId, Rigid3d> corrected;
  for (const auto& [id, i] : essential.index) corrected[id] = essential.graph.poses[i];

  std::lock_guard<std::mutex> lock(map_.mutex());
  MoveKeyframes(corrected, map_);
  MergePoints(window);
  for (const LoopEdge& tie : ties) map_.AddLoopEdge(tie);
  map_.BumpRevision(reason);
  return true;
}

// The keyframe and those that share most points with it, moved together.
std::vector<LoopCorrector::Member> LoopCorrector::SelectWindow(const Loop& loop) const {
  const Keyframe& keyframe = *map_.FindKeyframe(loop.keyframe);
  const Rigid3d correction = loop.T_map_keyframe * keyframe.T_map_camera.inverse();
  std::vector<Member> window{{keyframe.id, keyframe.features, loop.T_map_keyframe, loop.points}};
  for (const KeyframeId id : map_.BestCovisible(keyframe.id, options_.window_keyframes - 1)) {
    const Keyframe& neighbour = *map_.FindKeyframe(id);
    window.push_back({id, neighbour.features, correction * neighbour.T_map_camera, {}});
  }
  return window;
}

// Finds the place's points in the window's keyframes; who finds too few is no longer in it.
void LoopCorrector::Join(const std::vector<MapPoint>& place_points, const CameraModel& camera,
                         std::vector<Member>& window) const {
  std::vector<Member> joined;
  for (Member& member : window) {
    Relocalization found = MatchAround(place_points, *member.features, member.T_map_camera,
                                       map_.scales(), camera, noise_);
    if (found.inliers < options_.min_joint_points) continue;
    member.T_map_camera = found.T_map_camera;
    member.points = std::move(found.points);
    joined.push_back(std::move(member));
  }
  window = std::move(joined);
}

LoopCorrector::Essential LoopCorrector::BuildEssentialGraph() const {
  Essential essential;
  PoseGraph3d& graph = essential.graph;
  for (const auto& [id, keyframe] : map_.keyframes()) {
    if (!map_.IsPresent(*keyframe)) continue;
    essential.index[id] = static_cast<int>(graph.poses.size());
    graph.fixed.push_back(graph.poses.empty());  // the first holds the map where it is
    graph.poses.push_back(keyframe->T_map_camera);
  }
  const auto tie = [&](const Keyframe& a, KeyframeId b) {
    const Rigid3d T_a_b = a.T_map_camera.inverse() * map_.FindKeyframe(b)->T_map_camera;
    graph.edges.push_back({essential.index.at(a.id), essential.index.at(b), T_a_b, 1.0});
  };
  for (const auto& [id, keyframe] : map_.keyframes()) {
    if (!map_.IsPresent(*keyframe)) continue;
    if (keyframe->parent != kNoKeyframe && !keyframe->is_joint) tie(*keyframe, keyframe->parent);
    for (const auto& [other, shared] : keyframe->covisible) {
      if (other < id && other != keyframe->parent && shared >= options_.min_covisible_points) {
        tie(*keyframe, other);
      }
    }
  }
  for (const LoopEdge& edge : map_.loop_edges()) essential.Add(edge);
  return essential;
}

void LoopCorrector::Essential::Add(const LoopEdge& edge) {
  const auto a = index.find(edge.a), b = index.find(edge.b);
  if (a == index.end() || b == index.end()) return;
  graph.edges.push_back({a->second, b->second, edge.T_a_b, 1.0});
}

std::vector<LoopEdge> LoopCorrector::Tie(const std::vector<Member>& window, KeyframeId place,
                                         const Rigid3d& T_map_place) {
  std::vector<LoopEdge> ties;
  for (const Member& member : window) {
    ties.push_back({place, member.id, T_map_place.inverse() * member.T_map_camera});
  }
  return ties;
}

// Features that show one of the place's points get it; what they showed until now is the same.
void LoopCorrector::MergePoints(const std::vector<Member>& window) {
  for (const Member& member : window) {
    const Keyframe* keyframe = map_.FindKeyframe(member.id);
    if (keyframe == nullptr) continue;
    for (std::size_t i = 0; i < member.points.size(); ++i) {
      const PointId old = map_.Resolve(member.points[i]);
      if (old == kNoPoint) continue;
      const PointId present = keyframe->points[i];
      if (present == kNoPoint) {
        map_.AddObservation(old, member.id, static_cast<int>(i));
      } else if (present != old) {
        map_.MergePoints(present, old);
      }
    }
    map_.UpdateCovisibility(member.id);
  }
}

}  // namespace semantic_slam
