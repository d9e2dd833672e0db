#include "semantic_slam/tracking/projection_matcher.h"

#include <algorithm>
#include <cmath>

#include "semantic_slam/features/matching.h"

namespace semantic_slam {
namespace {

constexpr double kMinViewCosine = 0.5;  // 60 degrees
// A point may be looked for somewhat beyond the distances at which its patch fits the pyramid.
constexpr double kNearMargin = 0.8;
constexpr double kFarMargin = 1.2;
// At the very distance where it was made a point is on its own octave, whatever the rounding.
constexpr double kOctaveRounding = 1e-3;

struct BestFeature {
  int index = -1;
  int distance = kMaxDescriptorDistance + 1;
  int octave = -1;
  int second_distance = kMaxDescriptorDistance + 1;
  int second_octave = -1;
};

BestFeature FindBest(const ProjectionCandidate& candidate, const FrameFeatures& frame,
                     const std::vector<bool>& is_taken) {
  BestFeature best;
  frame.ForEachNear(candidate.pixel, candidate.radius_px, candidate.min_octave,
                    candidate.max_octave, [&](int i) {
                      if (is_taken[i]) return;
                      const int distance =
                          HammingDistance(*candidate.descriptor, frame.descriptor(i));
                      if (distance < best.distance) {
                        best.second_distance = best.distance;
                        best.second_octave = best.octave;
                        best.distance = distance;
                        best.octave = frame[i].octave;
                        best.index = i;
                      } else if (distance < best.second_distance) {
                        best.second_distance = distance;
                        best.second_octave = frame[i].octave;
                      }
                    });
  return best;
}

bool IsDistinct(const BestFeature& best, double max_ratio) {
  return best.octave != best.second_octave || best.distance <= max_ratio * best.second_distance;
}

void RemoveInconsistentRotations(const std::vector<ProjectionCandidate>& candidates,
                                 const FrameFeatures& frame, std::vector<int>& matches) {
  RotationConsistency rotation;
  std::vector<std::size_t> matched;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (matches[i] < 0) continue;
    rotation.Add(candidates[i].angle_rad, frame[matches[i]].angle_rad);
    matched.push_back(i);
  }
  const std::vector<bool> consistent = rotation.Consistent();
  for (std::size_t k = 0; k < matched.size(); ++k) {
    if (!consistent[k]) matches[matched[k]] = -1;
  }
}

}  // namespace

std::vector<int> MatchByProjection(const std::vector<ProjectionCandidate>& candidates,
                                   const FrameFeatures& frame, const std::vector<bool>& is_taken,
                                   const ProjectionMatchingOptions& options) {
  std::vector<int> matches(candidates.size(), -1);
  std::vector<int> owner(frame.size(), -1);
  std::vector<int> owner_distance(frame.size(), kMaxDescriptorDistance + 1);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const BestFeature best = FindBest(candidates[i], frame, is_taken);
    if (best.index < 0 || best.distance > options.max_distance) continue;
    if (!IsDistinct(best, options.max_ratio)) continue;
    if (best.distance >= owner_distance[best.index]) continue;
    if (owner[best.index] >= 0) matches[owner[best.index]] = -1;
    owner[best.index] = static_cast<int>(i);
    owner_distance[best.index] = best.distance;
    matches[i] = best.index;
  }
  if (options.check_rotation) RemoveInconsistentRotations(candidates, frame, matches);
  return matches;
}

std::optional<PredictedView> PredictView(const MapPoint& point, const Rigid3d& T_camera_map,
                                         const CameraModel& camera,
                                         const std::vector<float>& scales) {
  const Eigen::Vector3d p_camera = T_camera_map * point.position;
  if (!(p_camera.z() > 0.0)) return std::nullopt;
  const Eigen::Vector2f pixel = camera.Project(p_camera).cast<float>();
  if (!camera.undistorted_bounds().contains(cv::Point2f(pixel.x(), pixel.y()))) return std::nullopt;
  const double distance = p_camera.norm();
  if (distance < kNearMargin * point.min_distance_m ||
      distance > kFarMargin * point.max_distance_m) {
    return std::nullopt;
  }
  const Eigen::Vector3d camera_in_map =
      -(T_camera_map.linear().transpose() * T_camera_map.translation());
  const double view_cosine = (camera_in_map - point.position).dot(point.view_direction) / distance;
  if (view_cosine < kMinViewCosine) return std::nullopt;
  const double log_scale = scales.size() > 1 ? std::log(scales[1]) : 1.0;
  const int octave = static_cast<int>(std::ceil(std::log(point.max_distance_m / distance) / log_scale - kOctaveRounding));
  return PredictedView{pixel, std::clamp(octave, 0, static_cast<int>(scales.size()) - 1),
                       view_cosine};
}

}  // namespace semantic_slam
