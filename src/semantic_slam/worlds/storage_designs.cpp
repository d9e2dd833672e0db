#include <algorithm>
#include <cmath>
#include <utility>

#include "semantic_slam/worlds/cabinet_parts.h"
#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kBoardM = 0.02f;

// An open niche: top, bottom, sides and back between two places (y).
void AddNiche(FurnitureBuilder& b, const FrontArea& area) {
  const float rear = -0.5f * b.depth();
  const float face = FaceOf(b) + kFrontM;
  for (const float low : {area.low_m, area.high_m - kBoardM}) {
    b.Box("body", {rear, area.right_m, low}, {face, area.left_m, low + kBoardM});
  }
  for (const float right : {area.right_m, area.left_m - kBoardM}) {
    b.Box("body", {rear, right, area.low_m + kBoardM},
          {face, right + kBoardM, area.high_m - kBoardM});
  }
  b.Box("body", {rear, area.right_m + kBoardM, area.low_m + kBoardM},
        {rear + 0.008f, area.left_m - kBoardM, area.high_m - kBoardM});
}

// Narrow and high, with many drawers, the upper ones side by side.
void BuildTallChest(FurnitureBuilder& b) {
  const float plinth_m = 0.08f;
  const float high = b.height() - kBoardM;
  const float pair = high - 0.16f * b.height();
  b.Box("body", {-0.5f * b.depth() + 0.01f, -0.5f * b.width() + 0.01f, 0},
        {FaceOf(b) - 0.03f, 0.5f * b.width() - 0.01f, plinth_m});
  AddCarcass(b, plinth_m, high);
  AddTopBoard(b, kBoardM);
  AddDrawers(b, WholeFront(b, plinth_m, pair), 4);
  AddDrawers(b, {pair, high, -0.5f * b.width(), 0}, 1);
  AddDrawers(b, {pair, high, 0, 0.5f * b.width()}, 1);
}

// On high legs that lean outwards, with round knobs.
void BuildLegChest(FurnitureBuilder& b) {
  const float legs_m = 0.28f * b.height();
  AddSplayedLegs(b, "body", {0.94f * b.depth(), 0.98f * b.width()},
                 {0.72f * b.depth(), 0.84f * b.width()}, legs_m, 0.02f);
  AddCarcass(b, legs_m, b.height());
  for (int column = 0; column < 3; ++column) {
    const float each_m = (b.width() - 2 * kBoardM) / 3;
    const float right = -0.5f * b.width() + kBoardM + column * each_m;
    const float rise_m = (b.height() - legs_m - 2 * kBoardM) / 2;
    for (int row = 0; row < 2; ++row) {
      const float low = legs_m + kBoardM + row * rise_m;
      AddFront(b, {low, low + rise_m, right, right + each_m});
      b.Add("handles",
            EllipsoidMesh({0.5f * b.depth() - 0.012f, right + 0.5f * each_m, low + 0.6f * rise_m},
                          {0.012f, 0.018f, 0.018f}, 10));
    }
  }
  b.Box("top", {-0.5f * b.depth(), -0.5f * b.width(), b.height()},
        {FaceOf(b), 0.5f * b.width(), b.height() + 0.015f});
  b.FitToSize();
}

// Two columns of broad drawers and a mirror-less gallery board at the rear.
void BuildGalleryChest(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float top = 0.82f * b.height();
  AddFeet(b, 0.07f);
  AddCarcass(b, 0.07f, top - kBoardM);
  b.Box("top", {rear, -0.5f * b.width(), top - kBoardM},
        {0.5f * b.depth() - 0.01f, 0.5f * b.width(), top});
  b.Add("top", BeamMesh({rear + 0.012f, 0, top}, {rear + 0.012f, 0, b.height()},
                        {0.024f, b.width()}, {0.024f, 0.7f * b.width()}));
  const float upper = 0.7f * top;
  AddDrawers(b, {upper, top - kBoardM, -0.5f * b.width(), 0}, 1);
  AddDrawers(b, {upper, top - kBoardM, 0, 0.5f * b.width()}, 1);
  AddDrawers(b, WholeFront(b, 0.07f, upper), 2);
}

// An open niche between two doors, on a frame of metal.
void BuildNicheSideboard(FurnitureBuilder& b) {
  const float legs_m = 0.26f * b.height();
  const float y = 0.5f * b.width();
  const float high = b.height() - kBoardM;
  for (const float side : {-1.0f, 1.0f}) {
    const float at = side * 0.4f * b.width();
    b.Box("handles", {-0.42f * b.depth(), at - 0.012f, 0}, {0.4f * b.depth(), at + 0.012f, 0.024f});
    for (const float x : {-0.42f * b.depth(), 0.4f * b.depth() - 0.024f}) {
      b.Box("handles", {x, at - 0.012f, 0.024f}, {x + 0.024f, at + 0.012f, legs_m});
    }
  }
  AddTopBoard(b, kBoardM);
  for (const auto& [right, left] : {std::pair(-y, -y / 3), {y / 3, y}}) {
    b.Box("body", {-0.5f * b.depth(), right, legs_m}, {FaceOf(b), left, high});
    AddDoors(b, {legs_m, high, right, left}, 1);
  }
  AddNiche(b, {legs_m, high, -y / 3, y / 3});
  b.Box("body", {-0.48f * b.depth(), -y / 3 + kBoardM, 0.5f * (legs_m + high)},
        {FaceOf(b), y / 3 - kBoardM, 0.5f * (legs_m + high) + 0.015f});
}

// Down to the floor, its doors covered with upright slats.
void BuildSlattedSideboard(FurnitureBuilder& b) {
  const float plinth_m = 0.05f;
  const float high = b.height() - kBoardM;
  const float face = FaceOf(b);
  AddCarcass(b, plinth_m, high);
  AddTopBoard(b, kBoardM);
  b.Box("handles", {-0.46f * b.depth(), -0.46f * b.width(), 0},
        {0.36f * b.depth(), 0.46f * b.width(), plinth_m});
  const float y = 0.5f * b.width() - 0.03f;
  const int slats = static_cast<int>(std::lround(2 * y / 0.035f));
  for (int i = 0; i < slats; ++i) {
    const float right = -y + 2 * y * i / slats;
    b.Box("fronts", {face, right, plinth_m + 0.03f},
          {face + kFrontM, right + y / slats, high - 0.02f});
  }
  b.Box("body", {face, -0.5f * b.width(), plinth_m}, {0.5f * b.depth(), -y, high});
  b.Box("body", {face, y, plinth_m}, {0.5f * b.depth(), 0.5f * b.width(), high});
}

// As high as one's chest: glass-less showcase niches above doors.
void BuildHighboard(FurnitureBuilder& b) {
  const float legs_m = 0.1f * b.height();
  const float middle = 0.55f * b.height();
  const float y = 0.5f * b.width();
  AddFeet(b, legs_m);
  AddCarcass(b, legs_m, middle);
  AddDoors(b, WholeFront(b, legs_m, middle), 2);
  AddNiche(b, {middle, b.height() - kBoardM, -y, 0});
  b.Box("body", {-0.5f * b.depth(), 0, middle}, {FaceOf(b), y, b.height() - kBoardM});
  AddDrawers(b, {middle, b.height() - kBoardM, 0, y}, 2);
  AddTopBoard(b, kBoardM);
}

// Two sliding doors that overlap, in a frame.
void BuildSlidingWardrobe(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float rail_m = 0.05f;
  b.Box("body", {-x, -y, 0}, {x - 0.06f, y, b.height()});
  b.Box("body", {x - 0.06f, -y, 0}, {x, y, rail_m});
  b.Box("body", {x - 0.06f, -y, b.height() - rail_m}, {x, y, b.height()});
  b.Box("fronts", {x - 0.06f, -y, rail_m}, {x - 0.035f, 0.02f, b.height() - rail_m});
  b.Box("fronts", {x - 0.03f, -0.02f, rail_m}, {x - 0.005f, y, b.height() - rail_m});
  b.Box("handles", {x - 0.035f, -y, rail_m}, {x - 0.028f, -y + 0.03f, b.height() - rail_m});
  for (const float right : {-0.02f, y - 0.03f}) {
    b.Box("handles", {x - 0.005f, right, rail_m}, {x, right + 0.03f, b.height() - rail_m});
  }
  b.Box("top", {-x, -y + 0.001f, b.height() - 0.001f}, {x - 0.07f, y - 0.001f, b.height()});
}

// Farmhouse: doors with raised fields above two drawers, and a broad cornice.
void BuildPanelledWardrobe(FurnitureBuilder& b) {
  const float y = 0.5f * b.width();
  const float feet_m = 0.1f;
  const float drawers = 0.24f * b.height();
  const float high = b.height() - 0.08f;
  AddFeet(b, feet_m);
  b.Box("body", {-0.5f * b.depth(), -y + 0.03f, feet_m}, {FaceOf(b), y - 0.03f, high});
  b.Add("top", BeamMesh({-0.02f, 0, high}, {0, 0, b.height()},
                        {b.depth() - 0.06f, b.width() - 0.06f}, {b.depth(), b.width()}));
  for (const auto& [right, left] : {std::pair(-y + 0.03f, 0.0f), {0.0f, y - 0.03f}}) {
    AddDrawers(b, {feet_m, drawers, right, left}, 1);
    AddDoors(b, {drawers, high, right, left}, 1);
    const float face = FaceOf(b) + kFrontM;
    for (const auto& [low, top] : {std::pair(0.28f, 0.58f), {0.62f, 0.93f}}) {
      b.Box("body", {face, right + 0.09f, low * b.height()},
            {face + 0.01f, left - 0.09f, top * b.height()});
    }
  }
}

// A low bench: one open shelf along its whole width.
void BuildOpenBench(FurnitureBuilder& b) {
  const float y = 0.5f * b.width();
  const float legs_m = 0.3f * b.height();
  AddSplayedLegs(b, "handles", {0.9f * b.depth(), 0.92f * b.width()},
                 {0.7f * b.depth(), 0.8f * b.width()}, legs_m, 0.016f);
  AddNiche(b, {legs_m, b.height() - kBoardM, -y, y});
  b.Box("body", {-0.5f * b.depth(), -0.01f, legs_m + kBoardM},
        {FaceOf(b), 0.01f, b.height() - 2 * kBoardM});
  AddTopBoard(b, kBoardM);
  b.Box("fronts", {FaceOf(b), 0.01f, legs_m + kBoardM},
        {0.5f * b.depth(), y - kBoardM, b.height() - 2 * kBoardM});
  b.FitToSize();
}

// Two storeys of boards on round posts, wholly open.
void BuildMediaRack(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth() - 0.03f, y = 0.5f * b.width() - 0.03f;
  for (const float low : {0.08f * b.height(), 0.52f * b.height()}) {
    b.Box("body", {-x - 0.03f, -y - 0.03f, low}, {x + 0.03f, y + 0.03f, low + kBoardM});
  }
  b.Box("top", {-x - 0.03f, -y - 0.03f, b.height() - kBoardM}, {x + 0.03f, y + 0.03f, b.height()});
  for (const float at : {-y, 0.0f, y}) {
    for (const float front : {-x, x}) {
      b.Add("handles", CylinderMesh({front, at, 0}, 0.015f, 0.015f, b.height() - kBoardM, 10));
    }
  }
  b.Box("fronts", {-0.5f * x, -0.8f * y, 0.08f * b.height() + kBoardM},
        {0.7f * x, -0.3f * y, 0.08f * b.height() + 0.11f});  // a player
}

// A drum with a drawer in it, on three legs.
void BuildRoundNightStand(FurnitureBuilder& b) {
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f out =
        Turned(2.0944f * static_cast<float>(i)).linear().col(0).cast<float>();
    AddTube(
        b, "body",
        {0.19f * out + Eigen::Vector3f(0, 0, 0.012f), 0.13f * out + Eigen::Vector3f(0, 0, 0.3f)},
        0.014f);
  }
  b.Add("body", CylinderMesh({0, 0, 0.28f}, 0.2f, 0.2f, 0.2f, 32));
  b.Add("top", CylinderMesh({0, 0, 0.48f}, 0.215f, 0.215f, 0.018f, 32));
  AddPadding(b, "fronts", {0.1f, -0.095f, 0.31f}, {0.205f, 0.095f, 0.46f}, 0.008f);
  b.Add("handles", EllipsoidMesh({0.212f, 0, 0.39f}, {0.012f, 0.016f, 0.016f}, 10));
  b.FitToSize();
}

// An open box on a frame.
void BuildOpenNightStand(FurnitureBuilder& b) {
  const float y = 0.5f * b.width();
  const float legs_m = 0.4f * b.height();
  for (const float x : {-0.45f * b.depth(), 0.38f * b.depth()}) {
    for (const float right : {-y, y - 0.02f}) {
      b.Box("handles", {x, right, 0}, {x + 0.02f, right + 0.02f, legs_m});
    }
    b.Box("handles", {x, -y + 0.02f, 0}, {x + 0.02f, y - 0.02f, 0.02f});
  }
  AddNiche(b, {legs_m, b.height() - kBoardM, -y, y});
  b.Box("fronts", {-0.4f * b.depth(), -0.3f * b.width(), legs_m + kBoardM},
        {0.3f * b.depth(), 0.2f * b.width(), legs_m + kBoardM + 0.04f});  // a book
  AddTopBoard(b, kBoardM);
  b.FitToSize();
}

// Drawers side by side in pairs, wider than high.
void BuildLateralFile(FurnitureBuilder& b) {
  AddCarcass(b, 0, b.height());
  const int rows = std::max(2, static_cast<int>(std::lround(b.height() / 0.36f)));
  AddDrawers(b, {0.05f, b.height() - 0.02f, -0.5f * b.width(), 0}, rows);
  AddDrawers(b, {0.05f, b.height() - 0.02f, 0, 0.5f * b.width()}, rows);
}

// Low, on castors, to stand below a desk.
void BuildRollingPedestal(FurnitureBuilder& b) {
  const float low = 0.07f;
  for (const float x : {-0.4f * b.depth(), 0.32f * b.depth()}) {
    for (const float y : {-0.38f * b.width(), 0.38f * b.width()}) {
      b.Add("handles", EllipsoidMesh({x, y, 0.035f}, {0.035f, 0.018f, 0.036f}, 12));
    }
  }
  AddCarcass(b, low, b.height());
  AddDrawers(b, WholeFront(b, 0.5f * b.height(), b.height() - 0.01f), 2);
  AddDrawers(b, WholeFront(b, low, 0.5f * b.height()), 1);
  b.FitToSize();
}

}  // namespace

DesignTable StorageDesigns() {
  return {
      {"dresser",
       {{BuildTallChest, {0.46f, 0.62f, 1.25f}},
        {BuildLegChest, {0.45f, 1.4f, 0.8f}},
        {BuildGalleryChest, {0.5f, 1.1f, 1.02f}}}},
      {"sideboard",
       {{BuildNicheSideboard, {0.42f, 1.7f, 0.72f}},
        {BuildSlattedSideboard, {0.45f, 1.8f, 0.7f}},
        {BuildHighboard, {0.42f, 1.1f, 1.3f}}}},
      {"wardrobe",
       {{BuildSlidingWardrobe, {0.66f, 2.0f, 2.2f}}, {BuildPanelledWardrobe, {0.6f, 1.25f, 2.0f}}}},
      {"night_stand",
       {{BuildOpenNightStand, {0.4f, 0.45f, 0.55f}},
        {BuildRoundNightStand, {0.44f, 0.44f, 0.52f}}}},
      {"filing_cabinet",
       {{BuildLateralFile, {0.5f, 0.95f, 1.1f}}, {BuildRollingPedestal, {0.6f, 0.42f, 0.62f}}}},
      {"tv_stand",
       {{BuildOpenBench, {0.42f, 1.5f, 0.48f}},
        {BuildNicheSideboard, {0.4f, 1.8f, 0.52f}},
        {BuildMediaRack, {0.42f, 1.3f, 0.5f}}}}};
}

}  // namespace semantic_slam
