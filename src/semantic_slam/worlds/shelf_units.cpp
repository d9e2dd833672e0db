#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shelf_filling.h"

namespace semantic_slam {
namespace {

constexpr float kBoardM = 0.02f;

// Sides, top, back and boards; returns the spaces between the boards.
std::vector<ShelfSpace> AddCase(FurnitureBuilder& b, int rows) {
  const float rear = -0.5f * b.depth();
  const float front = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float plinth_m = 0.06f;
  b.Box("body", {rear, -side, 0}, {front, -side + kBoardM, b.height()});
  b.Box("body", {rear, side - kBoardM, 0}, {front, side, b.height()});
  b.Box("body", {rear, -side + kBoardM, plinth_m},
        {rear + 0.006f, side - kBoardM, b.height() - kBoardM});
  b.Box("body", {front - 0.04f, -side + kBoardM, 0}, {front - 0.02f, side - kBoardM, plinth_m});
  const float each_m = (b.height() - plinth_m - kBoardM) / rows;
  std::vector<ShelfSpace> spaces;
  for (int i = 0; i <= rows; ++i) {
    const float low = plinth_m + i * each_m;
    b.Box("body", {rear + (i < rows ? 0.006f : 0.0f), -side + kBoardM, low},
          {front, side - kBoardM, low + kBoardM});
    if (i == rows) break;
    spaces.push_back(
        {rear + 0.006f, front, -side + kBoardM, side - kBoardM, low + kBoardM, low + each_m});
  }
  return spaces;
}

int RowsOf(const FurnitureBuilder& b) {
  return std::max(1, static_cast<int>(std::lround((b.height() - 0.08f) / 0.34f)));
}

void BuildBookshelf(FurnitureBuilder& b) {
  for (const ShelfSpace& space : AddCase(b, RowsOf(b))) {
    if (b.Random(0, 1) < b.Number("fill")) FillWithBooks(b, space);
  }
}

// Posts and boards only, with boxes and vases on them.
void BuildRack(FurnitureBuilder& b) {
  const float post_m = 0.035f;
  const float x_m = 0.5f * (b.depth() - post_m);
  const float y_m = 0.5f * (b.width() - post_m);
  for (const float x : {-x_m, x_m}) {
    for (const float y : {-y_m, y_m}) {
      b.Box("frame", {x - 0.5f * post_m, y - 0.5f * post_m, 0},
            {x + 0.5f * post_m, y + 0.5f * post_m, b.height()});
    }
  }
  const int rows = std::max(2, static_cast<int>(std::lround(b.height() / 0.42f)));
  for (int i = 0; i < rows; ++i) {
    const float low = 0.12f + i * (b.height() - 0.16f) / (rows - 1) - (i + 1 == rows ? 0.02f : 0);
    b.Box("boards", {-x_m + 0.5f * post_m, -y_m, low}, {x_m - 0.5f * post_m, y_m, low + kBoardM});
    if (i + 1 == rows) break;
    const float rise_m = (b.height() - 0.16f) / (rows - 1) - kBoardM;
    for (float y = y_m - 0.05f; y > -y_m + 0.3f; y -= 0.36f) {
      if (b.Random(0, 1) > b.Number("fill")) continue;
      const float depth_m = b.Random(0.6f, 0.9f) * b.depth() - 2 * post_m;
      const float width_m = b.Random(0.18f, 0.3f);
      b.Box("boxes", {-0.5f * depth_m, y - width_m, low + kBoardM},
            {0.5f * depth_m, y, low + kBoardM + b.Random(0.4f, 0.8f) * rise_m});
    }
  }
}

// A board on two brackets with books on it.
void BuildWallShelf(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float bracket_m = 0.1f;
  b.Box("body", {0, -side, bracket_m}, {b.depth(), side, bracket_m + kBoardM});
  for (const float y : {-0.7f * side, 0.7f * side}) {
    b.Box("brackets", {0, y - 0.01f, 0}, {0.012f, y + 0.01f, bracket_m});
    b.Box("brackets", {0, y - 0.01f, bracket_m - 0.012f},
          {0.85f * b.depth(), y + 0.01f, bracket_m});
  }
  // One that is as high as asked for, whatever the others are.
  const float top = bracket_m + kBoardM;
  b.BoxWithPicture("paper", "books", {0.02f, side - 0.25f, top},
                   {0.8f * b.depth(), side - 0.05f, b.height()});
  if (b.Number("fill") > 0.5f) {
    FillWithBooks(b, {0.01f, 0.95f * b.depth(), -side + 0.05f, side - 0.28f, top, b.height()});
  }
}

}  // namespace

std::vector<FurnitureKind> ShelfKinds() {
  const Material oak = MakeMaterial("wood", {172, 128, 82}, 0.2f);
  const Material steel = MakeMaterial("metal", {110, 112, 116}, 0.3f);
  const Material books = MakeMaterial("books", {150, 90, 70});
  const Material paper = MakeMaterial("paper", {220, 212, 195});
  return {
      {"bookshelf",
       "bookshelf",
       Mount::kFloor,
       {0.3f, 0.9f, 1.9f},
       {{"body", oak}, {"books", books}, {"paper", paper}},
       {{"fill", {1.0, 0, 1}}},
       BuildBookshelf},
      {"rack",
       "shelves",
       Mount::kFloor,
       {0.45f, 1.0f, 1.8f},
       {{"frame", steel}, {"boards", oak}, {"boxes", MakeMaterial("cardboard", {178, 140, 98})}},
       {{"fill", {0.7, 0, 1}}},
       BuildRack},
      {"wall_shelf",
       "shelves",
       Mount::kWall,
       {0.24f, 1.0f, 0.36f},
       {{"body", oak}, {"brackets", steel}, {"books", books}, {"paper", paper}},
       {{"fill", {1.0, 0, 1}}},
       BuildWallShelf}};
}

}  // namespace semantic_slam
