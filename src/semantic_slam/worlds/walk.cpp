#include <cmath>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {
namespace {

double HeadingOf(const Eigen::Vector2d& direction) {
  return std::atan2(direction.y(), direction.x());
}

Rigid3d FloorPose(const Eigen::Vector2d& at_m, double heading_rad) {
  Rigid3d T = Rigid3d::Identity();
  T.linear() = Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() << at_m, 0.0;
  return T;
}

}  // namespace

Walk::Walk(std::vector<Eigen::Vector2d> corners_m, double speed_mps, double turn_rate_radps)
    : corners_m_(std::move(corners_m)), speed_mps_(speed_mps), turn_rate_radps_(turn_rate_radps) {
  if (corners_m_.size() < 2) throw ConfigError("a walk needs at least two corners");
  if (!(speed_mps > 0.0) || !(turn_rate_radps > 0.0)) {
    throw ConfigError("a walk's speed and turn rate must be positive");
  }
  for (std::size_t i = 0; i < corners_m_.size(); ++i) {
    // 1 cm: less has no direction that a person would call one.
    if (!(Leg(i).norm() > 0.01)) throw ConfigError("a walk's successive corners coincide");
    round_s_ += Leg(i).norm() / speed_mps_ + std::abs(TurnAfter(i)) / turn_rate_radps_;
    round_m_ += Leg(i).norm();
  }
}

Eigen::Vector2d Walk::Leg(std::size_t i) const {
  return corners_m_[(i + 1) % corners_m_.size()] - corners_m_[i % corners_m_.size()];
}

double Walk::TurnAfter(std::size_t i) const {
  return std::remainder(HeadingOf(Leg(i + 1)) - HeadingOf(Leg(i)), 2 * M_PI);
}

Walk::Place Walk::PlaceAt(double time_s) const {
  const double rounds = std::floor(time_s / round_s_);
  Place place;
  place.distance_m = rounds * round_m_;
  double left_s = time_s - rounds * round_s_;
  for (std::size_t i = 0; i < corners_m_.size(); ++i) {
    const double length_m = Leg(i).norm();
    const double turn_rad = TurnAfter(i);
    place.heading_rad = HeadingOf(Leg(i));
    if (left_s * speed_mps_ < length_m) {
      place.at_m = corners_m_[i] + left_s * speed_mps_ * Leg(i) / length_m;
      place.distance_m += left_s * speed_mps_;
      return place;
    }
    left_s -= length_m / speed_mps_;
    place.distance_m += length_m;
    place.at_m = corners_m_[i] + Leg(i);
    if (left_s * turn_rate_radps_ < std::abs(turn_rad)) {
      place.heading_rad += std::copysign(left_s * turn_rate_radps_, turn_rad);
      return place;
    }
    left_s -= std::abs(turn_rad) / turn_rate_radps_;
    place.heading_rad += turn_rad;
  }
  return place;  // rounding: at the very end of a round
}

Rigid3d Walk::Pose(double time_s) const {
  const Place place = PlaceAt(time_s);
  return FloorPose(place.at_m, place.heading_rad);
}

double Walk::Distance(double time_s) const {
  return PlaceAt(time_s).distance_m;
}

}  // namespace semantic_slam
