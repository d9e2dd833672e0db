#include "semantic_slam/tracking/local_points.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "semantic_slam/tracking/projection_matcher.h"

namespace semantic_slam {
namespace {

// Search radius on level 0 for a view nearly from the front, and else.
constexpr float kFrontalRadiusPx = 5.0f;
constexpr float kObliqueRadiusPx = 8.0f;
constexpr double kFrontalCosine = 0.998;
constexpr double kMaxRatio = 0.8;
constexpr int kMaxDistance = 60;
constexpr int kNeighboursPerKeyframe = 10;

// Keyframes that share points with the frame, the one that shares most first.
std::vector<KeyframeId> SharingKeyframes(const Map& map, const FrameInWork& frame) {
  std::map<KeyframeId, int> votes;
  for (const PointId id : frame.points) {
    if (id == kNoPoint) continue;
    for (const Observation& o : map.FindPoint(id)->observations) ++votes[o.keyframe];
  }
  if (votes.empty()) votes[frame.reference] = 0;  // its point may be gone; start from what is known
  std::vector<std::pair<int, KeyframeId>> order;
  for (const auto& [id, count] : votes) {
    if (map.FindKeyframe(id) != nullptr) order.emplace_back(-count, id);
  }
  std::sort(order.begin(), order.end());
  std::vector<KeyframeId> sharing;
  for (const auto& entry : order) sharing.push_back(entry.second);
  return sharing;
}

// Features that are not to be matched: they show a point already, or something that moves.
std::vector<bool> Taken(const FrameInWork& frame) {
  std::vector<bool> taken = frame.moves;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (frame.points[i] != kNoPoint) taken[i] = true;
  }
  return taken;
}

}  // namespace

std::vector<PointId> CollectLocalPoints(const Map& map, int max_keyframes, FrameInWork& frame) {
  const std::vector<KeyframeId> sharing = SharingKeyframes(map, frame);
  if (!sharing.empty()) frame.reference = sharing.front();

  std::vector<KeyframeId> local;
  std::set<KeyframeId> seen;
  const auto add = [&](KeyframeId id) {
    if (static_cast<int>(local.size()) < max_keyframes && seen.insert(id).second) {
      local.push_back(id);
    }
  };
  for (const KeyframeId id : sharing) add(id);
  const std::size_t direct = local.size();
  for (std::size_t i = 0; i < direct; ++i) {
    for (const KeyframeId id : map.BestCovisible(local[i], kNeighboursPerKeyframe)) add(id);
  }
  std::vector<PointId> points;
  for (const KeyframeId id : local) {
    for (const PointId point : map.FindKeyframe(id)->points) {
      if (point != kNoPoint) points.push_back(point);
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void MatchLocalPoints(const std::vector<PointId>& local_points, const CameraModel& camera,
                      const LocalMatching& matching, Map& map, FrameInWork& frame) {
  std::set<PointId> matched(frame.points.begin(), frame.points.end());
  for (const PointId id : matched) {
    if (id != kNoPoint) map.FindPoint(id)->visible += matching.count_visible;
  }
  const Rigid3d T_camera_map = frame.T_map_camera.inverse();
  std::vector<ProjectionCandidate> candidates;
  std::vector<PointId> ids;
  for (const PointId id : local_points) {
    if (matched.count(id) > 0) continue;
    MapPoint& point = *map.FindPoint(id);
    const auto view = PredictView(point, T_camera_map, camera, map.scales());
    if (!view) continue;
    point.visible += matching.count_visible;
    const float radius = view->view_cosine > kFrontalCosine ? kFrontalRadiusPx : kObliqueRadiusPx;
    candidates.push_back({view->pixel, matching.widen * radius * map.scales()[view->octave],
                          view->octave - 1, view->octave + 1, 0.0f, &point.descriptor});
    ids.push_back(id);
  }
  ProjectionMatchingOptions options;
  options.max_ratio = kMaxRatio;
  options.max_distance = kMaxDistance;
  const std::vector<int> matches =
      MatchByProjection(candidates, *frame.features, Taken(frame), options);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (matches[i] >= 0) frame.points[matches[i]] = ids[i];
  }
}

}  // namespace semantic_slam
