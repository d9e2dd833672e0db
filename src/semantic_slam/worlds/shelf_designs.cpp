#include <algorithm>
#include <cmath>
#include <utility>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"
#include "semantic_slam/worlds/shelf_filling.h"

namespace semantic_slam {
namespace {

constexpr float kBoardM = 0.02f;

void MaybeFill(FurnitureBuilder& b, const ShelfSpace& space) {
  if (b.Random(0, 1) < b.Number("fill")) FillWithBooks(b, space);
}

// Squares in rows and columns, some of them closed by a door.
void BuildCubeShelf(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const int rows = std::max(1, static_cast<int>(std::lround(b.height() / 0.37f)));
  const int columns = std::max(1, static_cast<int>(std::lround(b.width() / 0.37f)));
  for (int row = 0; row <= rows; ++row) {
    const float low = (b.height() - kBoardM) * row / rows;
    b.Box("body", {-x, -y, low}, {x, y, low + kBoardM});
  }
  for (int row = 0; row < rows; ++row) {
    const float low = (b.height() - kBoardM) * row / rows + kBoardM;
    const float high = (b.height() - kBoardM) * (row + 1) / rows;
    for (int column = 0; column <= columns; ++column) {
      const float right = -y + (b.width() - kBoardM) * column / columns;
      b.Box("body", {-x, right, low}, {x, right + kBoardM, high});
      if (column == columns) break;
      const float left = -y + (b.width() - kBoardM) * (column + 1) / columns;
      const ShelfSpace space{-x, x, right + kBoardM, left, low, high};
      if (b.Chance(0.25)) {
        b.Box("paper", {-x, space.right_m + 0.01f, low},
              {x - 0.01f, space.left_m - 0.01f, low + 0.85f * (high - low)});  // a basket
      } else {
        MaybeFill(b, space);
      }
    }
  }
}

// Leans on the wall like a ladder: its boards are deeper the lower they are.
void BuildLadderShelf(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  for (const float side : {-y + 0.02f, y - 0.02f}) {
    b.Add("body", BeamMesh({x - 0.025f, side, 0}, {-x + 0.05f, side, b.height()}, {0.05f, 0.035f},
                           {0.05f, 0.035f}));
    b.Box("body", {-x, side - 0.012f, 0}, {-x + 0.03f, side + 0.012f, 0.97f * b.height()});
  }
  const int rows = std::max(3, static_cast<int>(std::lround(b.height() / 0.38f)));
  for (int i = 0; i < rows; ++i) {
    const float low = (0.1f + 0.8f * i / (rows - 1)) * b.height();
    const float front = x - 0.02f - (2 * x - 0.1f) * low / b.height();
    b.Box("body", {-x, -y + 0.03f, low}, {front, y - 0.03f, low + kBoardM});
    if (i + 1 == rows) break;
    const float high = (0.1f + 0.8f * (i + 1) / (rows - 1)) * b.height();
    MaybeFill(b, {-x, front, -y + 0.04f, y - 0.04f, low + kBoardM, high});
  }
  b.FitToSize();
}

// Boards between frames of square rod, open at the back.
void BuildEtagere(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float rod_m = 0.022f;
  for (const float rear : {-x, x - rod_m}) {
    for (const float right : {-y, y - rod_m}) {
      b.Box("paper", {rear, right, 0}, {rear + rod_m, right + rod_m, b.height()});
    }
  }
  const int rows = std::max(3, static_cast<int>(std::lround(b.height() / 0.42f)));
  for (int i = 0; i < rows; ++i) {
    const float low = 0.05f + (b.height() - 0.05f - kBoardM) * i / (rows - 1);
    b.Box("body", {-x, -y, low}, {x, y, low + kBoardM});
    if (i + 1 == rows) break;
    const float high = 0.05f + (b.height() - 0.05f - kBoardM) * (i + 1) / (rows - 1);
    const float middle = b.Random(-0.4f, 0.4f) * y;  // half of each board is free
    const bool left_half = i % 2 == 0;
    MaybeFill(b, {-x + 0.02f, x - 0.01f, left_half ? middle : -y + 0.03f,
                  left_half ? y - 0.03f : middle, low + kBoardM, high});
  }
}

// Doors below, open boards above.
void BuildCupboardShelf(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float base = 0.36f * b.height();
  b.Box("body", {-x, -y, 0}, {x - 0.025f, y, base});
  for (const auto& [right, left] : {std::pair(-y, 0.0f), {0.0f, y}}) {
    b.Box("body", {x - 0.025f, right + 0.003f, 0.06f}, {x - 0.006f, left - 0.003f, base - 0.003f});
    const float handle = right < -0.5f * y ? left - 0.05f : right + 0.05f;
    b.Box("paper", {x - 0.006f, handle - 0.008f, 0.5f * base}, {x, handle + 0.008f, 0.75f * base});
  }
  const float shallow = 0.3f * x;  // the upper part's front
  b.Box("body", {-x, -y, base}, {-x + 0.008f, y, b.height()});
  for (const float right : {-y, -0.5f * kBoardM, y - kBoardM}) {
    b.Box("body", {-x + 0.008f, right, base}, {shallow, right + kBoardM, b.height() - kBoardM});
  }
  b.Box("body", {-x, -y, b.height() - kBoardM}, {shallow, y, b.height()});
  const int rows = std::max(2, static_cast<int>(std::lround((b.height() - base) / 0.36f)));
  for (int i = 0; i < rows; ++i) {
    const float low = base + (b.height() - base - kBoardM) * i / rows;
    const float high = base + (b.height() - base - kBoardM) * (i + 1) / rows;
    if (i > 0)
      b.Box("body", {-x + 0.008f, -y + kBoardM, low}, {shallow, y - kBoardM, low + kBoardM});
    MaybeFill(b, {-x + 0.01f, shallow, 0.5f * kBoardM, y - kBoardM, low + kBoardM, high});
    MaybeFill(b, {-x + 0.01f, shallow, -y + kBoardM, -0.5f * kBoardM, low + kBoardM, high});
  }
}

// A box on a board, now and then.
void MaybeAddBoxes(FurnitureBuilder& b, float low_m, float rise_m, float inset_m) {
  const float y = 0.5f * b.width() - inset_m;
  for (float left = y - 0.04f; left > -y + 0.34f; left -= 0.38f) {
    if (b.Random(0, 1) > b.Number("fill")) continue;
    const float half = (0.5f - inset_m / b.depth()) * b.Random(0.6f, 0.9f) * b.depth();
    b.Box("boxes", {-half, left - b.Random(0.2f, 0.32f), low_m},
          {half, left, low_m + b.Random(0.4f, 0.85f) * rise_m});
  }
}

// Wire boards on castors, with bows at the ends to push it by.
void BuildTrolleyRack(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth() - 0.02f, y = 0.5f * b.width() - 0.02f;
  for (const float front : {-x, x}) {
    AddTubePair(b, "frame", {{front, y, 0.09f}, {front, y, b.height() - 0.02f}}, 0.013f);
    for (const float side : {-y, y}) {
      b.Add("frame", EllipsoidMesh({front, side, 0.045f}, {0.045f, 0.02f, 0.045f}, 12));
    }
  }
  AddTubePair(b, "frame", {{-x, y, b.height() - 0.02f}, {x, y, b.height() - 0.02f}}, 0.013f);
  constexpr int kRows = 3;
  for (int i = 0; i < kRows; ++i) {
    const float low = 0.14f + (b.height() - 0.32f) * i / (kRows - 1);
    b.Box("boards", {-x, -y, low}, {x, y, low + 0.015f});
    for (const float side : {-x, x}) {
      AddTube(b, "frame", {{side, -y, low + 0.06f}, {side, y, low + 0.06f}}, 0.006f);
    }
    if (i + 1 < kRows) MaybeAddBoxes(b, low + 0.015f, 0.5f * (b.height() - 0.32f) - 0.03f, 0.04f);
  }
  b.FitToSize();
}

// For a store: beams on edge carry each board, and the ends are braced.
void BuildStoreRack(FurnitureBuilder& b) {
  const float post_m = 0.05f;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  for (const float right : {-y, y - post_m}) {
    for (const float rear : {-x, x - post_m}) {
      b.Box("frame", {rear, right, 0}, {rear + post_m, right + post_m, b.height()});
    }
    const float middle = right + 0.5f * post_m;
    constexpr int kBraces = 4;
    for (int i = 0; i < kBraces; ++i) {
      const float low = (0.06f + 0.88f * i / kBraces) * b.height();
      const float side = i % 2 == 0 ? 1.0f : -1.0f;
      b.Add("frame", BeamMesh({-side * (x - 0.03f), middle, low},
                              {side * (x - 0.03f), middle, low + 0.22f * b.height()},
                              {0.03f, 0.02f}, {0.03f, 0.02f}));
    }
  }
  const int rows = std::max(2, static_cast<int>(std::lround(b.height() / 0.6f)));
  const float each_m = (b.height() - 0.25f) / std::max(1, rows - 1);
  for (int i = 0; i < rows; ++i) {
    const float low = 0.12f + each_m * i;
    for (const float rear : {-x + 0.005f, x - 0.035f}) {
      b.Box("frame", {rear, -y + post_m, low}, {rear + 0.03f, y - post_m, low + 0.09f});
    }
    b.Box("boards", {-x + 0.01f, -y + 0.01f, low + 0.09f}, {x - 0.01f, y - 0.01f, low + 0.11f});
    if (i + 1 < rows) MaybeAddBoxes(b, low + 0.11f, each_m - 0.13f, 0.06f);
  }
}

// Two thick boards without anything that can be seen to hold them.
void BuildFloatingShelf(FurnitureBuilder& b) {
  const float y = 0.5f * b.width();
  const float thick_m = 0.04f;
  b.Box("body", {0, -y, 0}, {b.depth(), y, thick_m});
  b.Box("body", {0, -y, b.height() - thick_m}, {0.9f * b.depth(), 0.4f * y, b.height()});
  if (b.Number("fill") > 0.5f) {
    FillWithBooks(b,
                  {0.01f, 0.95f * b.depth(), -y + 0.02f, y - 0.1f, thick_m, b.height() - thick_m});
  }
}

// An open box with a partition.
void BuildBoxShelf(FurnitureBuilder& b) {
  const float y = 0.5f * b.width();
  b.Box("body", {0, -y, 0}, {0.008f, y, b.height()});
  for (const float low : {0.0f, b.height() - kBoardM}) {
    b.Box("body", {0.008f, -y, low}, {b.depth(), y, low + kBoardM});
  }
  for (const float right : {-y, 0.2f * y, y - kBoardM}) {
    b.Box("body", {0.008f, right, kBoardM}, {b.depth(), right + kBoardM, b.height() - kBoardM});
  }
  if (b.Number("fill") > 0.5f) {
    FillWithBooks(
        b, {0.01f, 0.95f * b.depth(), -y + kBoardM, 0.2f * y, kBoardM, b.height() - kBoardM});
  }
}

}  // namespace

DesignTable ShelfDesigns() {
  return {{"bookshelf",
           {{BuildCubeShelf, {0.38f, 1.48f, 1.48f}},
            {BuildCupboardShelf, {0.42f, 1.1f, 2.05f}},
            {BuildEtagere, {0.34f, 1.0f, 1.8f}},
            {BuildLadderShelf, {0.45f, 0.75f, 1.9f}}}},
          {"rack", {{BuildStoreRack, {0.6f, 1.5f, 2.0f}}, {BuildTrolleyRack, {0.46f, 0.9f, 1.1f}}}},
          {"wall_shelf",
           {{BuildFloatingShelf, {0.24f, 1.1f, 0.42f}}, {BuildBoxShelf, {0.25f, 0.9f, 0.34f}}}}};
}

}  // namespace semantic_slam
