#include "semantic_slam/worlds/building_file.h"

#include <string>

#include "semantic_slam/worlds/furniture_file.h"
#include "semantic_slam/worlds/located_error.h"
#include "semantic_slam/worlds/opening_pieces.h"
#include "semantic_slam/worlds/placement_file.h"

namespace semantic_slam {
namespace {

// What stands in a hole of a wall.
struct OpeningPlan {
  YamlReader reader;
  std::string kind;
  WallOpening hole;
};

Room ReadRoom(YamlReader& reader, const MaterialPalette& palette) {
  Room room;
  room.name = reader.Require<std::string>("name");
  room.area_m.extend(ReadPlace(reader, "from"));
  room.area_m.extend(ReadPlace(reader, "to"));
  reader.Read("height_m", room.height_m);
  room.floor = palette.Read(reader, "floor", MakeMaterial("parquet", {168, 126, 84}, 0.2f));
  room.ceiling = palette.Read(reader, "ceiling", MakeMaterial("plaster", {238, 238, 236}));
  room.skirting = palette.Read(reader, "skirting", MakeMaterial("wood", {226, 222, 214}, 0.2f));
  const Material walls = palette.Read(reader, "walls", MakeMaterial("plaster", {226, 222, 212}));
  const char* names[] = {"west_wall", "south_wall", "east_wall", "north_wall"};
  for (int i = 0; i < 4; ++i) room.walls[i] = palette.Read(reader, names[i], walls);
  reader.Finish();
  return room;
}

OpeningPlan ReadHole(const YamlReader& entry) {
  OpeningPlan plan{entry, "", {}};
  YamlReader& reader = plan.reader;
  plan.kind = reader.Require<std::string>("kind");
  const bool is_window = plan.kind == "window";
  if (!is_window && plan.kind != "door" && plan.kind != "passage") {
    reader.Refuse("kind", "door, passage or window");
  }
  plan.hole.at_m = ReadPlace(reader, "at");
  double height_m = is_window ? 1.3 : 2.05;
  if (is_window) {
    plan.hole.width_m = 1.4;
    plan.hole.bottom_m = 0.9;
    reader.Read("sill_m", plan.hole.bottom_m);
  }
  reader.Read("width_m", plan.hole.width_m);
  reader.Read("height_m", height_m);
  plan.hole.top_m = plan.hole.bottom_m + height_m;
  return plan;
}

const WallSite& SiteFacing(OpeningPlan& plan, const std::vector<WallSite>& sites) {
  if (!plan.reader.Has("opens_to")) return sites.front();
  const auto room = plan.reader.Require<std::string>("opens_to");
  for (const WallSite& site : sites) {
    if (site.room->name == room) return site;
  }
  plan.reader.Refuse("opens_to", "a room whose wall it is in");
}

void AddDoor(OpeningPlan& plan, const Building& building, const MaterialPalette& palette,
             WorldAssembly& assembly) {
  const std::vector<WallSite> sites = building.SitesOf(plan.hole);
  const FittedPiece fitted = FitDoor(building, plan.hole, SiteFacing(plan, sites));
  FurnitureRequest request;
  request.size_m = fitted.size_m;
  if (plan.kind == "passage") request.numbers["leaf"] = 0.0;
  std::string hinge = "left";
  plan.reader.Read("hinge", hinge);
  if (hinge != "left" && hinge != "right") plan.reader.Refuse("hinge", "left or right");
  request.numbers["hinge_left"] = hinge == "left" ? 1.0 : 0.0;
  if (plan.reader.Has("open_deg")) {
    request.numbers["open_deg"] = plan.reader.Require<double>("open_deg");
  }
  AddPiece(plan.reader, "door", request, palette, {fitted.T_world_object, std::nullopt, ""},
           assembly);
}

void AddWindow(OpeningPlan& plan, const Building& building, const MaterialPalette& palette,
               WorldAssembly& assembly) {
  const std::vector<WallSite> sites = building.SitesOf(plan.hole);
  const FittedPiece fitted = FitWindow(building, plan.hole, SiteFacing(plan, sites));
  FurnitureRequest request;
  request.size_m = fitted.size_m;
  AddPiece(plan.reader, "window", request, palette, {fitted.T_world_object, std::nullopt, ""},
           assembly);
}

void AddOpening(OpeningPlan& plan, const Building& building, const MaterialPalette& palette,
                WorldAssembly& assembly) {
  bool framed = true;
  if (plan.kind == "passage") plan.reader.Read("frame", framed);
  if (plan.kind == "window") {
    AddWindow(plan, building, palette, assembly);
  } else if (framed) {
    AddDoor(plan, building, palette, assembly);
  } else {
    plan.reader.Finish();
  }
}

}  // namespace

Building ReadBuilding(YamlReader& file, const MaterialPalette& palette, WorldAssembly& assembly) {
  double wall_thickness_m = 0.14;
  file.Read("wall_thickness_m", wall_thickness_m);
  Building building = Located(file, [&] { return Building(wall_thickness_m); });
  for (YamlReader& reader : file.Entries("rooms")) {
    const Room room = ReadRoom(reader, palette);
    Located(reader, [&] { building.AddRoom(room); });
  }
  std::vector<OpeningPlan> plans;
  for (const YamlReader& reader : file.Entries("openings")) {
    plans.push_back(ReadHole(reader));
    Located(reader, [&] { building.AddOpening(plans.back().hole); });
  }
  assembly.AddBuilding(building);
  for (OpeningPlan& plan : plans) AddOpening(plan, building, palette, assembly);
  return building;
}

}  // namespace semantic_slam
