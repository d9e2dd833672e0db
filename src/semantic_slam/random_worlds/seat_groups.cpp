#include <algorithm>
#include <cmath>

#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/groups.h"

namespace semantic_slam {
namespace {

constexpr double kGapToWallM = 0.03;

// Flat below what stands about `middle_m`.
std::string RugKind(RandomStream& random) {
  return Chance(random, 0.8) ? "rug" : "round_rug";
}

void AddPillows(PieceMaker& maker, std::size_t sofa, Arrangement& arrangement) {
  RandomStream& random = maker.random();
  const double half_m = 0.5 * arrangement.items[sofa].width_m() - 0.45;
  for (const double side : {-1.0, 1.0}) {
    if (half_m < 0.15 || Chance(random, 0.5)) continue;
    Item pillow = maker.Make("pillow");
    pillow.request.size_m = Eigen::Vector3f(0.4f, 0.42f, 0.13f);
    pillow.on = sofa;
    pillow.at_m = {Between(random, 0.1, 0.16), side * half_m};
    pillow.yaw_rad = 0.3 * random.Gaussian();
    arrangement.Add(pillow);
  }
}

// A seat with its front to `yaw_rad`.
std::size_t AddSeat(PieceMaker& maker, const std::string& kind, const Eigen::Vector2d& at_m,
                    double yaw_rad, Arrangement& arrangement) {
  Item seat = maker.Make(kind);
  seat.at_m = at_m;
  seat.yaw_rad = yaw_rad;
  seat.is_optional = !arrangement.items.empty();
  const std::size_t index = arrangement.Add(seat);
  if (kind == "sofa") AddPillows(maker, index, arrangement);
  return index;
}

// Beside the sofa, if it stands at a wall: a side table with a lamp, or a floor lamp or plant.
void AddBeside(PieceMaker& maker, const Item& sofa, double side, Arrangement& arrangement) {
  static const std::vector<std::string> kBeside{"side_table",  "floor_lamp", "plant",
                                                "snake_plant", "floor_lamp", "side_table"};
  Item item = maker.Make(OneOf(maker.random(), kBeside));
  item.is_optional = true;
  const double half_m = 0.5 * std::max(item.width_m(), item.depth_m());
  item.at_m = {sofa.at_m.x() - 0.5 * sofa.depth_m() + half_m,
               side * (0.5 * sofa.width_m() + half_m + Between(maker.random(), 0.05, 0.2))};
  const std::size_t index = arrangement.Add(item);
  if (item.kind == "side_table")
    AddClutter(maker, {"table_lamp", "vase", "cup"}, 2, index, arrangement);
}

}  // namespace

Arrangement SofaGroup(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  arrangement.anchor = Chance(random, 0.6) ? Anchor::kWall : Anchor::kFree;
  const std::size_t index = AddSeat(maker, "sofa", {0, 0}, 0.0, arrangement);
  const double depth_m = arrangement.items[index].depth_m();
  arrangement.items[index].at_m.x() = kGapToWallM + 0.5 * depth_m;
  const Item sofa = arrangement.items[index];
  const double front_m = kGapToWallM + depth_m;
  Item table = maker.Make("coffee_table");
  table.at_m = {front_m + Between(random, 0.28, 0.5) + 0.5 * table.depth_m(),
                0.15 * random.Gaussian()};
  table.yaw_rad = 0.06 * random.Gaussian();
  if (Chance(random, 0.9)) {
    table.is_optional = Chance(random, 0.3);
    const std::size_t top = arrangement.Add(table);
    AddClutter(maker, {"magazine", "cup", "bowl", "book_stack", "remote", "vase", "newspaper"}, 4,
               top, arrangement);
  }
  if (Chance(random, 0.6)) AddRug(maker, RugKind(random), table.at_m, M_PI / 2, arrangement);
  for (const double side : {-1.0, 1.0}) {
    if (Chance(random, 0.35)) AddBeside(maker, sofa, side, arrangement);
    if (!Chance(random, 0.3)) continue;
    const double out_m = 0.5 * table.width_m() + Between(random, 0.75, 1.0);
    AddSeat(maker, "armchair", {table.at_m.x() + Between(random, -0.05, 0.3), side * out_m},
            -side * Between(random, 1.3, 1.9), arrangement);
  }
  return arrangement;
}

Arrangement LoungeGroup(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  const std::size_t top = arrangement.Add(maker.Make("coffee_table"));
  const Item table = arrangement.items[top];
  AddClutter(maker, {"magazine", "cup", "bowl", "newspaper"}, 4, top, arrangement);
  const int first = WholeBetween(random, 0, 3);
  const int seats = WholeBetween(random, 2, 4);
  for (int i = first; i < first + seats; ++i) {
    const bool along_x = i % 2 == 0;
    const std::string kind = along_x && Chance(random, 0.65) ? "sofa" : "armchair";
    const double out_m =
        0.5 * (along_x ? table.depth_m() : table.width_m()) + 0.5 + Between(random, 0.3, 0.5);
    const double angle = i * M_PI / 2;
    AddSeat(maker, kind, out_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)), angle + M_PI,
            arrangement);
  }
  if (Chance(random, 0.6)) AddRug(maker, RugKind(random), {0, 0}, 0.0, arrangement);
  return arrangement;
}

Arrangement ChairRow(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  arrangement.anchor = Anchor::kWall;
  arrangement.access_m = 0.4;
  Item chair = maker.Make(Chance(random, 0.8) ? "chair" : "armchair");
  const int count = WholeBetween(random, 2, 5);
  const double pitch_m = chair.width_m() + Between(random, 0.04, 0.2);
  for (int i = 0; i < count; ++i) {
    chair.is_optional = i > 0;
    chair.at_m = {0.06 + 0.5 * chair.depth_m(), (i - 0.5 * (count - 1)) * pitch_m};
    chair.yaw_rad = 0.03 * random.Gaussian();
    arrangement.Add(chair);
  }
  return arrangement;
}

Arrangement TvGroup(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  arrangement.anchor = Anchor::kWall;
  arrangement.access_m = 0.5;
  Item stand = maker.Make(Chance(random, 0.75) ? "tv_stand" : "sideboard");
  stand.at_m.x() = kGapToWallM + 0.5 * stand.depth_m();
  const std::size_t top = arrangement.Add(stand);
  Item tv = maker.Make("tv");
  tv.request.size_m->y() = std::min(tv.request.size_m->y(), stand.width_m() - 0.1f);
  tv.request.size_m->x() = std::min(tv.request.size_m->x(), stand.depth_m() - 0.04f);
  tv.on = top;
  arrangement.Add(tv);
  AddClutter(maker, {"pot_plant", "vase", "remote", "book_row"}, 2, top, arrangement);
  return arrangement;
}

Arrangement DiningGroup(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  const std::size_t top = arrangement.Add(maker.Make("table"));
  const Item table = arrangement.items[top];
  AddClutter(maker, {"plate", "cup", "bowl", "bottle", "vase", "newspaper", "fruit"}, 8, top,
             arrangement);
  AddChairsAround(maker, table, Chance(random, 0.9) ? "chair" : "stool", Chance(random, 0.5),
                  arrangement);
  if (Chance(random, 0.35)) AddRug(maker, RugKind(random), {0, 0}, 0.0, arrangement);
  return arrangement;
}

Arrangement RoundTableGroup(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  const std::size_t top = arrangement.Add(maker.Make("round_table"));
  const Item table = arrangement.items[top];
  AddClutter(maker, {"plate", "cup", "bowl", "bottle", "vase", "newspaper"}, 4, top, arrangement);
  Item chair = maker.Make(Chance(random, 0.85) ? "chair" : "stool");
  chair.is_optional = true;
  const int count = WholeBetween(random, 2, 4);
  const double turn = Between(random, 0, M_PI);
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 2 * M_PI * i / count + 0.1 * random.Gaussian();
    const double out_m =
        0.5 * table.depth_m() + 0.5 * chair.depth_m() + Between(random, -0.05, 0.2);
    chair.at_m = out_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    chair.yaw_rad = angle + M_PI + 0.15 * random.Gaussian();
    arrangement.Add(chair);
  }
  return arrangement;
}

}  // namespace semantic_slam
