#include "semantic_slam/tracking/relocalizer.h"

#include <algorithm>

#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "semantic_slam/features/matching.h"
#include "semantic_slam/tracking/pose_optimizer.h"

namespace semantic_slam {
namespace {

constexpr int kMinMatches = 12;
constexpr int kRansacIterations = 300;
constexpr float kRansacErrorPx = 5.0f;  // generous: coarse octaves are off by more than a pixel

// The known point that a feature of the frame shows.
struct MatchedPoint {
  const KnownView::Point* point;
  int feature;
};

std::vector<MatchedPoint> MatchPoints(const FrameFeatures& frame, const KnownView& view) {
  std::vector<int> candidates;
  std::vector<const KnownView::Point*> point_of(view.features->size(), nullptr);
  for (const KnownView::Point& point : view.points) {
    candidates.push_back(point.feature);
    point_of[point.feature] = &point;
  }
  std::vector<MatchedPoint> matched;
  for (const FeatureMatch& match :
       MatchDescriptors(*view.features, candidates, frame, DescriptorMatchingOptions())) {
    matched.push_back({point_of[match.a], match.b});
  }
  return matched;
}

std::optional<Rigid3d> PoseByRansac(const std::vector<MatchedPoint>& matched,
                                    const FrameFeatures& frame, const CameraModel& camera) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> pixels;
  for (const MatchedPoint& m : matched) {
    const Eigen::Vector3d& p = m.point->position;
    const Eigen::Vector2f& pixel = frame[m.feature].pixel;
    points.emplace_back(p.x(), p.y(), p.z());
    pixels.emplace_back(pixel.x(), pixel.y());
  }
  const CameraIntrinsics& c = camera.intrinsics();
  const cv::Matx33d K(c.fx_px, 0.0, c.cx_px, 0.0, c.fy_px, c.cy_px, 0.0, 0.0, 1.0);
  cv::Mat rotation_vector, translation;
  std::vector<int> inliers;
  const bool found =
      cv::solvePnPRansac(points, pixels, K, cv::noArray(), rotation_vector, translation, false,
                         kRansacIterations, kRansacErrorPx, 0.99, inliers, cv::SOLVEPNP_AP3P);
  if (!found || static_cast<int>(inliers.size()) < kMinMatches) return std::nullopt;
  cv::Mat rotation;
  cv::Rodrigues(rotation_vector, rotation);
  Eigen::Matrix3d R_camera_map;
  Eigen::Vector3d t_camera_map;
  cv::cv2eigen(rotation, R_camera_map);
  cv::cv2eigen(translation, t_camera_map);
  Rigid3d T_camera_map = Rigid3d::Identity();
  T_camera_map.linear() = R_camera_map;
  T_camera_map.translation() = t_camera_map;
  if (!IsFinite(T_camera_map)) return std::nullopt;
  return T_camera_map.inverse();
}

}  // namespace

KnownView ViewOf(const Keyframe& keyframe, const Map& map) {
  KnownView view{keyframe.features.get(), {}};
  for (std::size_t i = 0; i < keyframe.points.size(); ++i) {
    const MapPoint* point = map.FindPoint(keyframe.points[i]);
    if (point != nullptr) {
      view.points.push_back({static_cast<int>(i), point->position, point->id});
    }
  }
  return view;
}

std::optional<Relocalization> Relocalize(const FrameFeatures& frame, const KnownView& view,
                                         const std::vector<float>& scales,
                                         const CameraModel& camera, const ObservationNoise& noise,
                                         int min_inliers) {
  const std::vector<MatchedPoint> matched = MatchPoints(frame, view);
  if (static_cast<int>(matched.size()) < std::max(kMinMatches, min_inliers)) return std::nullopt;
  const auto start = PoseByRansac(matched, frame, camera);
  if (!start) return std::nullopt;
  std::vector<PoseObservation> observations;
  for (const MatchedPoint& m : matched) {
    const Feature& feature = frame[m.feature];
    observations.push_back({m.point->position, feature.pixel.cast<double>(), feature.depth_m,
                            scales[feature.octave]});
  }
  const PoseEstimate estimate = OptimizePose(observations, *start, camera, noise);
  if (estimate.inliers < min_inliers) return std::nullopt;
  Relocalization result{estimate.T_map_camera, std::vector<PointId>(frame.size(), kNoPoint),
                        estimate.inliers};
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (estimate.is_inlier[i]) result.points[matched[i].feature] = matched[i].point->id;
  }
  return result;
}

}  // namespace semantic_slam
