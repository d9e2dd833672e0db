#include "semantic_slam/tracking/pose_fitter.h"

#include <algorithm>

#include "semantic_slam/tracking/projection_matcher.h"

namespace semantic_slam {
namespace {

// A match to the last image is believed with this much support; else it was made in the wrong
// place.
constexpr int kMinInliersFromLast = 20;
constexpr double kMinInlierShareFromLast = 0.25;

PoseObservation Observe(const Eigen::Vector3d& p_map, const Feature& feature,
                        const std::vector<float>& scales, const CameraModel& camera) {
  return {p_map, feature.exposed.cast<double>(), feature.depth_m, scales[feature.octave],
          camera.RowFraction(feature.raw.y())};
}

}  // namespace

PoseFitter::PoseFitter(double depth_sigma_at_1m_m, const ReadoutOptions& readout_options,
                       std::shared_ptr<const CameraModel> camera, Map& map)
    : noise_{depth_sigma_at_1m_m},
      camera_(std::move(camera)),
      map_(map),
      readout_(readout_options, camera_->intrinsics().readout_s) {}

void PoseFitter::Reset(std::shared_ptr<const CameraModel> camera) {
  if (!(camera->intrinsics() == camera_->intrinsics()))
    readout_.Reset(camera->intrinsics().readout_s);
  camera_ = std::move(camera);
}

// What the rows of the frame tell apart; nothing if the shutter is known not to roll.
std::optional<RollingShutter> PoseFitter::Shutter(const FrameInWork& frame) const {
  if (!readout_.is_rolling()) return std::nullopt;
  return RollingShutter{readout_.readout_s(), frame.twist, readout_.turn_sigma_radps()};
}

void PoseFitter::Rectify(FrameInWork& frame, const CameraTwist& twist) const {
  if (!readout_.is_rolling()) return;
  frame.twist = twist;
  frame.features = frame.features->Rectified(twist, readout_.readout_s(), *camera_);
}

bool PoseFitter::MatchNear(const KnownView& view, const Rigid3d& T_map_predicted, double radius_px,
                           FrameInWork& frame) const {
  const Rigid3d T_camera_map = T_map_predicted.inverse();
  std::vector<ProjectionCandidate> candidates;
  std::vector<const KnownView::Point*> points;
  for (const KnownView::Point& point : view.points) {
    const Eigen::Vector3d p_camera = T_camera_map * point.position;
    if (!(p_camera.z() > 0.0)) continue;
    const Eigen::Vector2f pixel = camera_->Project(p_camera).cast<float>();
    if (!camera_->undistorted_bounds().contains(cv::Point2f(pixel.x(), pixel.y()))) continue;
    const Feature& feature = (*view.features)[point.feature];
    candidates.push_back({pixel, static_cast<float>(radius_px) * map_.scales()[feature.octave],
                          feature.octave - 1, feature.octave + 1, feature.angle_rad,
                          &view.features->descriptor(point.feature)});
    points.push_back(&point);
  }
  ProjectionMatchingOptions matching;
  matching.check_rotation = true;
  const std::vector<int> matches =
      MatchByProjection(candidates, *frame.features, frame.moves, matching);

  std::vector<PoseObservation> observations;
  std::vector<std::pair<int, PointId>> matched;  // feature, point
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (matches[i] < 0) continue;
    observations.push_back(
        Observe(points[i]->position, (*frame.features)[matches[i]], map_.scales(), *camera_));
    matched.emplace_back(matches[i], points[i]->id);
  }
  const PoseEstimate estimate =
      OptimizePose(observations, T_map_predicted, *camera_, noise_, Shutter(frame));
  if (estimate.inliers < kMinInliersFromLast ||
      estimate.inliers < kMinInlierShareFromLast * static_cast<double>(matched.size())) {
    return false;
  }
  Rectify(frame, estimate.twist);
  frame.T_map_camera = estimate.T_map_camera;
  std::fill(frame.points.begin(), frame.points.end(), kNoPoint);
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (estimate.is_inlier[i]) frame.points[matched[i].first] = matched[i].second;
  }
  return true;
}

void PoseFitter::FitToPoints(bool count_found, FrameInWork& frame) {
  std::vector<PoseObservation> observations;
  std::vector<std::size_t> features;
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    if (frame.points[i] == kNoPoint) continue;
    observations.push_back(Observe(map_.FindPoint(frame.points[i])->position, (*frame.features)[i],
                                   map_.scales(), *camera_));
    features.push_back(i);
  }
  const PoseEstimate estimate =
      OptimizePose(observations, frame.T_map_camera, *camera_, noise_, Shutter(frame));
  Rectify(frame, estimate.twist);
  readout_.Add(estimate.readout);
  frame.T_map_camera = estimate.T_map_camera;
  frame.inliers = estimate.inliers;
  frame.covariance = BoundedPoseCovariance(estimate.covariance);
  std::fill(frame.is_inlier.begin(), frame.is_inlier.end(), false);
  for (std::size_t k = 0; k < features.size(); ++k) {
    frame.is_inlier[features[k]] = estimate.is_inlier[k];
    if (estimate.is_inlier[k]) {
      map_.FindPoint(frame.points[features[k]])->found += count_found;
    } else {
      frame.points[features[k]] = kNoPoint;
    }
  }
}

}  // namespace semantic_slam
