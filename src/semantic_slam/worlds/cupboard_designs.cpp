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

// An apothecary's: many small drawers with a knob each, on high straight legs.
void BuildApothecaryChest(FurnitureBuilder& b) {
  constexpr int kColumns = 5;
  constexpr int kRows = 4;
  const float legs_m = 0.3f * b.height();
  const float high = b.height() - kBoardM;
  const float y = 0.5f * b.width() - 0.01f;
  AddLegs(b, "body", b.depth() - 0.06f, b.width() - 0.02f, legs_m, 0.05f);
  AddCarcass(b, legs_m, high);
  AddTopBoard(b, kBoardM);
  const float wide_m = 2 * y / kColumns, rise_m = (high - legs_m - 0.02f) / kRows;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const float right = -y + i % kColumns * wide_m;
    const float low = legs_m + 0.01f + static_cast<float>(i / kColumns) * rise_m;
    AddFront(b, {low, low + rise_m, right, right + wide_m});
    b.Add("handles",
          EllipsoidMesh({FaceOf(b) + kFrontM, right + 0.5f * wide_m, low + 0.5f * rise_m},
                        {0.016f, 0.014f, 0.014f}, 8));
  }
  b.FitToSize();
}

// A door at its right, drawers at its left, and a gap above the floor.
void BuildDoorChest(FurnitureBuilder& b) {
  const float legs_m = 0.16f * b.height();
  const float high = b.height() - 0.035f;
  const float y = 0.5f * b.width();
  AddSplayedLegs(b, "handles", {0.92f * b.depth(), 0.94f * b.width()},
                 {0.8f * b.depth(), 0.88f * b.width()}, legs_m, 0.015f);
  AddCarcass(b, legs_m, high);
  AddTopBoard(b, 0.035f);
  AddDrawers(b, {legs_m, high, -0.1f * y, y}, 4);
  AddDoors(b, {legs_m, high, -y, -0.1f * y}, 1);
  b.FitToSize();
}

// Of a farm: doors with crossed boards at both ends, open shelves between them.
void BuildBarnSideboard(FurnitureBuilder& b) {
  const float high = b.height() - 0.035f;
  const float y = 0.5f * b.width();
  const float open = 0.34f * y;
  const float rear = -0.5f * b.depth(), face = FaceOf(b);
  AddFeet(b, 0.1f);
  AddTopBoard(b, 0.035f);
  b.Box("body", {rear, -open, 0.1f}, {rear + 0.01f, open, high});
  for (const float low : {0.1f, 0.4f * b.height(), 0.68f * b.height()}) {
    b.Box("body", {rear + 0.01f, -open, low}, {face, open, low + kBoardM});
  }
  for (const auto& [right, left] : {std::pair(-y, -open), {open, y}}) {
    b.Box("body", {rear, right, 0.1f}, {face, left, high});
    AddDoors(b, {0.1f, high, right, left}, 1);
    const float low = 0.15f, top = high - 0.05f, front = face + kFrontM + 0.006f;
    const Eigen::Vector2f board(0.012f, 0.05f);
    for (const auto& [from, to] : {std::pair(right, left), {left, right}}) {
      const float inset = from < to ? 0.06f : -0.06f;
      b.Add("body", BeamMesh({front, from + inset, low}, {front, to - inset, top}, board, board));
    }
  }
}

// Its ends are half round, its doors of narrow slats, and it stands on a plinth.
void BuildRoundEndSideboard(FurnitureBuilder& b) {
  const float plinth_m = 0.08f;
  const float high = b.height() - 0.03f;
  const Eigen::Vector2f plan(b.depth(), b.width());
  const float round_m = 0.49f * std::min(b.depth(), b.width());
  b.Add("handles", SlabMesh(RoundedRectangle(0.86f * plan, 0.86f * round_m), 0, plinth_m));
  b.Add("body", SlabMesh(RoundedRectangle(0.95f * plan, 0.95f * round_m), plinth_m, high));
  b.Add("top", SlabMesh(RoundedRectangle(plan, round_m), high, b.height()));
  const float y = 0.5f * b.width() - b.depth() * 0.5f;
  const int slats = std::max(6, static_cast<int>(std::lround(2 * y / 0.03f)));
  for (int i = 0; i < slats; ++i) {
    const float at = -y + 2 * y * (i + 0.5f) / slats;
    b.Add("fronts", CylinderMesh({0.475f * b.depth(), at, plinth_m + 0.02f}, 0.7f * y / slats,
                                 0.7f * y / slats, high - plinth_m - 0.04f, 8));
  }
}

// A rail with clothes between two boards, shelves and drawers beside it: no doors at all.
void BuildOpenWardrobe(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float middle = 0.2f * y;  // between clothes, at the right, and shelves
  for (const float right : {-y, middle, y - kBoardM}) {
    b.Box("body", {-x, right, 0}, {x - 0.01f, right + kBoardM, b.height() - kBoardM});
  }
  b.Box("top", {-x, -y, b.height() - kBoardM}, {x, y, b.height()});
  b.Box("body", {-x, -y + kBoardM, 0.08f}, {x - 0.01f, middle, 0.1f});
  b.Box("body", {-x, -y + kBoardM, 0.1f}, {-x + 0.01f, middle, b.height() - kBoardM});
  b.Box("body", {-x, middle + kBoardM, 0.08f * b.height()},
        {-x + 0.01f, y - kBoardM, b.height() - kBoardM});
  for (const float low : {0.08f, 0.24f, 0.4f, 0.58f, 0.78f}) {
    b.Box("body", {-x + 0.01f, middle + kBoardM, low * b.height()},
          {x - 0.02f, y - kBoardM, low * b.height() + kBoardM});
  }
  for (const float low : {0.09f, 0.25f}) {
    b.Box("fronts", {-x + 0.05f, middle + kBoardM + 0.004f, low * b.height() + 0.02f},
          {x, y - kBoardM - 0.004f, (low + 0.14f) * b.height()});
  }
  const float rail = b.height() - 0.14f;
  AddTube(b, "handles", {{0, -y + kBoardM, rail}, {0, middle, rail}}, 0.013f);
  for (float at = -y + 0.09f; at < middle - 0.08f; at += b.Random(0.06f, 0.13f)) {
    const float low = rail - b.Random(0.75f, 1.2f);
    const float half_m = b.Random(0.32f, 0.42f) * b.depth();
    AddPadding(b, "fronts", {-half_m, at - 0.022f, std::max(low, 0.16f)},
               {half_m, at + 0.022f, rail - 0.05f}, 0.02f);
    b.Add("handles", BoxMesh({0, at, rail - 0.025f}, {0.008f, 0.008f, 0.06f}));
  }
}

// Up to the ceiling: a row of small doors above the large ones, with long upright bars to pull.
void BuildStackedWardrobe(FurnitureBuilder& b) {
  const float plinth_m = 0.07f;
  const float upper = 0.78f * b.height();
  const float y = 0.5f * b.width();
  const int doors = std::max(2, static_cast<int>(std::lround(b.width() / 0.5f)));
  const float each_m = 2 * y / doors;
  b.Box("body", {-0.48f * b.depth(), -y + 0.01f, 0}, {FaceOf(b) - 0.04f, y - 0.01f, plinth_m});
  AddCarcass(b, plinth_m, b.height() - kBoardM);
  AddTopBoard(b, kBoardM);
  for (int i = 0; i < doors; ++i) {
    const float right = -y + i * each_m;
    AddFront(b, {plinth_m, upper, right, right + each_m});
    AddFront(b, {upper, b.height() - kBoardM, right, right + each_m});
    const float at = i % 2 == 0 ? right + each_m - 0.05f : right + 0.05f;
    AddHandle(b, at, 0.5f * (plinth_m + upper), 0.016f, 0.55f * upper);
  }
}

}  // namespace

DesignTable CupboardDesigns() {
  return {{"dresser",
           {{BuildApothecaryChest, {0.42f, 1.05f, 0.95f}}, {BuildDoorChest, {0.45f, 1.3f, 0.86f}}}},
          {"sideboard",
           {{BuildBarnSideboard, {0.42f, 1.5f, 0.84f}},
            {BuildRoundEndSideboard, {0.44f, 1.6f, 0.76f}}}},
          {"wardrobe",
           {{BuildOpenWardrobe, {0.55f, 1.6f, 2.0f}}, {BuildStackedWardrobe, {0.6f, 2.0f, 2.4f}}}}};
}

}  // namespace semantic_slam
