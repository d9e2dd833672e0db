#include "semantic_slam/random_worlds/groups.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/free_space.h"

namespace semantic_slam {
namespace {

constexpr double kGapToWallM = 0.02;  // skirting boards are 12 mm thick
constexpr double kRimM = 0.02;        // nothing stands nearer to the edge of a top
constexpr int kTries = 8;

using Kinds = std::vector<std::string>;

// What is found on top of a piece.
const Kinds& ThingsOn(const std::string& kind) {
  static const Kinds kNothing;
  static const Kinds kHome{"pot_plant",  "vase", "book_stack", "book_row", "bowl",
                           "table_lamp", "box",  "clothes",    "toy",      "bottle"};
  static const Kinds kHigh{"box", "bag", "pot_plant", "crate", "vase"};
  static const std::map<std::string, Kinds> things{
      {"sideboard", kHome},
      {"dresser", kHome},
      {"side_table", {"table_lamp", "vase", "cup"}},
      {"wardrobe", kHigh},
      {"bookshelf", kHigh},
      {"filing_cabinet", {"pot_plant", "box", "book_row"}},
      {"rack", kHigh},
      {"night_stand", {"table_lamp", "book_stack", "cup"}},
      {"fridge", {"box", "bowl"}},
      {"coffee_table", {"magazine", "cup", "bowl", "book_stack", "remote", "vase", "newspaper"}},
      {"bench", {"bag", "clothes", "box", "magazine"}},
      {"table", {"newspaper", "vase", "bowl", "cup", "bottle", "laptop", "box"}},
      {"desk", {"book_stack", "paper", "box", "cup"}},
  };
  const auto found = things.find(kind);
  return found == things.end() ? kNothing : found->second;
}

UprightBox BoxOnTop(const Item& item) {
  UprightBox box;
  box.centre_m = item.at_m;
  box.half_m = 0.5 * Eigen::Vector2d(item.depth_m(), item.width_m());
  box.yaw_rad = item.yaw_rad;
  box.high_m = 1.0;
  return box;
}

bool IsClearOn(const Item& item, const Eigen::Vector2d& half_top_m,
               const Arrangement& arrangement) {
  for (const Eigen::Vector2d& corner : BoxOnTop(item).Corners()) {
    if ((corner.cwiseAbs() - half_top_m).maxCoeff() > 0.0) return false;
  }
  return std::none_of(arrangement.items.begin(), arrangement.items.end(), [&](const Item& other) {
    return other.on == item.on && Overlap(BoxOnTop(item), BoxOnTop(other));
  });
}

bool IsRound(const std::string& kind) {
  return kind == "round_table" || kind == "side_table";
}

}  // namespace

void AddClutter(PieceMaker& maker, const Kinds& kinds, int most, std::size_t support,
                Arrangement& arrangement) {
  RandomStream& random = maker.random();
  const Item& top = arrangement.items[support];
  const double share = IsRound(top.kind) ? 0.66 : 1.0;
  const Eigen::Vector2d half_m =
      (0.5 * share * Eigen::Vector2d(top.depth_m(), top.width_m())).array() - kRimM;
  const int count = WholeBetween(random, 0, most);
  for (int i = 0; i < count; ++i) {
    Item item = maker.Make(OneOf(random, kinds));
    item.on = support;
    for (int attempt = 0; attempt < kTries; ++attempt) {
      item.at_m = {Between(random, -half_m.x(), half_m.x()),
                   Between(random, -half_m.y(), half_m.y())};
      item.yaw_rad = 0.4 * random.Gaussian();
      if (!IsClearOn(item, half_m, arrangement)) continue;
      arrangement.Add(item);
      break;
    }
  }
}

Arrangement SinglePiece(PieceMaker& maker, const std::string& kind, Anchor anchor) {
  Arrangement arrangement;
  arrangement.anchor = anchor;
  Item item = maker.Make(kind);
  if (anchor == Anchor::kWall) {
    item.at_m.x() = kGapToWallM + 0.5 * item.depth_m();
    arrangement.access_m = 0.35;
  }
  const std::size_t piece = arrangement.Add(item);
  if (!ThingsOn(kind).empty()) AddClutter(maker, ThingsOn(kind), 3, piece, arrangement);
  return arrangement;
}

Arrangement OnWall(PieceMaker& maker, const std::string& kind, double low_m, double high_m) {
  Arrangement arrangement;
  arrangement.anchor = Anchor::kWall;
  Item item = maker.Make(kind);
  item.z_m = Between(maker.random(), low_m, high_m);
  arrangement.Add(item);
  return arrangement;
}

Arrangement RowAtWall(PieceMaker& maker, const std::string& kind, int most) {
  Arrangement arrangement;
  arrangement.anchor = Anchor::kWall;
  arrangement.access_m = 0.4;
  Item item = maker.Make(kind);
  item.at_m.x() = kGapToWallM + 0.5 * item.depth_m();
  const double pitch_m = item.width_m() + (Chance(maker.random(), 0.6) ? 0.01 : 0.15);
  const int count = WholeBetween(maker.random(), 1, most);
  for (int i = 0; i < count; ++i) {
    item.at_m.y() = (i - 0.5 * (count - 1)) * pitch_m;
    item.request.seed += 4 * static_cast<std::uint64_t>(i);  // of the same split
    item.is_optional = i > 0;
    const std::size_t piece = arrangement.Add(item);
    if (!ThingsOn(kind).empty()) AddClutter(maker, ThingsOn(kind), 2, piece, arrangement);
  }
  return arrangement;
}

void AddRug(PieceMaker& maker, const std::string& kind, const Eigen::Vector2d& middle_m,
            double yaw_rad, Arrangement& arrangement) {
  Item rug = maker.Make(kind);
  rug.at_m = middle_m;
  rug.yaw_rad = yaw_rad;
  rug.is_flat = true;
  rug.is_optional = true;
  arrangement.Add(rug);
}

void AddChairsAround(PieceMaker& maker, const Item& table, const std::string& chair_kind,
                     bool at_ends, Arrangement& arrangement) {
  RandomStream& random = maker.random();
  Item chair = maker.Make(chair_kind);
  chair.is_optional = true;
  const bool has_arms = chair_kind != "chair" && chair_kind != "stool";
  const double room_m = chair.width_m() + 0.12;
  const int per_side = std::max(1, static_cast<int>((table.width_m() - 0.1) / room_m));
  const double pitch_m = table.width_m() / per_side;
  const auto add = [&](Eigen::Vector2d edge_m, double yaw_rad) {
    if (Chance(random, 0.15)) return;
    const double gap_m = Chance(random, 0.5) ? Between(random, has_arms ? 0.02 : -0.08, 0.1)
                                             : Between(random, 0.1, 0.35);
    const double out = gap_m + 0.5 * chair.depth_m();
    chair.at_m = edge_m - out * Eigen::Vector2d(std::cos(yaw_rad), std::sin(yaw_rad));
    chair.yaw_rad = yaw_rad + (gap_m < 0.1 ? 0.04 : 0.2) * random.Gaussian();
    arrangement.Add(chair);
  };
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < per_side; ++i) {
      add({side * 0.5 * table.depth_m(), (i - 0.5 * (per_side - 1)) * pitch_m},
          side > 0 ? M_PI : 0.0);
    }
    if (at_ends) add({0.0, side * 0.5 * table.width_m()}, -side * M_PI / 2);
  }
}

}  // namespace semantic_slam
