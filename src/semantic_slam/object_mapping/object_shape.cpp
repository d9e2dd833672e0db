#include "semantic_slam/object_mapping/object_shape.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace semantic_slam {
namespace {

constexpr double kUpperQuantile = 0.75;
constexpr int kDirections = 72;       // in which outlines are compared: every 5 degrees
constexpr double kPoseSigmaM = 0.01;  // common to all observations: no number of them removes it
constexpr double kMarginShare =
    0.25;  // of an object's longest side, that its box is made thicker by
constexpr double kMaxMarginM = 0.05;

// An observation with today's pose of its keyframe.
struct Placed {
  Eigen::Vector3d centre;
  Eigen::Matrix3d covariance;
  ConvexPolygon outline;
  ConvexPolygon body;
  double lowest;
  double highest;
};

ConvexPolygon SeenFromAbove(const std::vector<Eigen::Vector3d>& corners,
                            const Rigid3d& T_map_keyframe) {
  std::vector<Eigen::Vector2d> projected;
  for (const Eigen::Vector3d& corner : corners) {
    projected.push_back((T_map_keyframe * corner).head<2>());
  }
  return ConvexHull(std::move(projected));
}

Placed Place(const ObjectObservation& observation, const Rigid3d& T_map_keyframe) {
  const Eigen::Matrix3d R = T_map_keyframe.linear();
  return {T_map_keyframe * observation.centre,
          R * observation.covariance_m2 * R.transpose(),
          SeenFromAbove(observation.outline, T_map_keyframe),
          SeenFromAbove(observation.body, T_map_keyframe),
          (T_map_keyframe * observation.lowest).z(),
          (T_map_keyframe * observation.highest).z()};
}

double UpperQuantile(std::vector<double> values) {
  const auto rank = static_cast<std::ptrdiff_t>(
      std::lround(kUpperQuantile * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

// The polygon that reaches as far in every direction as the upper quartile of `polygons` does; the
// first of them if they have nothing in common. The directions include the sides of the box around
// the first polygon, so that rectangles stay so.
ConvexPolygon FusedOutline(const std::vector<const ConvexPolygon*>& polygons) {
  if (polygons.empty()) return {};
  if (polygons.size() == 1) return *polygons.front();
  const double yaw = MinimumAreaRectangle(*polygons.front()).yaw_rad;
  const Eigen::Vector2d middle = polygons.front()->front();
  double reach = 0.0;
  for (const ConvexPolygon* polygon : polygons) {
    for (const Eigen::Vector2d& p : *polygon) reach = std::max(reach, (p - middle).norm());
  }
  ConvexPolygon fused{
      middle + Eigen::Vector2d(-reach, -reach), middle + Eigen::Vector2d(reach, -reach),
      middle + Eigen::Vector2d(reach, reach), middle + Eigen::Vector2d(-reach, reach)};
  for (int i = 0; i < kDirections && !fused.empty(); ++i) {
    const double angle = yaw + 2.0 * M_PI * i / kDirections;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    std::vector<double> supports;
    for (const ConvexPolygon* polygon : polygons) supports.push_back(Support(*polygon, direction));
    fused = ClippedByHalfPlane(fused, direction, UpperQuantile(std::move(supports)));
  }
  fused = ConvexHull(std::move(fused));
  return fused.empty() ? *polygons.front() : fused;
}

// The mean weighed by information, and its covariance.
void FusePositions(const std::vector<Placed>& placed, ObjectShape& shape) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  for (const Placed& one : placed) {
    const Eigen::Matrix3d weight = one.covariance.inverse();
    information += weight;
    weighted += weight * one.centre;
  }
  const Eigen::Matrix3d covariance = information.inverse();
  shape.position_m = covariance * weighted;
  shape.covariance_m2 = 0.5 * (covariance + covariance.transpose()) +
                        kPoseSigmaM * kPoseSigmaM * Eigen::Matrix3d::Identity();
}

std::vector<const ConvexPolygon*> WithArea(const std::vector<Placed>& placed,
                                           ConvexPolygon Placed::*polygon) {
  std::vector<const ConvexPolygon*> polygons;
  for (const Placed& one : placed) {
    if (!(one.*polygon).empty()) polygons.push_back(&(one.*polygon));
  }
  return polygons;
}

// The box around an object, thicker by its margin.
struct UprightBox {
  ConvexPolygon base;
  double low, high;

  explicit UprightBox(const ObjectShape& shape) {
    const double height = shape.max_height_m - shape.min_height_m;
    const double margin =
        std::min(kMaxMarginM, kMarginShare * std::max(shape.box.size.x(), height));
    const Eigen::Vector2d x(std::cos(shape.box.yaw_rad), std::sin(shape.box.yaw_rad)),
        y(-x.y(), x.x());
    const double dx = 0.5 * shape.box.size.x() + margin, dy = 0.5 * shape.box.size.y() + margin;
    const Eigen::Vector2d c = shape.box.centre;
    base = {c - dx * x - dy * y, c + dx * x - dy * y, c + dx * x + dy * y, c - dx * x + dy * y};
    low = shape.min_height_m - margin;
    high = shape.max_height_m + margin;
  }

  double Volume() const { return Area(base) * (high - low); }
};

}  // namespace

std::optional<ObjectShape> FuseObservations(const std::vector<ObjectObservation>& observations,
                                            const KeyframePoseOf& keyframe_pose) {
  const bool any_complete = std::any_of(observations.begin(), observations.end(),
                                        [](const ObjectObservation& o) { return o.complete; });
  std::vector<Placed> placed;
  std::vector<double> depths_below, heights;  // -lowest and highest: of both the upper quartile
  ObjectShape shape;
  for (const ObjectObservation& observation : observations) {
    if (any_complete && !observation.complete) continue;
    placed.push_back(Place(observation, keyframe_pose(observation.keyframe_id)));
    depths_below.push_back(-placed.back().lowest);
    heights.push_back(placed.back().highest);
    shape.below += observation.below;
  }
  if (placed.empty()) return std::nullopt;
  FusePositions(placed, shape);
  shape.body_m = FusedOutline(WithArea(placed, &Placed::body));
  shape.outline_m = FusedOutline(WithArea(placed, &Placed::outline));
  if (shape.body_m.empty()) return std::nullopt;
  if (shape.outline_m.empty()) shape.outline_m = shape.body_m;
  shape.box = MinimumAreaRectangle(shape.body_m);
  shape.min_height_m = -UpperQuantile(std::move(depths_below));
  shape.max_height_m = UpperQuantile(std::move(heights));
  return shape;
}

Overlap OverlapOf(const ObjectShape& a, const ObjectShape& b) {
  const UprightBox box_a(a), box_b(b);
  const double height = std::min(box_a.high, box_b.high) - std::max(box_a.low, box_b.low);
  const double reach = 0.5 * (a.box.size.norm() + b.box.size.norm()) + 4.0 * kMaxMarginM;
  if (height <= 0.0 || (a.box.centre - b.box.centre).norm() > reach) return {};
  const double common = height * Area(Intersection(box_a.base, box_b.base));
  const double volume_a = box_a.Volume(), volume_b = box_b.Volume();
  return {common / (volume_a + volume_b - common), common / std::min(volume_a, volume_b)};
}

}  // namespace semantic_slam
