#include "semantic_slam/loop_closing/full_adjuster.h"

#include <map>
#include <mutex>

#include "semantic_slam/loop_closing/map_motion.h"

namespace semantic_slam {

FullAdjuster::FullAdjuster(const FullAdjusterOptions& options, Map& map)
    : options_(Validated(options)), map_(map) {}

FullAdjuster::Work FullAdjuster::Copy() const {
  std::lock_guard<std::mutex> lock(map_.mutex());
  Work work;
  work.map_id = map_.map_id();
  const std::size_t keyframes = map_.keyframes().size() - map_.dormant_keyframes();
  if (keyframes > static_cast<std::size_t>(options_.max_keyframes)) return work;
  std::map<KeyframeId, int> camera_of;
  for (const auto& [id, keyframe] : map_.keyframes()) {
    if (!map_.IsPresent(*keyframe)) continue;
    camera_of[id] = static_cast<int>(work.keyframes.size());
    work.problem.cameras.push_back({keyframe->T_map_camera, work.keyframes.empty()});
    work.keyframes.push_back(id);
  }
  map_.ForEachPoint([&](const MapPoint& point) {
    if (point.map_id != work.map_id || point.observations.size() < 2) return;
    const int index = static_cast<int>(work.points.size());
    work.points.push_back(point.id);
    work.problem.points.push_back(point.position);
    for (const Observation& o : point.observations) {
      const Feature& feature = (*map_.FindKeyframe(o.keyframe)->features)[o.feature];
      work.problem.observations.push_back({camera_of.at(o.keyframe), index,
                                           feature.pixel.cast<double>(), feature.depth_m,
                                           map_.scales()[feature.octave]});
    }
  });
  return work;
}

void FullAdjuster::Solve(Work& work, const CameraModel& camera) const {
  BundleOptions options;
  options.noise = {options_.depth_sigma_at_1m_m};
  options.robust_iterations = options_.robust_iterations;
  options.final_iterations = options_.final_iterations;
  AdjustBundle(work.problem, camera, options);
}

void FullAdjuster::Apply(const Work& work) {
  std::lock_guard<std::mutex> lock(map_.mutex());
  if (map_.map_id() != work.map_id || work.keyframes.empty()) return;
  std::map<KeyframeId, Rigid3d> adjusted;
  for (std::size_t i = 0; i < work.keyframes.size(); ++i) {
    adjusted[work.keyframes[i]] = work.problem.cameras[i].T_map_camera;
  }
  MoveKeyframes(adjusted, map_);
  for (std::size_t i = 0; i < work.points.size(); ++i) {
    MapPoint* point = map_.FindPoint(work.points[i]);
    if (point != nullptr) point->position = work.problem.points[i];
  }
  map_.BumpRevision(RevisionReason::kLoop);
}

}  // namespace semantic_slam
