#include "semantic_slam/object_mapping/object_shape.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace semantic_slam {
namespace {

constexpr double kUpperShare = 0.75;
constexpr int kDirections = 72;       // in which outlines are compared: every 5 degrees
constexpr double kFlatM = 0.002;      // corners that stand out less are none
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
  double quality;
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
          (T_map_keyframe * observation.highest).z(),
          observation.quality};
}

// A number that an observation says, and the observation's quality.
struct Weighted {
  double value;
  double weight;
};

// Three quarters of the weight are at or below it. Precondition: not empty.
double UpperQuartile(std::vector<Weighted> values) {
  std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) {
    return a.value != b.value ? a.value < b.value : a.weight < b.weight;
  });
  double rest = 0.0;
  for (const Weighted& one : values) rest += kUpperShare * one.weight;
  for (const Weighted& one : values) {
    rest -= one.weight;
    if (rest <= 0.0) return one.value;
  }
  return values.back().value;
}

// The placed observations that have such an outline.
std::vector<const Placed*> WithArea(const std::vector<Placed>& placed,
                                    ConvexPolygon Placed::*outline) {
  std::vector<const Placed*> with_area;
  for (const Placed& one : placed) {
    if (!(one.*outline).empty()) with_area.push_back(&one);
  }
  return with_area;
}

// A square around all of the outlines.
ConvexPolygon SquareAround(const std::vector<const Placed*>& placed,
                           ConvexPolygon Placed::*outline) {
  const Eigen::Vector2d c = (placed.front()->*outline).front();
  double reach = 0.0;
  for (const Placed* one : placed) {
    for (const Eigen::Vector2d& p : one->*outline) reach = std::max(reach, (p - c).norm());
  }
  const Eigen::Vector2d right(reach, 0.0), up(0.0, reach);
  return {c - right - up, c + right - up, c + right + up, c - right + up};
}

// The polygon that reaches as far in every direction as the upper quartile of the outlines does;
// the first of them if they have nothing in common. The directions include the sides of the box
// around the first outline, so that rectangles stay so.
ConvexPolygon FusedOutline(const std::vector<Placed>& all, ConvexPolygon Placed::*outline) {
  const std::vector<const Placed*> placed = WithArea(all, outline);
  if (placed.empty()) return {};
  const ConvexPolygon& first = placed.front()->*outline;
  if (placed.size() == 1) return first;
  const double yaw = MinimumAreaRectangle(first).yaw_rad;
  ConvexPolygon fused = SquareAround(placed, outline);
  for (int i = 0; i < kDirections && !fused.empty(); ++i) {
    const double angle = yaw + 2.0 * M_PI * i / kDirections;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    std::vector<Weighted> reaches;
    for (const Placed* one : placed) {
      reaches.push_back({Support(one->*outline, direction), one->quality});
    }
    fused = ClippedByHalfPlane(fused, direction, UpperQuartile(std::move(reaches)));
  }
  fused = Simplified(ConvexHull(std::move(fused)), kFlatM);
  return fused.empty() ? first : fused;
}

// The mean weighed by information, and its covariance, over the observations whose centre lies
// within the fused shape: the others were of something else.
void FusePositions(const std::vector<Placed>& placed, ObjectShape& shape) {
  const auto is_inside = [&](const Placed& one) {
    return Contains(shape.body_m, one.centre.head<2>());
  };
  const bool any_inside = std::any_of(placed.begin(), placed.end(), is_inside);
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  for (const Placed& one : placed) {
    if (any_inside && !is_inside(one)) continue;
    const Eigen::Matrix3d weight = one.covariance.inverse();
    information += weight;
    weighted += weight * one.centre;
  }
  const Eigen::Matrix3d covariance = information.inverse();
  shape.position_m = covariance * weighted;
  shape.covariance_m2 = 0.5 * (covariance + covariance.transpose()) +
                        kPoseSigmaM * kPoseSigmaM * Eigen::Matrix3d::Identity();
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
  std::vector<Weighted> downwards, upwards;  // how far the object reaches
  ObjectShape shape;
  for (const ObjectObservation& observation : observations) {
    if (any_complete && !observation.complete) continue;
    placed.push_back(Place(observation, keyframe_pose(observation.keyframe_id)));
    downwards.push_back({-placed.back().lowest, observation.quality});
    upwards.push_back({placed.back().highest, observation.quality});
    shape.below += observation.below;
  }
  shape.body_m = FusedOutline(placed, &Placed::body);
  shape.outline_m = FusedOutline(placed, &Placed::outline);
  if (shape.body_m.empty()) return std::nullopt;
  if (shape.outline_m.empty()) shape.outline_m = shape.body_m;
  FusePositions(placed, shape);
  shape.box = MinimumAreaRectangle(shape.body_m);
  shape.min_height_m = -UpperQuartile(std::move(downwards));
  shape.max_height_m = UpperQuartile(std::move(upwards));
  return shape;
}

Overlap OverlapOf(const ObjectShape& a, const ObjectShape& b) {
  const double reach = 0.5 * (a.box.size.norm() + b.box.size.norm()) + 4.0 * kMaxMarginM;
  if ((a.box.centre - b.box.centre).squaredNorm() > reach * reach) return {};
  const UprightBox box_a(a), box_b(b);
  const double height = std::min(box_a.high, box_b.high) - std::max(box_a.low, box_b.low);
  if (height <= 0.0) return {};
  const double common = height * Area(Intersection(box_a.base, box_b.base));
  const double volume_a = box_a.Volume(), volume_b = box_b.Volume();
  return {common / (volume_a + volume_b - common), common / std::min(volume_a, volume_b)};
}

}  // namespace semantic_slam
