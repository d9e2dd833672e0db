#include "semantic_slam/loop_closing/guided_matching.h"

#include "semantic_slam/tracking/pose_optimizer.h"
#include "semantic_slam/tracking/projection_matcher.h"

namespace semantic_slam {
namespace {

constexpr float kRadiusPx = 8.0f;  // on pyramid level 0
constexpr int kMaxDistance = 60;
constexpr double kMaxRatio = 0.9;

struct PredictedPoint {
  const MapPoint* point;
  PredictedView view;
};

std::vector<PredictedPoint> VisiblePoints(const std::vector<MapPoint>& points,
                                          const Rigid3d& T_camera_map, const CameraModel& camera,
                                          const std::vector<float>& scales) {
  std::vector<PredictedPoint> visible;
  for (const MapPoint& point : points) {
    if (const auto view = PredictView(point, T_camera_map, camera, scales)) {
      visible.push_back({&point, *view});
    }
  }
  return visible;
}

std::vector<int> FindFeatures(const std::vector<PredictedPoint>& visible,
                              const FrameFeatures& image, const std::vector<float>& scales) {
  std::vector<ProjectionCandidate> candidates;
  for (const auto& [point, view] : visible) {
    candidates.push_back({view.pixel, kRadiusPx * scales[view.octave], view.octave - 1,
                          view.octave + 1, 0.0f, &point->descriptor});
  }
  ProjectionMatchingOptions matching;
  matching.max_distance = kMaxDistance;
  matching.max_ratio = kMaxRatio;
  return MatchByProjection(candidates, image, std::vector<bool>(image.size(), false), matching);
}

}  // namespace

Relocalization MatchAround(const std::vector<MapPoint>& points, const FrameFeatures& image,
                           const Rigid3d& T_map_camera, const std::vector<float>& scales,
                           const CameraModel& camera, const ObservationNoise& noise) {
  const auto visible = VisiblePoints(points, T_map_camera.inverse(), camera, scales);
  const std::vector<int> matches = FindFeatures(visible, image, scales);
  std::vector<PoseObservation> observations;
  std::vector<std::pair<int, PointId>> matched;  // feature, point
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (matches[i] < 0) continue;
    const Feature& feature = image[matches[i]];
    observations.push_back({visible[i].point->position, feature.pixel.cast<double>(),
                            feature.depth_m, scales[feature.octave]});
    matched.emplace_back(matches[i], visible[i].point->id);
  }
  const PoseEstimate estimate = OptimizePose(observations, T_map_camera, camera, noise);
  Relocalization result{estimate.T_map_camera, std::vector<PointId>(image.size(), kNoPoint),
                        estimate.inliers};
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (estimate.is_inlier[i]) result.points[matched[i].first] = matched[i].second;
  }
  return result;
}

}  // namespace semantic_slam
