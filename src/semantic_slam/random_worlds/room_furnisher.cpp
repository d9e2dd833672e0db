#include "semantic_slam/random_worlds/room_furnisher.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "semantic_slam/random_worlds/choice.h"

namespace semantic_slam {
namespace {

constexpr int kTries = 120;
constexpr double kMostFilled = 0.5;  // of the floor
constexpr double kSlackM = 0.03;     // between pieces of different arrangements
constexpr double kLevelM = 0.004;    // tops are level within that
constexpr double kLowestTopM = 0.2;  // nothing is put on what is lower
constexpr double kStraight = 0.6;    // of what stands freely: along the walls

Rigid3d Upright(const Eigen::Vector2d& at_m, double yaw_rad, double z_m = 0.0) {
  Rigid3d T = Rigid3d(Eigen::Translation3d(at_m.x(), at_m.y(), z_m));
  T.rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  return T;
}

double YawOf(const Rigid3d& T) {
  return std::atan2(T.linear()(1, 0), T.linear()(0, 0));
}

bool HangsOnWall(const Item& item) {
  return FindFurnitureKind(item.kind).mount == Mount::kWall;
}

// The space that an item takes.
UprightBox BoxOf(const Item& item, const Rigid3d& T_world_arrangement) {
  const Rigid3d T = T_world_arrangement * Upright(item.at_m, item.yaw_rad, item.z_m);
  const double forward_m = HangsOnWall(item) ? 0.5 * item.depth_m() : 0.0;
  UprightBox box;
  box.centre_m = (T * Eigen::Vector3d(forward_m, 0, 0)).head<2>();
  box.half_m = 0.5 * Eigen::Vector2d(item.depth_m(), item.width_m());
  box.yaw_rad = YawOf(T);
  box.low_m = T.translation().z();
  box.high_m = box.low_m + item.top_m();
  return box;
}

// The same of an item whose pose in the world is known.
UprightBox BoxAt(Item item, const Rigid3d& T_world_item) {
  item.at_m.setZero();
  item.yaw_rad = item.z_m = 0.0;
  return BoxOf(item, T_world_item);
}

UprightBox Enlarged(UprightBox box, double by_m) {
  box.half_m.array() += by_m;
  return box;
}

// On the plan, in the arrangement's frame, of what stands on the floor.
Eigen::AlignedBox2d ExtentOf(const Arrangement& arrangement) {
  Eigen::AlignedBox2d extent;
  for (const Item& item : arrangement.items) {
    if (item.on) continue;
    for (const Eigen::Vector2d& corner : BoxOf(item, Rigid3d::Identity()).Corners()) {
      extent.extend(corner);
    }
  }
  return extent;
}

UprightBox AccessOf(const Arrangement& arrangement, const Rigid3d& T_world_arrangement) {
  const Eigen::AlignedBox2d extent = ExtentOf(arrangement);
  const Eigen::Vector2d middle_m(extent.max().x() + 0.5 * arrangement.access_m,
                                 extent.center().y());
  UprightBox box;
  box.centre_m = (T_world_arrangement * Eigen::Vector3d(middle_m.x(), middle_m.y(), 0)).head<2>();
  box.half_m = 0.5 * Eigen::Vector2d(arrangement.access_m, extent.sizes().y());
  box.yaw_rad = YawOf(T_world_arrangement);
  box.high_m = 1.8;
  return box;
}

bool IsSoft(const Item& item) {
  return item.kind == "pillow" || item.kind == "clothes";
}

// Part of it is within the box around what it lies on: between the arms of a sofa, in a worktop.
bool IsSunk(const Item& item) {
  return IsSoft(item) || item.height_m;
}

// Of the top of a piece below all of an item that lies on it; nullopt if it is not level.
std::optional<double> LevelTopAt(const WorldObject& support, const Item& item) {
  Item on_plan = item;
  on_plan.on.reset();
  const std::optional<double> middle_m = TopAt(support, item.at_m);
  for (const Eigen::Vector2d& corner : BoxOf(on_plan, Rigid3d::Identity()).Corners()) {
    const std::optional<double> top_m = TopAt(support, corner);
    if (!middle_m || !top_m || std::abs(*top_m - *middle_m) > kLevelM) return std::nullopt;
  }
  return middle_m;
}

}  // namespace

RoomFurnisher::RoomFurnisher(const Building& building, const Room& room, RandomStream& random,
                             WorldAssembly& assembly)
    : building_(building),
      room_(room),
      random_(random),
      assembly_(assembly),
      inside_m_(room.area_m.min().array() + 0.5 * building.wall_thickness_m(),
                room.area_m.max().array() - 0.5 * building.wall_thickness_m()),
      space_(inside_m_, room.height_m) {}

Rigid3d RoomFurnisher::TryWall(double half_width_m) {
  const Side side = kSides[WholeBetween(random_, 0, 3)];
  const int along = side == Side::kSouth || side == Side::kNorth ? 0 : 1;
  const double low_m = inside_m_.min()[along] + half_width_m;
  const double high_m = inside_m_.max()[along] - half_width_m;
  const double at_m = low_m < high_m ? Between(random_, low_m, high_m) : inside_m_.center()[along];
  return building_.WallPose(room_, side, at_m);
}

Rigid3d RoomFurnisher::TryFloor() {
  const Eigen::Vector2d at_m(Between(random_, inside_m_.min().x(), inside_m_.max().x()),
                             Between(random_, inside_m_.min().y(), inside_m_.max().y()));
  const bool is_straight = Chance(random_, kStraight);
  const double yaw_rad = is_straight
                             ? WholeBetween(random_, 0, 3) * M_PI / 2 + 0.05 * random_.Gaussian()
                             : Between(random_, -M_PI, M_PI);
  return Upright(at_m, yaw_rad);
}

bool RoomFurnisher::Fits(const Item& item, const Rigid3d& T_world_arrangement) const {
  const UprightBox box = BoxOf(item, T_world_arrangement);
  return item.is_flat ? space_.IsPassable(box) : space_.Fits(box);
}

bool RoomFurnisher::FitsAt(const Arrangement& arrangement,
                           const Rigid3d& T_world_arrangement) const {
  for (const Item& item : arrangement.items) {
    if (item.on || item.is_optional) continue;
    if (!Fits(item, T_world_arrangement)) return false;
  }
  return arrangement.access_m == 0.0 ||
         space_.IsPassable(AccessOf(arrangement, T_world_arrangement));
}

// By item.
std::vector<bool> RoomFurnisher::WhatFits(const Arrangement& arrangement,
                                          const Rigid3d& T_world_arrangement) const {
  std::vector<bool> fits;
  for (const Item& item : arrangement.items) {
    fits.push_back(item.on ? fits[*item.on] : !item.is_optional || Fits(item, T_world_arrangement));
  }
  return fits;
}

bool RoomFurnisher::Place(const Arrangement& arrangement) {
  const bool stands =
      std::any_of(arrangement.items.begin(), arrangement.items.end(),
                  [](const Item& item) { return item.z_m == 0.0 && !item.is_flat; });
  if (stands && space_.FilledShare() > kMostFilled) return false;
  const double half_width_m = 0.5 * ExtentOf(arrangement).sizes().y();
  for (int i = 0; i < kTries; ++i) {
    const bool at_wall = arrangement.anchor == Anchor::kWall;
    if (PlaceAt(arrangement, at_wall ? TryWall(half_width_m) : TryFloor())) return true;
  }
  return false;
}

bool RoomFurnisher::PlaceAt(const Arrangement& arrangement, const Rigid3d& T_world_arrangement) {
  if (!FitsAt(arrangement, T_world_arrangement)) return false;
  Furnish(arrangement, T_world_arrangement);
  return true;
}

void RoomFurnisher::Furnish(const Arrangement& arrangement, const Rigid3d& T_world_arrangement) {
  const std::vector<bool> fits = WhatFits(arrangement, T_world_arrangement);
  std::vector<std::string> names(arrangement.items.size());
  for (std::size_t i = 0; i < arrangement.items.size(); ++i) {
    const Item& item = arrangement.items[i];
    if (!fits[i]) continue;
    std::optional<Rigid3d> T = T_world_arrangement * Upright(item.at_m, item.yaw_rad, item.z_m);
    if (item.on) {
      if (!names[*item.on].empty()) T = PoseOnTop(item, names[*item.on]);
      if (names[*item.on].empty() || !T) continue;
      const UprightBox box = BoxAt(item, *T);
      if (!space_.IsPassable(box) && !IsSunk(item)) continue;
      space_.Take(box);
    } else if (!item.is_flat) {
      space_.Take(Enlarged(BoxOf(item, T_world_arrangement), kSlackM));
    }
    names[i] = assembly_.FreeName(item.kind);
    assembly_.Add(names[i], MakeFurniture(item.kind, item.request), *T);
  }
  if (arrangement.access_m > 0.0) space_.KeepFree(AccessOf(arrangement, T_world_arrangement));
}

// nullopt if nothing level is there: beside an oblong top, on a lower shelf.
std::optional<Rigid3d> RoomFurnisher::PoseOnTop(const Item& item,
                                                const std::string& support_name) const {
  const WorldObject& support = *assembly_.Find(support_name);
  std::optional<double> z_m = item.height_m;
  if (!z_m) z_m = IsSoft(item) ? TopAt(support, item.at_m) : LevelTopAt(support, item);
  if (!z_m || *z_m < kLowestTopM) return std::nullopt;
  return support.T_world_object * Upright(item.at_m, item.yaw_rad, *z_m);
}

}  // namespace semantic_slam
