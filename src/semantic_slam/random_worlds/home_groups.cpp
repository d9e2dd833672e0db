#include <algorithm>
#include <cmath>

#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/groups.h"

namespace semantic_slam {
namespace {

constexpr double kGapToWallM = 0.02;

void AddBedding(PieceMaker& maker, std::size_t bed, Arrangement& arrangement) {
  RandomStream& random = maker.random();
  const Item frame = arrangement.items[bed];
  const int pillows = frame.width_m() > 1.3f ? 2 : 1;
  for (int i = 0; i < pillows; ++i) {
    Item pillow = maker.Make("pillow");
    pillow.request.size_m = Eigen::Vector3f(0.45f, 0.62f, 0.15f);
    pillow.on = bed;
    pillow.at_m = {-0.5 * frame.depth_m() + 0.4, (i - 0.5 * (pillows - 1)) * 0.72};
    pillow.yaw_rad = 0.1 * random.Gaussian();
    arrangement.Add(pillow);
  }
  if (!Chance(random, 0.3)) return;
  Item clothes = maker.Make("clothes");
  clothes.on = bed;
  clothes.at_m = {0.45, 0.1 * random.Gaussian()};
  arrangement.Add(clothes);
}

void AddNightStand(PieceMaker& maker, const Item& bed, double side, Arrangement& arrangement) {
  Item stand = maker.Make("night_stand");
  stand.is_optional = true;
  stand.at_m = {kGapToWallM + 0.5 * stand.depth_m(),
                side * (0.5 * (bed.width_m() + stand.width_m()) + 0.06)};
  const std::size_t top = arrangement.Add(stand);
  AddClutter(maker, {"table_lamp", "book_stack", "cup", "telephone"}, 2, top, arrangement);
}

// Above a piece at the wall.
void AddPictureAbove(PieceMaker& maker, double y_m, double low_m, Arrangement& arrangement) {
  Item picture = maker.Make(Chance(maker.random(), 0.7) ? "picture" : "poster");
  picture.is_optional = true;
  picture.at_m = {0, y_m};
  picture.z_m = low_m;
  arrangement.Add(picture);
}

void AddWallCabinet(PieceMaker& maker, const Item& below, Arrangement& arrangement) {
  Item cabinet = maker.MakeOfSize("wall_cabinet", {0.34f, below.width_m(), 0.68f});
  cabinet.is_optional = true;
  cabinet.at_m = {0, below.at_m.y()};
  cabinet.z_m = 1.48;
  arrangement.Add(cabinet);
}

void AddSink(PieceMaker& maker, std::size_t counter, Arrangement& arrangement) {
  arrangement.items[counter].request.numbers["sink_hole"] = 1;
  Item sink = maker.Make("sink");
  sink.on = counter;
  sink.height_m = arrangement.items[counter].top_m() - 0.17 / 0.45 * sink.top_m();
  arrangement.Add(sink);
}

}  // namespace

Arrangement BedGroup(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  arrangement.anchor = Anchor::kWall;
  Item bed = maker.Make(Chance(random, 0.7) ? "bed" : "single_bed");
  bed.at_m.x() = kGapToWallM + 0.01 + 0.5 * bed.depth_m();
  const std::size_t index = arrangement.Add(bed);
  AddBedding(maker, index, arrangement);
  for (const double side : {-1.0, 1.0}) {
    if (Chance(random, 0.7)) AddNightStand(maker, bed, side, arrangement);
  }
  if (Chance(random, 0.5)) AddPictureAbove(maker, 0.0, bed.top_m() + 0.25, arrangement);
  if (Chance(random, 0.5)) {
    AddRug(maker, "rug", {bed.at_m.x() + 0.4, 0}, M_PI / 2, arrangement);
  }
  return arrangement;
}

Arrangement KitchenRow(PieceMaker& maker) {
  RandomStream& random = maker.random();
  Arrangement arrangement;
  arrangement.anchor = Anchor::kWall;
  arrangement.access_m = 0.6;
  const Item counter = maker.Make("counter");
  std::vector<std::string> kinds{"counter"};
  if (Chance(random, 0.85)) kinds.push_back("oven");
  if (Chance(random, 0.5)) kinds.push_back("counter");
  if (Chance(random, 0.85))
    kinds.insert(Chance(random, 0.5) ? kinds.begin() : kinds.end(), "fridge");
  const bool has_sink = Chance(random, 0.8);
  const bool has_cabinets = Chance(random, 0.75);
  double left_m = 0.0;
  bool sink_done = false;
  for (const std::string& kind : kinds) {
    Item item = kind == "counter" ? counter : maker.Make(kind);
    item.request.size_m->x() = kind == "fridge" ? item.depth_m() : counter.depth_m();
    if (kind == "oven") item.request.size_m->z() = counter.top_m();
    if (kind == "counter") {
      item.request.size_m->y() = static_cast<float>(Between(random, 1.0, 1.9));
    }
    item.is_optional = left_m > 0.0;
    item.at_m = {kGapToWallM + 0.5 * item.depth_m(), left_m + 0.5 * item.width_m()};
    left_m += item.width_m() + 0.01;
    const std::size_t index = arrangement.Add(item);
    if (has_cabinets && kind == "counter") AddWallCabinet(maker, item, arrangement);
    if (kind != "counter") continue;
    if (has_sink && !sink_done) {
      AddSink(maker, index, arrangement);
      sink_done = true;
    }
    AddClutter(maker, {"microwave", "bottle", "cup", "bowl", "plate", "pot_plant", "fruit", "box"},
               4, index, arrangement);
  }
  for (Item& item : arrangement.items) {
    if (!item.on) item.at_m.y() -= 0.5 * left_m;
  }
  return arrangement;
}

}  // namespace semantic_slam
