#include "semantic_slam/worlds/building.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kOuterThicknessM = 0.22;  // of walls with nothing behind them
constexpr double kSlabM = 0.1;             // thickness of floors and ceilings
constexpr double kSameM = 0.01;            // rooms that are closer touch
constexpr float kSkirtingHeightM = 0.07f;
constexpr float kSkirtingThicknessM = 0.012f;

bool RunsAlongX(Side side) {
  return side == Side::kSouth || side == Side::kNorth;
}

// The coordinate, across it, where a wall's middle is.
double MiddleOf(const Room& room, Side side) {
  const Eigen::Vector2d& corner =
      side == Side::kWest || side == Side::kSouth ? room.area_m.min() : room.area_m.max();
  return RunsAlongX(side) ? corner.y() : corner.x();
}

// Into the room.
double YawInwards(Side side) {
  switch (side) {
    case Side::kWest:
      return 0.0;
    case Side::kSouth:
      return M_PI / 2;
    case Side::kEast:
      return M_PI;
    case Side::kNorth:
      break;
  }
  return -M_PI / 2;
}

Rigid3d PoseOnPlan(const Eigen::Vector2d& at_m, double yaw_rad) {
  Rigid3d T = Rigid3d(Eigen::Translation3d(at_m.x(), at_m.y(), 0.0));
  T.rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  return T;
}

std::string TextOf(const Eigen::Vector2d& at_m) {
  char text[64];
  std::snprintf(text, sizeof text, "[%g, %g]", at_m.x(), at_m.y());
  return text;
}

Furniture Structure(const std::string& label, Mesh mesh, const Material& material) {
  Furniture structure;
  structure.kind = label;
  structure.label = label;
  structure.parts.push_back({std::move(mesh), material, std::nullopt});
  return structure;
}

// How far two ranges overlap; negative if they do not.
double Overlap(double low_a, double high_a, double low_b, double high_b) {
  return std::min(high_a, high_b) - std::max(low_a, low_b);
}

bool Intersect(const WallRectangle& a, const WallRectangle& b) {
  return Overlap(a.left_m, a.right_m, b.left_m, b.right_m) > 0 &&
         Overlap(a.bottom_m, a.top_m, b.bottom_m, b.top_m) > 0;
}

// Along the foot of a wall, up to the openings that begin at the floor.
Mesh SkirtingMesh(float length_m, std::vector<WallRectangle> holes) {
  std::sort(holes.begin(), holes.end(),
            [](const WallRectangle& a, const WallRectangle& b) { return a.left_m < b.left_m; });
  holes.push_back({length_m, length_m, 0, 0});
  float begin = 0.0f;
  Mesh mesh;
  for (const WallRectangle& hole : holes) {
    if (hole.bottom_m > kSkirtingHeightM) continue;
    const Eigen::Vector3f size_m(kSkirtingThicknessM, hole.left_m - begin, kSkirtingHeightM);
    const Eigen::Vector3f corner_m(0, begin, 0);
    if (size_m.y() > 0.01f) Append(mesh, BoxMesh(corner_m + 0.5f * size_m, size_m));
    begin = hole.right_m;
  }
  return mesh;
}

}  // namespace

Side SideNamed(const std::string& name) {
  if (name == "west") return Side::kWest;
  if (name == "south") return Side::kSouth;
  if (name == "east") return Side::kEast;
  if (name == "north") return Side::kNorth;
  throw ConfigError("a wall is west, south, east or north, not " + name);
}

Building::Building(double wall_thickness_m) : wall_thickness_m_(wall_thickness_m) {
  CheckInRange<double>("wall thickness", wall_thickness_m_, 0.02, 0.5);
}

void Building::AddRoom(const Room& room) {
  CheckInRange<double>("height of room " + room.name, room.height_m, 2.0, 10.0);
  if (!(room.area_m.sizes().minCoeff() > wall_thickness_m_ + 0.5)) {
    throw ConfigError("room " + room.name + " must be at least 0.5 m wide inside");
  }
  for (const Room& other : rooms_) {
    if (other.name == room.name) throw ConfigError("two rooms are called " + room.name);
    const Eigen::AlignedBox2d common = room.area_m.intersection(other.area_m);
    if (!common.isEmpty() && common.sizes().minCoeff() > kSameM) {
      throw ConfigError("room " + room.name + " overlaps room " + other.name);
    }
  }
  rooms_.push_back(room);
}

void Building::AddOpening(const WallOpening& opening) {
  SitesOf(opening);  // throws if it is in no wall
  openings_.push_back(opening);
  for (const Room& room : rooms_) {
    for (const Side side : kSides) HolesIn(room, side);  // throws if it does not fit
  }
}

const Room& Building::FindRoom(const std::string& name) const {
  for (const Room& room : rooms_) {
    if (room.name == name) return room;
  }
  std::string names;
  for (const Room& room : rooms_) names += (names.empty() ? "" : ", ") + room.name;
  throw ConfigError("room " + name + " is unknown, expected one of: " + names);
}

const Room* Building::RoomAt(const Eigen::Vector2d& at_m) const {
  for (const Room& room : rooms_) {
    if (room.area_m.contains(at_m)) return &room;
  }
  return nullptr;
}

double Building::HalfThickness(const Room& room, Side side) const {
  const int along = RunsAlongX(side) ? 0 : 1;
  for (const Room& other : rooms_) {
    if (&other == &room) continue;
    const Side facing = kSides[(static_cast<int>(side) + 2) % 4];
    const bool touches = std::abs(MiddleOf(room, side) - MiddleOf(other, facing)) < kSameM;
    const double shared_m = Overlap(room.area_m.min()[along], room.area_m.max()[along],
                                    other.area_m.min()[along], other.area_m.max()[along]);
    if (touches && shared_m > kSameM) return 0.5 * wall_thickness_m_;
  }
  return kOuterThicknessM;
}

Rigid3d Building::WallPose(const Room& room, Side side, double along_m) const {
  const int along = RunsAlongX(side) ? 0 : 1;
  const double half_m = 0.5 * wall_thickness_m_;
  CheckInRange<double>("the place along the wall of room " + room.name, along_m,
                       room.area_m.min()[along] + half_m, room.area_m.max()[along] - half_m);
  const bool low_side = side == Side::kWest || side == Side::kSouth;
  Eigen::Vector2d at_m;
  at_m[along] = along_m;
  at_m[1 - along] = MiddleOf(room, side) + (low_side ? half_m : -half_m);
  return PoseOnPlan(at_m, YawInwards(side));
}

std::vector<WallSite> Building::SitesOf(const WallOpening& opening) const {
  std::vector<WallSite> sites;
  for (const Room& room : rooms_) {
    for (const Side side : kSides) {
      const int along = RunsAlongX(side) ? 0 : 1;
      const double where = opening.at_m[along];
      if (std::abs(opening.at_m[1 - along] - MiddleOf(room, side)) < kSameM &&
          where > room.area_m.min()[along] && where < room.area_m.max()[along]) {
        sites.push_back({&room, side});
      }
    }
  }
  if (sites.empty()) throw ConfigError("opening at " + TextOf(opening.at_m) + " is in no wall");
  return sites;
}

Rigid3d Building::OpeningPose(const WallOpening& opening, const WallSite& site) const {
  const double along_m = opening.at_m[RunsAlongX(site.side) ? 0 : 1];
  const Rigid3d T_world_wall = WallPose(*site.room, site.side, along_m);
  return T_world_wall * Eigen::Translation3d(-0.5 * wall_thickness_m_, 0.0, opening.bottom_m);
}

std::vector<WallRectangle> Building::HolesIn(const Room& room, Side side) const {
  const int along = RunsAlongX(side) ? 0 : 1;
  const double low_m = room.area_m.min()[along] + 0.5 * wall_thickness_m_;
  const double high_m = room.area_m.max()[along] - 0.5 * wall_thickness_m_;
  // Seen from inside, left is at the low end of the west and the north wall.
  const bool from_low = side == Side::kWest || side == Side::kNorth;
  std::vector<WallRectangle> holes;
  for (const WallOpening& opening : openings_) {
    const double begin = opening.at_m[along] - 0.5 * opening.width_m;
    const double end = opening.at_m[along] + 0.5 * opening.width_m;
    if (std::abs(opening.at_m[1 - along] - MiddleOf(room, side)) > kSameM ||
        Overlap(begin, end, low_m, high_m) < kSameM) {
      continue;
    }
    const bool fits = begin > low_m - kSameM && end < high_m + kSameM && opening.bottom_m >= 0.0 &&
                      opening.top_m <= room.height_m + 1e-6 && opening.top_m > opening.bottom_m;
    if (!fits) {
      throw ConfigError("opening at " + TextOf(opening.at_m) + " reaches beyond the wall of room " +
                        room.name);
    }
    const double left = std::max(from_low ? begin - low_m : high_m - end, 0.0);
    const double right = std::min(left + opening.width_m, high_m - low_m);
    const WallRectangle hole{static_cast<float>(left), static_cast<float>(right),
                             static_cast<float>(opening.bottom_m),
                             static_cast<float>(opening.top_m)};
    if (std::any_of(holes.begin(), holes.end(),
                    [&](const WallRectangle& other) { return Intersect(hole, other); })) {
      throw ConfigError("opening at " + TextOf(opening.at_m) + " overlaps another");
    }
    holes.push_back(hole);
  }
  return holes;
}

Eigen::AlignedBox2d Building::OuterArea(const Room& room) const {
  const auto beyond = [&](Side side) {
    return HalfThickness(room, side) - 0.5 * wall_thickness_m_;
  };
  return {room.area_m.min() - Eigen::Vector2d(beyond(Side::kWest), beyond(Side::kSouth)),
          room.area_m.max() + Eigen::Vector2d(beyond(Side::kEast), beyond(Side::kNorth))};
}

Furniture Building::BuildWalls(const Room& room) const {
  Furniture walls;
  walls.kind = "wall";
  walls.label = "wall";
  Mesh skirting;
  for (const Side side : kSides) {
    const int index = static_cast<int>(side);
    const int along = RunsAlongX(side) ? 0 : 1;
    const double inner_m = room.area_m.sizes()[along] - wall_thickness_m_;
    const double middle_m = room.area_m.center()[along];
    Rigid3d T_world_wall = WallPose(room, side, middle_m);
    T_world_wall.translate(Eigen::Vector3d(0, -0.5 * inner_m, 0));  // to its left end
    std::vector<WallRectangle> holes = HolesIn(room, side);
    Append(skirting, SkirtingMesh(static_cast<float>(inner_m), holes), T_world_wall);
    // The walls along x fill the corners.
    const double left_m = along == 0 ? HalfThickness(room, kSides[(index + 1) % 4]) : 0.0;
    const double right_m = along == 0 ? HalfThickness(room, kSides[(index + 3) % 4]) : 0.0;
    for (WallRectangle& hole : holes) {
      hole.left_m += static_cast<float>(left_m);
      hole.right_m += static_cast<float>(left_m);
    }
    T_world_wall.translate(Eigen::Vector3d(0, -left_m, 0));
    FurniturePart part{{}, room.walls[index], std::nullopt};
    Append(part.mesh,
           WallPanelMesh(static_cast<float>(left_m + inner_m + right_m),
                         static_cast<float>(room.height_m),
                         static_cast<float>(HalfThickness(room, side)), holes),
           T_world_wall);
    walls.parts.push_back(std::move(part));
  }
  walls.parts.push_back({std::move(skirting), room.skirting, std::nullopt});
  return walls;
}

std::vector<Furniture> Building::BuildRoom(const Room& room) const {
  const Eigen::AlignedBox2d area_m = OuterArea(room);
  const auto slab = [&](double bottom_m) {
    Eigen::Vector3d centre_m;
    centre_m << area_m.center(), bottom_m + 0.5 * kSlabM;
    Eigen::Vector3d size_m;
    size_m << area_m.sizes(), kSlabM;
    return BoxMesh(centre_m.cast<float>(), size_m.cast<float>());
  };
  return {Structure("floor", slab(-kSlabM), room.floor),
          Structure("ceiling", slab(room.height_m), room.ceiling), BuildWalls(room)};
}

}  // namespace semantic_slam
