#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/cabinet_parts.h"
#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"

namespace semantic_slam {
namespace {

void BuildDresser(FurnitureBuilder& b) {
  const float feet_m = b.Number("feet_m");
  const float board_m = 0.022f;
  AddFeet(b, feet_m);
  AddCarcass(b, feet_m, b.height() - board_m);
  AddTopBoard(b, board_m);
  const int rows = static_cast<int>(std::lround(b.Number("rows")));
  const int columns = std::max(1, static_cast<int>(std::lround(b.width() / 0.75f)));
  const float each_m = b.width() / columns;
  for (int i = 0; i < columns; ++i) {
    const float right = -0.5f * b.width() + i * each_m;
    AddDrawers(b, {feet_m, b.height() - board_m, right, right + each_m}, rows);
  }
}

// A drawer above an open niche.
void BuildNightStand(FurnitureBuilder& b) {
  constexpr float kBoardM = 0.018f;
  const float feet_m = 0.12f;
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float drawer_m = feet_m + 0.55f * (b.height() - feet_m);
  AddFeet(b, feet_m);
  AddTopBoard(b, kBoardM);
  AddCarcass(b, drawer_m, b.height() - kBoardM);
  AddDrawers(b, WholeFront(b, drawer_m, b.height() - kBoardM), 1);
  b.Box("body", {rear, -side, feet_m}, {FaceOf(b), side, feet_m + kBoardM});
  for (const float y : {-side, side - kBoardM}) {
    b.Box("body", {rear, y, feet_m + kBoardM}, {FaceOf(b), y + kBoardM, drawer_m});
  }
  b.Box("body", {rear, -side + kBoardM, feet_m + kBoardM},
        {rear + 0.008f, side - kBoardM, drawer_m});
}

void BuildWardrobe(FurnitureBuilder& b) {
  const float plinth_m = 0.07f;
  const float cornice_m = 0.03f;
  b.Box("body", {-0.5f * b.depth() + 0.02f, -0.5f * b.width() + 0.02f, 0},
        {FaceOf(b) - 0.03f, 0.5f * b.width() - 0.02f, plinth_m});
  AddCarcass(b, plinth_m, b.height() - cornice_m);
  AddTopBoard(b, cornice_m);
  const int doors = std::max(1, static_cast<int>(std::lround(b.width() / 0.5f)));
  AddDoors(b, WholeFront(b, plinth_m, b.height() - cornice_m), doors);
}

// Low, on feet: doors at both ends and drawers in the middle.
void BuildSideboard(FurnitureBuilder& b) {
  const float feet_m = b.Number("feet_m");
  const float board_m = 0.025f;
  const float third_m = b.width() / 3;
  AddFeet(b, feet_m);
  AddCarcass(b, feet_m, b.height() - board_m);
  AddTopBoard(b, board_m);
  const float high = b.height() - board_m;
  AddDoors(b, {feet_m, high, -0.5f * b.width(), -0.5f * b.width() + third_m}, 1);
  AddDrawers(b, {feet_m, high, -0.5f * third_m, 0.5f * third_m}, 2);
  AddDoors(b, {feet_m, high, 0.5f * b.width() - third_m, 0.5f * b.width()}, 1);
}

void BuildFilingCabinet(FurnitureBuilder& b) {
  b.Box("body", {-0.5f * b.depth() + 0.01f, -0.5f * b.width() + 0.01f, 0},
        {FaceOf(b) - 0.02f, 0.5f * b.width() - 0.01f, 0.04f});
  AddCarcass(b, 0.04f, b.height());
  AddDrawers(b, WholeFront(b, 0.04f, b.height() - 0.01f),
             std::max(2, static_cast<int>(std::lround(b.height() / 0.33f))));
}

// On a wall, as above a kitchen's worktop. Its frame's origin is on the wall.
void BuildWallCabinet(FurnitureBuilder& b) {
  const float face = b.depth() - kFrontM - kHandleM;
  b.Box("body", {0, -0.5f * b.width(), 0}, {face, 0.5f * b.width(), b.height()});
  const int doors = std::max(1, static_cast<int>(std::lround(b.width() / 0.45f)));
  const float each_m = b.width() / doors;
  for (int i = 0; i < doors; ++i) {
    const float right = -0.5f * b.width() + i * each_m;
    b.Box("fronts", {face, right + kGapM, kGapM},
          {face + kFrontM, right + each_m - kGapM, b.height() - kGapM});
    const float y = i % 2 == 0 ? right + each_m - 0.05f : right + 0.05f;
    b.Box("handles", {face + kFrontM, y - 0.007f, 0.06f}, {b.depth(), y + 0.007f, 0.2f});
  }
}

FurnitureKind CupboardOf(const std::string& name, const std::string& label, Mount mount,
                         const Eigen::Vector3f& size_m, const Material& body,
                         const Material& fronts, void (*build)(FurnitureBuilder&)) {
  return {
      name,
      label,
      mount,
      size_m,
      {{"body", body}, {"fronts", fronts}, {"handles", MakeMaterial("metal", {60, 60, 64}, 0.5f)}},
      {},
      build};
}

FurnitureKind WithTop(FurnitureKind kind) {
  kind.materials.emplace("top", kind.materials.at("body"));
  return kind;
}

}  // namespace

std::vector<FurnitureKind> StorageKinds() {
  const Material oak = MakeMaterial("wood", {172, 128, 82}, 0.2f);
  const Material pine = MakeMaterial("wood", {205, 165, 110}, 0.2f);
  const Material walnut = MakeMaterial("wood", {110, 72, 45}, 0.25f);
  const Material white = MakeMaterial("plastic", {225, 225, 220}, 0.25f);
  const Material steel = MakeMaterial("metal", {150, 155, 160}, 0.3f);
  FurnitureKind dresser = CupboardOf("dresser", "dresser", Mount::kFloor, {0.48f, 1.2f, 0.82f},
                                     pine, pine, BuildDresser);
  dresser.numbers = {{"rows", {3, 1, 6}}, {"feet_m", {0.1, 0.04, 0.25}}};
  FurnitureKind sideboard = CupboardOf("sideboard", "cabinet", Mount::kFloor, {0.45f, 1.6f, 0.75f},
                                       walnut, walnut, BuildSideboard);
  sideboard.numbers = {{"feet_m", {0.14, 0.04, 0.3}}};
  FurnitureKind tv_stand = CupboardOf("tv_stand", "cabinet", Mount::kFloor, {0.42f, 1.6f, 0.5f},
                                      oak, white, BuildSideboard);
  tv_stand.numbers = {{"feet_m", {0.12, 0.04, 0.2}}};
  return {WithTop(dresser),
          WithTop(sideboard),
          WithTop(tv_stand),
          WithTop(CupboardOf("night_stand", "night_stand", Mount::kFloor, {0.42f, 0.48f, 0.55f},
                             oak, oak, BuildNightStand)),
          WithTop(CupboardOf("wardrobe", "cabinet", Mount::kFloor, {0.62f, 1.5f, 2.1f}, oak, white,
                             BuildWardrobe)),
          CupboardOf("filing_cabinet", "cabinet", Mount::kFloor, {0.6f, 0.42f, 1.0f}, steel, steel,
                     BuildFilingCabinet),
          CupboardOf("wall_cabinet", "cabinet", Mount::kWall, {0.36f, 0.9f, 0.7f}, white, white,
                     BuildWallCabinet)};
}

}  // namespace semantic_slam
