#include "semantic_slam/random_worlds/random_cameras.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "semantic_slam/random_worlds/choice.h"

namespace semantic_slam {
namespace {

constexpr int kTries = 200;
constexpr double kClearanceM = 0.35;
constexpr double kLowestM = 0.4;
constexpr double kHighestM = 2.0;
constexpr double kSmallestM = 0.25;    // what is less large, half its diagonal, is not looked at
constexpr double kLookAtObject = 0.5;  // so often
constexpr double kViewM = 1.5;         // so far, or farther, goes a look into a room
constexpr double kTightM = 0.12;       // a target is that much off the middle of the image
constexpr double kDegree = M_PI / 180;

Eigen::AlignedBox3d BoundsOf(const WorldObject& object) {
  Eigen::AlignedBox3d bounds;
  for (const Surface& surface : object.surfaces) {
    for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
      bounds.extend(object.T_world_object * p.cast<double>());
    }
  }
  return bounds;
}

// How often a class is looked at: the furniture of the thesis' Table 4.1 most, what hangs on walls,
// and is seen anyhow, least.
double WeightOf(const std::string& label) {
  static const std::map<std::string, double> weights{
      {"chair", 3},     {"coffee_table", 5}, {"conference_table", 6},
      {"sofa", 5},      {"whiteboard", 3},   {"desk", 4},
      {"bed", 3},       {"fridge", 2},       {"counter", 2.5},
      {"bookshelf", 3}, {"table", 3},        {"door", 0.5},
      {"window", 0.5},  {"picture", 0.3},    {"curtain", 0.5},
      {"blinds", 0.3}};
  const auto found = weights.find(label);
  return found == weights.end() ? 1.0 : found->second;
}

}  // namespace

RandomCameras::RandomCameras(const World& world, const LabelVocabulary& vocabulary,
                             std::uint64_t seed)
    : clearance_(world), random_(seed) {
  std::map<LabelId, std::vector<Target>> by_label;
  for (const WorldObject& object : world.objects) {
    const Eigen::AlignedBox3d bounds = BoundsOf(object);
    if (object.is_structure) {
      if (object.label == vocabulary.Find("floor")) rooms_m_.push_back(bounds);
    } else if (0.5 * bounds.diagonal().norm() > kSmallestM) {
      by_label[object.label].push_back({bounds.center(), 0.5 * bounds.diagonal().norm()});
    }
  }
  for (const auto& [label, of_class] : by_label) {
    targets_.push_back({of_class, WeightOf(vocabulary[label].name)});
  }
}

std::optional<Rigid3d> RandomCameras::Next() {
  for (int i = 0; i < kTries; ++i) {
    const bool at_object = !targets_.empty() && Chance(random_, kLookAtObject);
    const std::optional<Rigid3d> pose = at_object ? LookAtObject() : LookAbout();
    if (pose) return pose;
  }
  return std::nullopt;
}

bool RandomCameras::IsFree(const Eigen::Vector3d& position_m) const {
  const bool is_inside =
      std::any_of(rooms_m_.begin(), rooms_m_.end(), [&](const Eigen::AlignedBox3d& room) {
        Eigen::Vector3d on_floor = position_m;
        on_floor.z() = room.center().z();
        return room.contains(on_floor);
      });
  return is_inside && clearance_.At(position_m, 0.0).distance_m >= kClearanceM;
}

// Forwards by yaw and pitch (up), with some roll.
Rigid3d RandomCameras::Pose(const Eigen::Vector3d& position_m, double yaw_rad, double pitch_rad) {
  const double roll_rad = std::clamp(4.0 * random_.Gaussian(), -10.0, 10.0) * kDegree;
  const Eigen::Vector3d forward(std::cos(yaw_rad) * std::cos(pitch_rad),
                                std::sin(yaw_rad) * std::cos(pitch_rad), std::sin(pitch_rad));
  const Eigen::Vector3d right(std::sin(yaw_rad), -std::cos(yaw_rad), 0.0);
  Rigid3d T = Rigid3d::Identity();
  T.linear() << right, forward.cross(right), forward;
  T.rotate(Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ()));
  T.translation() = position_m;
  return T;
}

// Towards somewhere in the same room, so that it is not of the next wall alone.
std::optional<Rigid3d> RandomCameras::LookAbout() {
  if (rooms_m_.empty()) return std::nullopt;
  const Eigen::AlignedBox3d& room = OneOf(random_, rooms_m_);
  const auto somewhere = [&] {
    return Eigen::Vector2d(Between(random_, room.min().x(), room.max().x()),
                           Between(random_, room.min().y(), room.max().y()));
  };
  const Eigen::Vector2d from_m = somewhere(), towards = somewhere() - from_m;
  const Eigen::Vector3d position_m(from_m.x(), from_m.y(), Between(random_, kLowestM, kHighestM));
  if (towards.norm() < kViewM || !IsFree(position_m)) return std::nullopt;
  const double pitch_deg =
      std::clamp(-8.0 * (position_m.z() - 0.3) + 10.0 * random_.Gaussian(), -35.0, 15.0);
  return Pose(position_m, std::atan2(towards.y(), towards.x()), pitch_deg * kDegree);
}

std::optional<Rigid3d> RandomCameras::LookAtObject() {
  const Target& target = OneOf(random_, WeightedOneOf(random_, targets_).of_class);
  const double away_m = target.radius_m * Between(random_, 0.8, 2.2) + kClearanceM;
  const double around_rad = Between(random_, -M_PI, M_PI);
  Eigen::Vector3d position_m =
      target.centre_m + away_m * Eigen::Vector3d(std::cos(around_rad), std::sin(around_rad), 0.0);
  position_m.z() = Between(random_, kLowestM, kHighestM);
  if (!IsFree(position_m)) return std::nullopt;
  const Eigen::Vector3d off_m(random_.Gaussian(), random_.Gaussian(), random_.Gaussian());
  const Eigen::Vector3d towards =
      target.centre_m + (kTightM + 0.25 * target.radius_m) * off_m - position_m;
  return Pose(
      position_m, std::atan2(towards.y(), towards.x()),
      std::clamp(std::atan2(towards.z(), towards.head<2>().norm()), -70 * kDegree, 40 * kDegree));
}

}  // namespace semantic_slam
