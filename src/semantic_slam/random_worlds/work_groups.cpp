#include <algorithm>
#include <cmath>

#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/groups.h"

namespace semantic_slam {
namespace {

Item OnDesk(Item item, std::size_t desk, double x_m, double y_m, double yaw_rad) {
  item.on = desk;
  item.at_m = {x_m, y_m};
  item.yaw_rad = yaw_rad;
  return item;
}

// Whoever sits there looks to -x.
void AddDevices(PieceMaker& maker, std::size_t desk, Arrangement& arrangement) {
  RandomStream& random = maker.random();
  const double half_m = 0.5 * arrangement.items[desk].depth_m();
  const double y_m = Between(random, -0.15, 0.15);
  if (Chance(random, 0.3)) {
    arrangement.Add(OnDesk(maker.Make("laptop"), desk, 0.02, y_m, 0.2 * random.Gaussian()));
  } else {
    const int monitors = Chance(random, 0.25) ? 2 : 1;
    for (int i = 0; i < monitors; ++i) {
      arrangement.Add(OnDesk(maker.Make("monitor"), desk, -half_m + 0.17,
                             y_m + (i - 0.5 * (monitors - 1)) * 0.64, 0.08 * random.Gaussian()));
    }
    arrangement.Add(OnDesk(maker.Make("keyboard"), desk, half_m - 0.2, y_m, 0));
    if (Chance(random, 0.8)) {
      arrangement.Add(OnDesk(maker.Make("mouse"), desk, half_m - 0.2, y_m - 0.32, 0));
    }
  }
  AddClutter(maker,
             {"cup", "paper", "book_stack", "desk_lamp", "telephone", "bottle", "pot_plant", "box"},
             4, desk, arrangement);
}

// A desk at `at_m` with a chair before it, all turned by `yaw_rad`.
void AddWorkplace(PieceMaker& maker, Item desk, const Eigen::Vector2d& at_m, double yaw_rad,
                  Arrangement& arrangement) {
  RandomStream& random = maker.random();
  const Eigen::Rotation2Dd turn(yaw_rad);
  desk.at_m = at_m;
  desk.yaw_rad = yaw_rad;
  desk.is_optional = !arrangement.items.empty();
  const std::size_t index = arrangement.Add(desk);
  AddDevices(maker, index, arrangement);
  if (Chance(random, 0.1)) return;
  Item chair = maker.Make(Chance(random, 0.8) ? "office_chair" : "chair");
  chair.is_optional = true;
  const double out_m = 0.5 * (desk.depth_m() + chair.depth_m()) + Between(random, 0.02, 0.35);
  chair.at_m = at_m + turn * Eigen::Vector2d(out_m, Between(random, -0.25, 0.1));
  chair.yaw_rad = yaw_rad + M_PI + 0.35 * random.Gaussian();
  arrangement.Add(chair);
}

}  // namespace

Arrangement DeskAtWall(PieceMaker& maker) {
  Arrangement arrangement;
  arrangement.anchor = Anchor::kWall;
  const Item desk = maker.Make("desk");
  AddWorkplace(maker, desk, {0.04 + 0.5 * desk.depth_m(), 0}, 0.0, arrangement);
  return arrangement;
}

Arrangement DeskInRoom(PieceMaker& maker) {
  Arrangement arrangement;
  AddWorkplace(maker, maker.Make("desk"), {0, 0}, 0.0, arrangement);
  return arrangement;
}

Arrangement DeskBlock(PieceMaker& maker) {
  Arrangement arrangement;
  const Item desk = maker.Make("desk");
  const int rows = WholeBetween(maker.random(), 1, 2);
  for (int row = 0; row < rows; ++row) {
    const double y_m = (row - 0.5 * (rows - 1)) * (desk.width_m() + 0.04);
    const double x_m = 0.5 * desk.depth_m() + 0.02;
    AddWorkplace(maker, desk, {x_m, y_m}, 0.0, arrangement);
    AddWorkplace(maker, desk, {-x_m, y_m}, M_PI, arrangement);
  }
  return arrangement;
}

Arrangement ConferenceGroup(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  Item table = maker.Make("conference_table");
  table.request.size_m->y() *= static_cast<float>(Between(random, 0.65, 1.1));
  const std::size_t top = arrangement.Add(table);
  AddClutter(maker, {"laptop", "paper", "cup", "bottle", "telephone", "book_stack"}, 7, top,
             arrangement);
  AddChairsAround(maker, table, Chance(random, 0.5) ? "chair" : "office_chair", Chance(random, 0.4),
                  arrangement);
  return arrangement;
}

Arrangement Whiteboard(PieceMaker& maker) {
  RandomStream& random = maker.random();
  if (Chance(random, 0.3)) {
    return SinglePiece(maker, "whiteboard_stand",
                       Chance(random, 0.3) ? Anchor::kWall : Anchor::kFree);
  }
  Arrangement arrangement = OnWall(maker, "whiteboard", 0.7, 1.05);
  arrangement.items[0].request.size_m->y() *= static_cast<float>(Between(random, 0.6, 1.3));
  return arrangement;
}

}  // namespace semantic_slam
