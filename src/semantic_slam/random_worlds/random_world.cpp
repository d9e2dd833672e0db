#include "semantic_slam/random_worlds/random_world.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/piece_maker.h"
#include "semantic_slam/random_worlds/random_building.h"
#include "semantic_slam/random_worlds/room_furnisher.h"
#include "semantic_slam/random_worlds/room_recipes.h"

namespace semantic_slam {
namespace {

constexpr double kNarrowM = 2.6;      // a room that narrow is a corridor
constexpr double kAreaPerLampM2 = 9;  // of the ceiling
constexpr double kDoorwayM = 0.95;    // kept free before a door
constexpr double kBeforeWindowM = 0.16;

using Rgb = std::array<float, 3>;

// White as by lamps between candles and a grey sky, green being 1.
Rgb RandomWhite(RandomStream& random) {
  const double warmth = Between(random, -0.12, 0.3);
  return {static_cast<float>(1.0 + 0.6 * warmth), 1.0f, static_cast<float>(1.0 - warmth)};
}

Rgb Times(double factor, Rgb rgb) {
  for (float& channel : rgb) channel *= static_cast<float>(factor);
  return rgb;
}

// A number between, evenly spread in its logarithm.
double LogBetween(RandomStream& random, double low, double high) {
  return low * std::pow(high / low, random.Uniform());
}

// Furnishes one building.
class Decorator {
 public:
  Decorator(const PlannedBuilding& plan, PieceMaker& maker, WorldAssembly& assembly)
      : plan_(plan), maker_(maker), random_(maker.random()), assembly_(assembly) {}

  void FurnishRoom(const Room& room, RoomType type) {
    RoomFurnisher furnisher(plan_.building, room, random_, assembly_);
    for (const PlannedOpening& opening : plan_.openings) Respect(opening, furnisher);
    HangLamps(furnisher);
    if (Chance(random_, 0.25)) Fulfil(OddWishes(), furnisher);  // before what belongs there
    Fulfil(WishesOf(type), furnisher);
    Fulfil(OddWishes(), furnisher);
  }

 private:
  void Fulfil(const std::vector<Wish>& wishes, RoomFurnisher& furnisher) {
    for (const Wish& wish : wishes) {
      for (int i = 0; i < wish.most; ++i) {
        if (Chance(random_, wish.chance)) furnisher.Place(wish.make(maker_));
      }
    }
  }

  // Keeps doorways free, and walls where windows are; hangs curtains.
  void Respect(const PlannedOpening& opening, RoomFurnisher& furnisher) {
    for (const WallSite& site : plan_.building.SitesOf(opening.hole)) {
      if (site.room->name != furnisher.room().name) continue;
      const Rigid3d T = plan_.building.OpeningPose(opening.hole, site);
      if (opening.kind == PlannedOpening::Kind::kWindow) {
        HangCurtain(opening, site, furnisher);
        furnisher.space().Take(Before(T, opening.hole, 0.1, kBeforeWindowM));
      } else {
        furnisher.space().KeepFree(Before(T, opening.hole, 0.1, kDoorwayM));
      }
    }
  }

  // The space before a hole, a little wider than it.
  UprightBox Before(const Rigid3d& T_world_opening, const WallOpening& hole, double wider_m,
                    double deep_m) const {
    UprightBox box;
    const double middle_m = 0.5 * (plan_.building.wall_thickness_m() + deep_m);
    box.centre_m = (T_world_opening * Eigen::Vector3d(middle_m, 0, 0)).head<2>();
    box.half_m = {0.5 * deep_m, 0.5 * hole.width_m + wider_m};
    box.yaw_rad = std::atan2(T_world_opening.linear()(1, 0), T_world_opening.linear()(0, 0));
    box.low_m = hole.bottom_m;
    box.high_m = hole.top_m;
    return box;
  }

  void HangCurtain(const PlannedOpening& opening, const WallSite& site, RoomFurnisher& furnisher) {
    const double kind = random_.Uniform();
    if (kind > 0.75) return;
    const WallOpening& hole = opening.hole;
    const double thickness_m = plan_.building.wall_thickness_m();
    Arrangement arrangement;
    arrangement.anchor = Anchor::kWall;
    Item item;
    if (kind < 0.5) {
      const double low_m = Chance(random_, 0.6) ? 0.06 : std::max(0.06, hole.bottom_m - 0.15);
      const double top_m = std::min(hole.top_m + 0.15, furnisher.room().height_m - 0.02);
      item = maker_.MakeOfSize("curtain", {0.13f, static_cast<float>(hole.width_m + 0.5),
                                           static_cast<float>(top_m - low_m)});
      item.z_m = low_m;
    } else {
      const double drop_m = (hole.top_m - hole.bottom_m) * Between(random_, 0.35, 1.0);
      item = maker_.MakeOfSize(
          "blinds", {0.06f, static_cast<float>(hole.width_m + 0.06), static_cast<float>(drop_m)});
      item.z_m = hole.top_m + 0.04 - item.top_m();
    }
    arrangement.Add(item);
    const Rigid3d T_world_wall = plan_.building.OpeningPose(hole, site) *
                                 Eigen::Translation3d(0.5 * thickness_m, 0, -hole.bottom_m);
    furnisher.PlaceAt(arrangement, T_world_wall);
  }

  void HangLamps(RoomFurnisher& furnisher) {
    static const std::vector<std::string> kKinds{"ceiling_lamp", "ceiling_panel", "pendant_lamp"};
    const Item lamp = maker_.Make(OneOf(random_, kKinds));
    const Eigen::Vector2d size_m = furnisher.inside_m().sizes();
    const int along = size_m.x() > size_m.y() ? 0 : 1;
    const int count = std::clamp(
        static_cast<int>(std::lround(furnisher.inside_m().volume() / kAreaPerLampM2)), 1, 4);
    const double light = LogBetween(random_, 0.35, 1.5);
    const Rgb white = RandomWhite(random_);
    for (int i = 0; i < count; ++i) {
      Eigen::Vector2d at_m = furnisher.inside_m().center();
      at_m[along] += ((i + 0.5) / count - 0.5) * size_m[along];
      HangLamp(lamp, at_m, Times(light * Between(random_, 0.8, 1.2), white), furnisher);
    }
  }

  void HangLamp(const Item& lamp, const Eigen::Vector2d& at_m, const Rgb& light,
                RoomFurnisher& furnisher) {
    const double z_m = furnisher.room().height_m - lamp.top_m();
    Furniture piece = MakeFurniture(lamp.kind, lamp.request);
    for (Light& source : piece.lights) source.radiant_rgb = light;
    const Rigid3d T = Rigid3d(Eigen::Translation3d(at_m.x(), at_m.y(), z_m));
    assembly_.Add(assembly_.FreeName(lamp.kind), piece, T);
    UprightBox box;
    box.centre_m = at_m;
    box.half_m = 0.5 * Eigen::Vector2d(lamp.depth_m(), lamp.width_m());
    box.low_m = z_m;
    box.high_m = furnisher.room().height_m;
    furnisher.space().Take(box);
  }

  const PlannedBuilding& plan_;
  PieceMaker& maker_;
  RandomStream& random_;
  WorldAssembly& assembly_;
};

std::vector<bool> NarrowRooms(const Building& building) {
  std::vector<bool> narrow;
  for (const Room& room : building.rooms()) {
    narrow.push_back(room.area_m.sizes().minCoeff() < kNarrowM);
  }
  return narrow;
}

}  // namespace

World MakeRandomWorld(WorldSplit split, std::uint64_t seed, const LabelVocabulary& vocabulary) {
  const std::uint64_t is_validation = split == WorldSplit::kValidation ? 1 : 0;
  RandomStream random(HashOf({seed, is_validation, 0x706c616eu}));
  PieceMaker maker(split, HashOf({seed, is_validation, 0x7069656365u}));
  WorldAssembly assembly("random_" + std::to_string(seed), vocabulary);
  assembly.SetAmbient(Times(LogBetween(random, 0.12, 0.45), RandomWhite(random)));
  const PlannedBuilding plan = PlanBuilding(split, random);
  AddBuilding(plan, maker, assembly);
  const std::vector<Room>& rooms = plan.building.rooms();
  const std::vector<RoomType> types = ChooseTypes(NarrowRooms(plan.building), random);
  Decorator decorator(plan, maker, assembly);
  for (std::size_t i = 0; i < rooms.size(); ++i) decorator.FurnishRoom(rooms[i], types[i]);
  return assembly.Finish();
}

}  // namespace semantic_slam
