#include "semantic_slam/loop_closing/loop_detector.h"

#include <algorithm>
#include <mutex>
#include <set>

#include "semantic_slam/loop_closing/guided_matching.h"
#include "semantic_slam/loop_closing/place_points.h"
#include "semantic_slam/tracking/relocalizer.h"

namespace semantic_slam {
namespace {

constexpr int kNeighboursToAsk = 5;    // of the keyframe, to confirm
constexpr int kConnectingPoints = 15;  // shared with a keyframe that counts as a neighbour

}  // namespace

// What detection needs to know of the keyframe, copied from the map.
struct LoopDetector::View {
  struct Neighbour {
    std::shared_ptr<const FrameFeatures> features;
    Rigid3d T_keyframe_neighbour;
  };
  KeyframeId id;
  std::shared_ptr<const FrameFeatures> features;
  std::vector<Neighbour> neighbours;
};

LoopDetector::LoopDetector(const LoopDetectorOptions& options, const PlaceIndex& index,
                           const Map& map)
    : options_(Validated(options)), noise_{options.depth_sigma_at_1m_m}, index_(index), map_(map) {}

std::optional<Loop> LoopDetector::Detect(KeyframeId keyframe_id, const CameraModel& camera) const {
  View view{keyframe_id, nullptr, {}};
  {
    std::lock_guard<std::mutex> lock(map_.mutex());
    const Keyframe* keyframe = map_.FindKeyframe(keyframe_id);
    if (keyframe == nullptr || !map_.IsPresent(*keyframe)) return std::nullopt;
    view.features = keyframe->features;
    const Rigid3d T_keyframe_map = keyframe->T_map_camera.inverse();
    for (const KeyframeId id : map_.BestCovisible(keyframe_id, kNeighboursToAsk)) {
      const Keyframe& neighbour = *map_.FindKeyframe(id);
      view.neighbours.push_back({neighbour.features, T_keyframe_map * neighbour.T_map_camera});
    }
  }
  for (const KeyframeId place : Candidates(keyframe_id, *view.features)) {
    if (auto loop = Verify(view, place, camera)) return loop;
  }
  return std::nullopt;
}

// The best-scored keyframes that are not connected with this one, no two of one place.
std::vector<KeyframeId> LoopDetector::Candidates(KeyframeId keyframe_id,
                                                 const FrameFeatures& features) const {
  const std::vector<PlaceScore> ranked = index_.Query(features);
  std::lock_guard<std::mutex> lock(map_.mutex());
  const Keyframe* keyframe = map_.FindKeyframe(keyframe_id);
  if (keyframe == nullptr) return {};
  std::set<KeyframeId> excluded{keyframe_id};
  const auto exclude_around = [&](KeyframeId id) {
    excluded.insert(id);
    for (const auto& entry : map_.FindKeyframe(id)->covisible) excluded.insert(entry.first);
  };
  for (const auto& [id, shared] : keyframe->covisible) exclude_around(id);
  double reference_score = 0.0;
  for (const PlaceScore& place : ranked) {
    const auto shared = keyframe->covisible.find(place.keyframe);
    if (shared == keyframe->covisible.end() || shared->second < kConnectingPoints) continue;
    reference_score = place.score;
    break;
  }
  std::vector<KeyframeId> candidates;
  for (const PlaceScore& place : ranked) {
    if (place.score < options_.min_score_share * reference_score) break;
    if (excluded.count(place.keyframe) > 0 || map_.FindKeyframe(place.keyframe) == nullptr)
      continue;
    candidates.push_back(place.keyframe);
    if (static_cast<int>(candidates.size()) == options_.max_candidates) break;
    exclude_around(place.keyframe);
  }
  return candidates;
}

std::optional<Loop> LoopDetector::Verify(const View& view, KeyframeId place_id,
                                         const CameraModel& camera) const {
  KnownView known;
  std::shared_ptr<const FrameFeatures> place_features;
  std::vector<MapPoint> place_points;
  {
    std::lock_guard<std::mutex> lock(map_.mutex());
    const Keyframe* place = map_.FindKeyframe(place_id);
    if (place == nullptr) return std::nullopt;
    known = ViewOf(*place, map_);
    place_features = place->features;  // which `known` points into
    place_points = PointsAround(place_id, map_);
  }
  const auto found =
      Relocalize(*view.features, known, map_.scales(), camera, noise_, options_.min_ransac_inliers);
  if (!found) return std::nullopt;
  Relocalization refined =
      MatchAround(place_points, *view.features, found->T_map_camera, map_.scales(), camera, noise_);
  if (refined.inliers < options_.min_inliers ||
      !IsConfirmed(view, refined.T_map_camera, place_points, camera)) {
    return std::nullopt;
  }
  return Loop{view.id, place_id, refined.T_map_camera, std::move(refined.points)};
}

// Whether enough neighbours of the keyframe see the place too, if they are where the loop puts
// them.
bool LoopDetector::IsConfirmed(const View& view, const Rigid3d& T_map_keyframe,
                               const std::vector<MapPoint>& place_points,
                               const CameraModel& camera) const {
  int confirmed = 0;
  for (const View::Neighbour& neighbour : view.neighbours) {
    const Relocalization found =
        MatchAround(place_points, *neighbour.features,
                    T_map_keyframe * neighbour.T_keyframe_neighbour, map_.scales(), camera, noise_);
    confirmed += found.inliers >= options_.min_confirming_inliers;
  }
  return confirmed >= options_.confirming_keyframes;
}

}  // namespace semantic_slam
