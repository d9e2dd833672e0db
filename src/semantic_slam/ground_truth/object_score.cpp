#include "semantic_slam/ground_truth/object_score.h"

#include <cmath>
#include <limits>
#include <utility>

#include "semantic_slam/common/assignment.h"
#include "semantic_slam/object_mapping/object_shape.h"

namespace semantic_slam {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

ObjectShape ShapeOf(const MapObject& object) {
  const Eigen::Matrix3d R = object.T_map_box.linear();
  ObjectShape shape;
  shape.box.centre = object.T_map_box.translation().head<2>();
  shape.box.size = object.box_size_m.head<2>();
  shape.box.yaw_rad = std::atan2(R(1, 0), R(0, 0));
  shape.min_height_m = object.min_height_m;
  shape.max_height_m = object.max_height_m;
  return shape;
}

LabelId ClassOf(const MapObject& object) {
  return object.labels.empty() ? kUnknownLabel : object.labels.front().label;
}

double CentreDistance(const MapObject& a, const MapObject& b) {
  return (a.T_map_box.translation() - b.T_map_box.translation()).norm();
}

// Of taking one for the other; kNever if they are too far from each other.
double MatchCost(const MapObject& truth, const MapObject& estimate,
                 const ObjectScoreOptions& options) {
  const double distance_m = CentreDistance(truth, estimate);
  const bool may_match =
      distance_m <= options.max_distance_m ||
      OverlapOf(ShapeOf(truth), ShapeOf(estimate)).of_smaller >= options.min_overlap;
  if (!may_match) return kNever;
  return distance_m + (ClassOf(truth) == ClassOf(estimate) ? 0.0 : options.other_class_m);
}

std::vector<AssignedPair> MatchObjects(const std::vector<MapObject>& truth,
                                       const std::vector<MapObject>& estimate,
                                       const ObjectScoreOptions& options) {
  if (truth.empty() || estimate.empty()) return {};
  Eigen::MatrixXd cost(truth.size(), estimate.size());
  double limit = 1.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < estimate.size(); ++j) {
      cost(i, j) = MatchCost(truth[i], estimate[j], options);
      if (cost(i, j) < kNever) limit = std::max(limit, 2.0 * cost(i, j));
    }
  }
  return AssignAtLeastCost(cost, limit);
}

ObjectMatch Compare(const MapObject& truth, const MapObject& estimate) {
  ObjectMatch match;
  match.right_class = ClassOf(truth) == ClassOf(estimate);
  match.position_error_m = (truth.position_m - estimate.position_m).head<2>().norm();
  match.box_error_m =
      (truth.T_map_box.translation() - estimate.T_map_box.translation()).head<2>().norm();
  match.height_error_m = std::abs(truth.max_height_m - estimate.max_height_m);
  match.size_error_m = (truth.box_size_m - estimate.box_size_m).head<2>().cwiseAbs().mean();
  return match;
}

ErrorStatistics SummaryOf(const std::vector<ObjectMatch>& matches, double ObjectMatch::*error) {
  std::vector<double> errors;
  for (const ObjectMatch& match : matches) errors.push_back(match.*error);
  return Summarise(std::move(errors));
}

}  // namespace

MapObject InWorld(const MapObject& object, const Rigid3d& T_world_map) {
  const Eigen::Matrix3d& R = T_world_map.linear();
  const Eigen::Vector3d centre = object.T_map_box.translation();
  Rigid3d T = Rigid3d(Eigen::AngleAxisd(std::atan2(R(1, 0), R(0, 0)), Eigen::Vector3d::UnitZ()));
  T.pretranslate(T_world_map * centre - T * centre);
  MapObject moved = object;
  moved.position_m = T * object.position_m;
  moved.T_map_box = T * object.T_map_box;
  moved.min_height_m += T.translation().z();
  moved.max_height_m += T.translation().z();
  for (Eigen::Vector2d& corner : moved.footprint_m) {
    corner = (T * Eigen::Vector3d(corner.x(), corner.y(), 0.0)).head<2>();
  }
  return moved;
}

ObjectScore ScoreObjects(const std::vector<MapObject>& truth,
                         const std::vector<MapObject>& estimate, const Rigid3d& T_world_map,
                         const std::vector<bool>& is_expected, const ObjectScoreOptions& options) {
  Validate(options);
  std::vector<MapObject> placed;
  for (const MapObject& object : estimate) placed.push_back(InWorld(object, T_world_map));
  std::vector<bool> is_matched(estimate.size(), false), is_found(truth.size(), false);
  ObjectScore score;
  for (const AssignedPair& pair : MatchObjects(truth, placed, options)) {
    is_matched[pair.column] = is_found[pair.row] = true;
    if (!is_expected[pair.row]) continue;
    ObjectMatch match = Compare(truth[pair.row], placed[pair.column]);
    match.truth = static_cast<std::size_t>(pair.row);
    match.estimate = static_cast<std::size_t>(pair.column);
    score.matches.push_back(match);
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!is_expected[i]) continue;
    ++score.expected;
    if (!is_found[i]) score.missed.push_back(i);
  }
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    if (!is_matched[i]) score.extra.push_back(i);
  }
  return score;
}

std::size_t ObjectScore::right_class() const {
  std::size_t count = 0;
  for (const ObjectMatch& match : matches) count += match.right_class;
  return count;
}

ErrorStatistics ObjectScore::position_m() const {
  return SummaryOf(matches, &ObjectMatch::position_error_m);
}

ErrorStatistics ObjectScore::box_m() const {
  return SummaryOf(matches, &ObjectMatch::box_error_m);
}

ErrorStatistics ObjectScore::height_m() const {
  return SummaryOf(matches, &ObjectMatch::height_error_m);
}

ErrorStatistics ObjectScore::size_m() const {
  return SummaryOf(matches, &ObjectMatch::size_error_m);
}

}  // namespace semantic_slam
