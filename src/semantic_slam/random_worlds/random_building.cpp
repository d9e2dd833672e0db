#include "semantic_slam/random_worlds/random_building.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/random_material.h"
#include "semantic_slam/worlds/opening_pieces.h"

namespace semantic_slam {
namespace {

constexpr double kLeastSideM = 2.5;      // of a room
constexpr double kCorridorM = 1.9;       // narrowest side of a corridor
constexpr double kMarginM = 0.15;        // from an opening to the next wall
constexpr double kLowestHeightM = 2.35;  // of a room

using Areas = std::vector<Eigen::AlignedBox2d>;

struct RoomCount {
  int rooms = 1;
  double weight = 1.0;
};

int Longer(const Eigen::AlignedBox2d& area) {
  return area.sizes().x() > area.sizes().y() ? 0 : 1;
}

// Cuts the largest area in two across its longer side; false if the halves would be too small.
bool CutLargest(RandomStream& random, Areas& areas) {
  const auto largest =
      std::max_element(areas.begin(), areas.end(),
                       [](const auto& a, const auto& b) { return a.volume() < b.volume(); });
  const int axis = Longer(*largest);
  const double side_m = largest->sizes()[axis];
  const double first_m = Chance(random, 0.2) ? kCorridorM + Between(random, 0.0, 0.5)
                                             : side_m * Between(random, 0.38, 0.62);
  if (first_m < kCorridorM || side_m - first_m < kLeastSideM) return false;
  Eigen::AlignedBox2d rest = *largest;
  largest->max()[axis] = rest.min()[axis] = largest->min()[axis] + first_m;
  areas.push_back(rest);
  return true;
}

Areas PlanAreas(RandomStream& random) {
  const int rooms =
      WeightedOneOf(random, std::vector<RoomCount>{{1, 4}, {2, 3}, {3, 2}, {4, 1}}).rooms;
  const double area_m2 = rooms * Between(random, 14.0, 32.0);
  const double shape = Between(random, 0.62, 1.0);
  const double width_m = std::max(3.0, std::sqrt(area_m2 * shape));
  Areas areas;
  areas.emplace_back(Eigen::Vector2d::Zero(), Eigen::Vector2d(area_m2 / width_m, width_m));
  for (int i = 1; i < rooms; ++i) {
    if (!CutLargest(random, areas)) break;
  }
  return areas;
}

// All in one style; now and then a wall or a room of its own.
std::vector<Room> PlanRooms(WorldSplit split, const Areas& areas, RandomStream& random) {
  const auto surface = [&](const char* name) { return RandomSurface(split, name, random); };
  Room style;
  style.height_m = Between(random, kLowestHeightM, 3.2);
  style.ceiling = surface("ceiling");
  style.floor = surface("floor");
  style.walls.fill(surface("wall"));
  style.skirting = RandomMaterial(split, MakeMaterial("wood", {226, 222, 214}, 0.2f), random);
  std::vector<Room> rooms;
  for (const Eigen::AlignedBox2d& area : areas) {
    Room room = style;
    room.name = "room_" + std::to_string(rooms.size() + 1);
    room.area_m = area;
    if (Chance(random, 0.5)) room.floor = surface("floor");
    if (Chance(random, 0.6)) room.walls.fill(surface("wall"));
    if (Chance(random, 0.4)) room.walls[WholeBetween(random, 0, 3)] = surface("wall");
    if (Chance(random, 0.2)) room.height_m = Between(random, kLowestHeightM, 3.2);
    rooms.push_back(room);
  }
  return rooms;
}

// A piece of wall in which a hole may be: the middle of the wall, from end to end.
struct WallPiece {
  int along = 0;  // axis
  double across_m = 0.0;
  double low_m = 0.0;
  double high_m = 0.0;
};

std::optional<WallPiece> SharedWall(const Room& a, const Room& b, double thickness_m) {
  for (int along = 0; along < 2; ++along) {
    const int across = 1 - along;
    for (const auto& [low_side, high_side] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
      if (std::abs(low_side->area_m.max()[across] - high_side->area_m.min()[across]) > 1e-6) {
        continue;
      }
      const double margin_m = 0.5 * thickness_m + kMarginM;
      const WallPiece piece{along, low_side->area_m.max()[across],
                            std::max(a.area_m.min()[along], b.area_m.min()[along]) + margin_m,
                            std::min(a.area_m.max()[along], b.area_m.max()[along]) - margin_m};
      if (piece.high_m - piece.low_m > 0.85) return piece;
    }
  }
  return std::nullopt;
}

WallPiece OuterWall(const Room& room, Side side, double thickness_m) {
  const int along = side == Side::kSouth || side == Side::kNorth ? 0 : 1;
  const bool is_low = side == Side::kWest || side == Side::kSouth;
  const double margin_m = 0.5 * thickness_m + kMarginM;
  return {along, is_low ? room.area_m.min()[1 - along] : room.area_m.max()[1 - along],
          room.area_m.min()[along] + margin_m, room.area_m.max()[along] - margin_m};
}

// A hole of at most that width, anywhere in the piece.
WallOpening HoleIn(const WallPiece& piece, double width_m, double bottom_m, double top_m,
                   RandomStream& random) {
  WallOpening hole;
  hole.width_m = std::min(width_m, piece.high_m - piece.low_m);
  hole.bottom_m = bottom_m;
  hole.top_m = top_m;
  hole.at_m[1 - piece.along] = piece.across_m;
  hole.at_m[piece.along] =
      Between(random, piece.low_m + 0.5 * hole.width_m, piece.high_m - 0.5 * hole.width_m);
  return hole;
}

PlannedOpening PlanDoor(const WallPiece& piece, double height_m, RandomStream& random) {
  using Kind = PlannedOpening::Kind;
  const double top_m = std::min(Between(random, 1.98, 2.15), height_m - 0.15);
  const double kind = random.Uniform();
  if (kind < 0.7) return {Kind::kDoor, HoleIn(piece, Between(random, 0.82, 1.0), 0, top_m, random)};
  const double width_m = Between(random, 0.9, 2.2);
  return {kind < 0.82 ? Kind::kFramedPassage : Kind::kPassage,
          HoleIn(piece, width_m, 0, top_m, random)};
}

PlannedOpening PlanWindow(const WallPiece& piece, double height_m, RandomStream& random) {
  const double bottom_m = Chance(random, 0.15) ? 0.12 : Between(random, 0.6, 1.1);
  const double top_m = std::min(bottom_m + Between(random, 0.9, 1.6), height_m - 0.2);
  return {PlannedOpening::Kind::kWindow,
          HoleIn(piece, Between(random, 0.8, 2.6), bottom_m, top_m, random)};
}

void PlanInnerOpenings(PlannedBuilding& plan, RandomStream& random) {
  const std::vector<Room>& rooms = plan.building.rooms();
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    for (std::size_t j = i + 1; j < rooms.size(); ++j) {
      const auto piece = SharedWall(rooms[i], rooms[j], plan.building.wall_thickness_m());
      if (!piece) continue;
      const double height_m = std::min(rooms[i].height_m, rooms[j].height_m);
      plan.openings.push_back(PlanDoor(*piece, height_m, random));
    }
  }
}

void PlanOuterOpenings(PlannedBuilding& plan, RandomStream& random) {
  const double thickness_m = plan.building.wall_thickness_m();
  for (const Room& room : plan.building.rooms()) {
    bool has_outer_door = plan.building.rooms().size() > 1;
    for (const Side side : kSides) {
      if (plan.building.HalfThickness(room, side) <= 0.5 * thickness_m) continue;  // an inner wall
      const WallPiece piece = OuterWall(room, side, thickness_m);
      if (!has_outer_door && Chance(random, 0.5)) {
        PlannedOpening door = PlanDoor(piece, room.height_m, random);
        door.kind = PlannedOpening::Kind::kDoor;
        door.hole.width_m = std::min(door.hole.width_m, 1.05);
        plan.openings.push_back(door);
        has_outer_door = true;
      } else if (Chance(random, 0.45)) {
        plan.openings.push_back(PlanWindow(piece, room.height_m, random));
      }
    }
  }
}

void AddDoor(const PlannedOpening& opening, const Building& building, PieceMaker& maker,
             WorldAssembly& assembly) {
  RandomStream& random = maker.random();
  const std::vector<WallSite> sites = building.SitesOf(opening.hole);
  const FittedPiece fitted = FitDoor(building, opening.hole, OneOf(random, sites));
  Item door = maker.MakeOfSize("door", fitted.size_m);
  const bool has_leaf = opening.kind == PlannedOpening::Kind::kDoor;
  const bool is_open = has_leaf && sites.size() > 1 && Chance(random, 0.5);
  door.request.numbers["leaf"] = has_leaf ? 1.0 : 0.0;
  door.request.numbers["hinge_left"] = WholeBetween(random, 0, 1);
  door.request.numbers["open_deg"] = is_open ? Between(random, 15.0, 95.0) : 0.0;
  assembly.Add(assembly.FreeName("door"), MakeFurniture("door", door.request),
               fitted.T_world_object);
}

}  // namespace

PlannedBuilding PlanBuilding(WorldSplit split, RandomStream& random) {
  PlannedBuilding plan{Building(Between(random, 0.1, 0.18)), {}};
  for (const Room& room : PlanRooms(split, PlanAreas(random), random)) plan.building.AddRoom(room);
  PlanInnerOpenings(plan, random);
  PlanOuterOpenings(plan, random);
  for (const PlannedOpening& opening : plan.openings) plan.building.AddOpening(opening.hole);
  return plan;
}

void AddBuilding(const PlannedBuilding& plan, PieceMaker& maker, WorldAssembly& assembly) {
  assembly.AddBuilding(plan.building);
  for (const PlannedOpening& opening : plan.openings) {
    if (opening.kind == PlannedOpening::Kind::kPassage) continue;
    if (opening.kind == PlannedOpening::Kind::kWindow) {
      const WallSite site = plan.building.SitesOf(opening.hole).front();
      const FittedPiece fitted = FitWindow(plan.building, opening.hole, site);
      const Item window = maker.MakeOfSize("window", fitted.size_m);
      assembly.Add(assembly.FreeName("window"), MakeFurniture("window", window.request),
                   fitted.T_world_object);
    } else {
      AddDoor(opening, plan.building, maker, assembly);
    }
  }
}

}  // namespace semantic_slam
