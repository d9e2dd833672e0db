#include "semantic_slam/object_mapping/object_geometry.h"

#include <algorithm>
#include <cmath>

#include "semantic_slam/plane_projection/footprint.h"

namespace semantic_slam {
namespace {

using Points = std::vector<Eigen::Vector3f>;

// How exactly the mean of the points in view tells where an object's centre is.
constexpr double kSurfaceSigmaM = 0.01;     // of the mean of many readings: calibration, pose
constexpr double kDepthSigmaPerM2 = 0.003;  // along the line of sight, times depth squared
constexpr double kCentreShare = 0.1;        // of the object's size: only its near side is in view
constexpr double kCutOff = 5.0;             // as many times worse if part of it is out of view

Points Rotated(const Points& points, const Eigen::Matrix3d& R) {
  const Eigen::Matrix3f rotation = R.cast<float>();
  Points rotated;
  rotated.reserve(points.size());
  for (const Eigen::Vector3f& p : points) rotated.push_back(rotation * p);
  return rotated;
}

Eigen::Vector3d Mean(const Points& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) sum += p.cast<double>();
  return sum / static_cast<double>(points.size());
}

Eigen::Matrix3d CentreCovariance(const Eigen::Vector3d& centre_camera, const Footprint& footprint,
                                 bool complete) {
  const Rectangle rectangle = MinimumAreaRectangle(footprint.body_m);
  const double height_m = footprint.max_height_m - footprint.min_height_m;
  const double size_m = std::max(rectangle.size.x(), height_m);
  const double along = kDepthSigmaPerM2 * centre_camera.squaredNorm();
  const double across = kSurfaceSigmaM + kCentreShare * size_m;
  const Eigen::Vector3d sight = centre_camera.normalized();
  const Eigen::Matrix3d covariance =
      across * across * Eigen::Matrix3d::Identity() + along * along * sight * sight.transpose();
  return complete ? covariance : Eigen::Matrix3d(kCutOff * kCutOff * covariance);
}

// Lines of sight to everything in the box.
std::vector<Sight> Sights(const Points& object, const Points& others) {
  std::vector<Sight> sights;
  sights.reserve(object.size() + others.size());
  for (const Eigen::Vector3f& p : object) sights.push_back({p, true});
  for (const Eigen::Vector3f& p : others) sights.push_back({p, false});
  return sights;
}

// Takes level coordinates (axes of the map, origin at the camera) to the keyframe's.
struct ToKeyframe {
  Rigid3d T_keyframe_level;

  std::vector<Eigen::Vector3d> operator()(const ConvexPolygon& polygon, double height_m) const {
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector2d& p : polygon) {
      corners.push_back(T_keyframe_level * Eigen::Vector3d(p.x(), p.y(), height_m));
    }
    return corners;
  }
};

}  // namespace

std::optional<ObjectObservation> MeasureObject(const ObjectPoints& points,
                                               const Eigen::Matrix3d& R_map_camera,
                                               KeyframeId keyframe_id,
                                               const Rigid3d& T_keyframe_camera,
                                               const TopPlaneOptions& top_plane,
                                               const HollownessOptions& hollowness) {
  const Points level = Rotated(points.object, R_map_camera);
  const auto top = FindTopPlane(level, top_plane);
  const auto footprint = ProjectFootprint(level, top);
  if (!footprint) return std::nullopt;
  ObjectObservation observation;
  if (top) {
    const auto sights = Sights(level, Rotated(points.others, R_map_camera));
    observation.below =
        LookBelow(footprint->outline_m, top->height_m, Eigen::Vector3f::Zero(), sights, hollowness);
  }
  const Eigen::Vector3d centre_camera = Mean(points.object);
  const Eigen::Matrix3d R_keyframe_camera = T_keyframe_camera.linear();
  const ToKeyframe to_keyframe{T_keyframe_camera *
                               Rigid3d(Eigen::Quaterniond(R_map_camera.transpose()))};
  const Eigen::Vector3d centre_level = R_map_camera * centre_camera;
  const auto at_height = [&](double height_m) -> Eigen::Vector3d {
    return to_keyframe.T_keyframe_level *
           Eigen::Vector3d(centre_level.x(), centre_level.y(), height_m);
  };
  observation.keyframe_id = keyframe_id;
  observation.centre = T_keyframe_camera * centre_camera;
  observation.covariance_m2 = R_keyframe_camera *
                              CentreCovariance(centre_camera, *footprint, points.complete) *
                              R_keyframe_camera.transpose();
  observation.outline = to_keyframe(footprint->outline_m, top ? top->height_m : centre_level.z());
  observation.body = to_keyframe(footprint->body_m, centre_level.z());
  observation.lowest = at_height(footprint->min_height_m);
  observation.highest = at_height(footprint->max_height_m);
  observation.complete = points.complete;
  observation.quality = static_cast<double>(points.object.size()) / centre_camera.squaredNorm();
  return observation;
}

}  // namespace semantic_slam
