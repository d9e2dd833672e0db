#include "semantic_slam/local_mapping/local_mapper.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "semantic_slam/local_mapping/point_fusion.h"

namespace semantic_slam {
namespace {

constexpr float kFusionRadiusPx = 3.0f;

}  // namespace

LocalMapper::LocalMapper(const LocalMapperOptions& options,
                         std::shared_ptr<const CameraModel> camera, Map& map)
    : options_(Validated(options)),
      noise_{options.depth_sigma_at_1m_m},
      camera_(std::move(camera)),
      map_(map) {
  Validate(options_.triangulation);
}

void LocalMapper::Reset(std::shared_ptr<const CameraModel> camera) {
  camera_ = std::move(camera);
}

void LocalMapper::Process(KeyframeId keyframe, StageTimer& timer) {
  Window window;
  {
    StageTimer::Scope scope(timer, "local_mapping.triangulate");
    std::lock_guard<std::mutex> lock(map_.mutex());
    if (map_.FindKeyframe(keyframe) == nullptr) return;
    CullYoungPoints(keyframe);
    TriangulateWithNeighbours(keyframe, options_.triangulation, *camera_, noise_, map_);
  }
  {
    StageTimer::Scope scope(timer, "local_mapping.fuse");
    std::lock_guard<std::mutex> lock(map_.mutex());
    if (map_.FindKeyframe(keyframe) == nullptr) return;  // the map was cleared meanwhile
    FuseWithNeighbours(keyframe);
    window = SelectWindow(keyframe);
  }
  BundleSummary summary;
  {
    StageTimer::Scope scope(timer, "local_mapping.bundle_adjustment");
    BundleOptions options;
    options.noise = noise_;
    options.robust_iterations = options_.robust_iterations;
    options.final_iterations = options_.final_iterations;
    summary = AdjustBundle(window.problem, *camera_, options);
  }
  {
    StageTimer::Scope scope(timer, "local_mapping.apply");
    std::lock_guard<std::mutex> lock(map_.mutex());
    if (map_.FindKeyframe(keyframe) == nullptr) return;  // the map was cleared meanwhile
    Apply(window, summary);
    for (const PointId point : window.points) CullPoint(point, keyframe);
    CullKeyframes(keyframe);
    map_.BumpRevision(RevisionReason::kLocalBa);
  }
}

// Those that were made not long ago: local adjustment need not see them again.
void LocalMapper::CullYoungPoints(KeyframeId newest) {
  const auto end = map_.keyframes().upper_bound(newest);
  for (auto it = map_.keyframes().lower_bound(newest - options_.probation_keyframes); it != end;
       ++it) {
    for (const PointId id : PointsOf(*it->second)) {
      const MapPoint* point = map_.FindPoint(id);
      if (point != nullptr && point->reference == it->first) CullPoint(id, newest);
    }
  }
}

// Mur-Artal et al., ORB-SLAM, 2015, section VI.B: on probation a point must be found where it
// should be seen; after that, at any time, in at least three keyframes. The count is what keeps the
// share of well-seen points, by which keyframes are culled, from sinking below what it is worth.
void LocalMapper::CullPoint(PointId id, KeyframeId newest) {
  const MapPoint* point = map_.FindPoint(id);
  if (point == nullptr) return;
  // Its first observation may be of an older keyframe, where fusion has found it.
  const KeyframeId age = newest - point->reference;
  const bool is_seldom_found = point->found < options_.min_found_ratio * point->visible;
  const bool is_seen_by_few =
      static_cast<int>(point->observations.size()) < options_.min_point_keyframes;
  const bool is_mistake = (age <= options_.probation_keyframes && is_seldom_found) ||
                          (age >= options_.probation_keyframes && is_seen_by_few);
  if (is_mistake) map_.ErasePoint(id);
}

void LocalMapper::FuseWithNeighbours(KeyframeId keyframe_id) {
  const std::vector<KeyframeId> neighbours =
      map_.BestCovisible(keyframe_id, options_.fusion_neighbours);
  const std::vector<PointId> own = PointsOf(*map_.FindKeyframe(keyframe_id));
  std::vector<PointId> theirs;
  for (const KeyframeId neighbour : neighbours) {
    FusePoints(own, neighbour, kFusionRadiusPx, *camera_, noise_, map_);
    const std::vector<PointId> points = PointsOf(*map_.FindKeyframe(neighbour));
    theirs.insert(theirs.end(), points.begin(), points.end());
  }
  std::sort(theirs.begin(), theirs.end());
  theirs.erase(std::unique(theirs.begin(), theirs.end()), theirs.end());
  FusePoints(theirs, keyframe_id, kFusionRadiusPx, *camera_, noise_, map_);
  for (const PointId id : PointsOf(*map_.FindKeyframe(keyframe_id))) {
    map_.UpdatePointAppearance(id);
    map_.UpdatePointGeometry(id);
  }
  map_.UpdateCovisibility(keyframe_id);
}

// The new keyframe and those around it move, the keyframes farther out that see the same points
// hold them in place.
LocalMapper::Window LocalMapper::SelectWindow(KeyframeId keyframe_id) const {
  Window window;
  std::map<KeyframeId, int> camera_index;
  const auto add_camera = [&](KeyframeId id, bool fixed) {
    camera_index[id] = static_cast<int>(window.keyframes.size());
    window.keyframes.push_back(id);
    window.problem.cameras.push_back({map_.FindKeyframe(id)->T_map_camera, fixed});
  };
  const auto is_first = [this](KeyframeId id) {
    return map_.FindKeyframe(id)->parent == kNoKeyframe;
  };
  add_camera(keyframe_id, is_first(keyframe_id));
  for (const KeyframeId id : map_.BestCovisible(keyframe_id, options_.window_keyframes - 1)) {
    add_camera(id, is_first(id));
  }
  std::set<PointId> points;
  for (const KeyframeId id : window.keyframes) {
    for (const PointId point : PointsOf(*map_.FindKeyframe(id))) points.insert(point);
  }
  std::map<KeyframeId, int> shared;
  for (const PointId id : points) {
    for (const Observation& o : map_.FindPoint(id)->observations) {
      if (camera_index.count(o.keyframe) == 0) ++shared[o.keyframe];
    }
  }
  std::vector<std::pair<int, KeyframeId>> outside;
  for (const auto& [id, count] : shared) outside.emplace_back(-count, id);
  std::sort(outside.begin(), outside.end());
  if (static_cast<int>(outside.size()) > options_.fixed_keyframes) {
    outside.resize(options_.fixed_keyframes);
  }
  for (const auto& entry : outside) add_camera(entry.second, true);

  for (const PointId id : points) {
    const MapPoint& point = *map_.FindPoint(id);
    const int index = static_cast<int>(window.points.size());
    window.points.push_back(id);
    window.problem.points.push_back(point.position);
    for (const Observation& o : point.observations) {
      const auto camera = camera_index.find(o.keyframe);
      if (camera == camera_index.end()) continue;
      const Feature& feature = (*map_.FindKeyframe(o.keyframe)->features)[o.feature];
      window.problem.observations.push_back({camera->second, index, feature.pixel.cast<double>(),
                                             feature.depth_m, map_.scales()[feature.octave]});
    }
  }
  return window;
}

void LocalMapper::Apply(const Window& window, const BundleSummary& summary) {
  for (std::size_t i = 0; i < window.keyframes.size(); ++i) {
    Keyframe* keyframe = map_.FindKeyframe(window.keyframes[i]);
    if (keyframe != nullptr && !window.problem.cameras[i].fixed) {
      keyframe->T_map_camera = window.problem.cameras[i].T_map_camera;
    }
  }
  for (std::size_t i = 0; i < window.points.size(); ++i) {
    MapPoint* point = map_.FindPoint(window.points[i]);
    if (point != nullptr) point->position = window.problem.points[i];
  }
  for (std::size_t i = 0; i < summary.is_inlier.size(); ++i) {
    if (summary.is_inlier[i]) continue;
    const BundleObservation& o = window.problem.observations[i];
    map_.RemoveObservation(window.points[o.point], window.keyframes[o.camera]);
  }
  for (const PointId id : window.points) {
    if (map_.FindPoint(id) != nullptr) map_.UpdatePointGeometry(id);
  }
}

// Mur-Artal et al., ORB-SLAM, 2015, section VI.E.
void LocalMapper::CullKeyframes(KeyframeId newest) {
  for (const KeyframeId id :
       map_.BestCovisible(newest, static_cast<int>(map_.keyframes().size()))) {
    const Keyframe& keyframe = *map_.FindKeyframe(id);
    if (keyframe.parent != kNoKeyframe && IsRedundant(keyframe)) map_.CullKeyframe(id);
  }
}

// Whether most of its points are seen by enough others, at the same or a finer scale.
bool LocalMapper::IsRedundant(const Keyframe& keyframe) const {
  int points = 0, redundant = 0;
  for (std::size_t i = 0; i < keyframe.points.size(); ++i) {
    const MapPoint* point = map_.FindPoint(keyframe.points[i]);
    if (point == nullptr) continue;
    ++points;
    const int octave = (*keyframe.features)[i].octave;
    int others = 0;
    for (const Observation& o : point->observations) {
      if (o.keyframe == keyframe.id) continue;
      const Keyframe& other = *map_.FindKeyframe(o.keyframe);
      others += (*other.features)[o.feature].octave <= octave + 1;
    }
    redundant += others >= options_.redundant_observations;
  }
  return redundant > options_.redundant_share * points;
}

}  // namespace semantic_slam
