#include "semantic_slam/local_mapping/point_fusion.h"

#include <set>

#include "semantic_slam/tracking/projection_matcher.h"

namespace semantic_slam {
namespace {

constexpr int kMaxDistance = 50;

// Of a point's depth and a measured one, that are both noisy.
constexpr double kMaxChi2Depth = 2.0 * kChi2Depth;

// Makes the feature show the point, or the point that it shows and this one the same.
void Join(PointId id, KeyframeId keyframe, int feature, Map& map) {
  const MapPoint* present = map.FindPoint(map.FindKeyframe(keyframe)->points[feature]);
  if (present == nullptr) {
    map.AddObservation(id, keyframe, feature);
  } else if (present->observations.size() > map.FindPoint(id)->observations.size()) {
    map.MergePoints(id, present->id);
  } else {
    map.MergePoints(present->id, id);
  }
}

}  // namespace

bool ShowsPoint(const Feature& feature, const Eigen::Vector3d& p_camera, double pyramid_scale,
                double max_chi2_depth, const CameraModel& camera, const ObservationNoise& noise) {
  const double error_px = (camera.Project(p_camera) - feature.pixel.cast<double>()).norm() /
                          noise.PixelSigma(pyramid_scale);
  if (error_px * error_px > kChi2Pixel) return false;
  if (!feature.has_depth()) return true;
  const double error = (1.0 / p_camera.z() - 1.0 / feature.depth_m) / noise.InverseDepthSigma();
  return error * error <= max_chi2_depth;
}

std::vector<PointId> PointsOf(const Keyframe& keyframe) {
  std::vector<PointId> points;
  for (const PointId id : keyframe.points) {
    if (id != kNoPoint) points.push_back(id);
  }
  return points;
}

void FusePoints(const std::vector<PointId>& points, KeyframeId target_id, float radius_px,
                const CameraModel& camera, const ObservationNoise& noise, Map& map) {
  const Keyframe& target = *map.FindKeyframe(target_id);
  const Rigid3d T_camera_map = target.T_map_camera.inverse();
  const std::set<PointId> seen(target.points.begin(), target.points.end());
  std::vector<ProjectionCandidate> candidates;
  std::vector<PointId> ids;
  for (const PointId id : points) {
    const MapPoint* point = map.FindPoint(id);
    if (point == nullptr || seen.count(id) > 0) continue;
    const auto view = PredictView(*point, T_camera_map, camera, map.scales());
    if (!view) continue;
    candidates.push_back({view->pixel, radius_px * map.scales()[view->octave], view->octave - 1,
                          view->octave + 1, 0.0f, &point->descriptor});
    ids.push_back(id);
  }
  ProjectionMatchingOptions matching;
  matching.max_distance = kMaxDistance;
  const std::vector<int> matches = MatchByProjection(
      candidates, *target.features, std::vector<bool>(target.points.size(), false), matching);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const MapPoint* point = map.FindPoint(ids[i]);
    if (matches[i] < 0 || point == nullptr) continue;
    const Feature& feature = (*target.features)[matches[i]];
    if (ShowsPoint(feature, T_camera_map * point->position, map.scales()[feature.octave],
                   kMaxChi2Depth, camera, noise)) {
      Join(ids[i], target_id, matches[i], map);
    }
  }
}

}  // namespace semantic_slam
