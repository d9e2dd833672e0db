#include "semantic_slam/worlds/cabinet_parts.h"

#include <algorithm>

#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {

float FaceOf(const FurnitureBuilder& b) {
  return 0.5f * b.depth() - kFrontM - kHandleM;
}

void AddFront(FurnitureBuilder& b, const FrontArea& area) {
  const float face = FaceOf(b);
  b.Box("fronts", {face, area.right_m + kGapM, area.low_m + kGapM},
        {face + kFrontM, area.left_m - kGapM, area.high_m - kGapM});
}

void AddHandle(FurnitureBuilder& b, float y_m, float z_m, float width_m, float height_m) {
  const float x = 0.5f * b.depth();
  b.Box("handles", {x - kHandleM, y_m - 0.5f * width_m, z_m - 0.5f * height_m},
        {x, y_m + 0.5f * width_m, z_m + 0.5f * height_m});
}

void AddDrawers(FurnitureBuilder& b, const FrontArea& area, int rows) {
  const float each_m = (area.high_m - area.low_m) / rows;
  for (int i = 0; i < rows; ++i) {
    const float low = area.low_m + i * each_m;
    AddFront(b, {low, low + each_m, area.right_m, area.left_m});
    AddHandle(b, 0.5f * (area.left_m + area.right_m), low + 0.6f * each_m,
              std::min(0.16f, 0.4f * (area.left_m - area.right_m)), 0.014f);
  }
}

void AddDoors(FurnitureBuilder& b, const FrontArea& area, int doors) {
  const float each_m = (area.left_m - area.right_m) / doors;
  for (int i = 0; i < doors; ++i) {
    const float right = area.right_m + i * each_m;
    AddFront(b, {area.low_m, area.high_m, right, right + each_m});
    const float handle = i % 2 == 0 ? right + each_m - 0.05f : right + 0.05f;
    AddHandle(b, handle, area.low_m + 0.55f * (area.high_m - area.low_m), 0.014f,
              std::min(0.16f, 0.3f * (area.high_m - area.low_m)));
  }
}

FrontArea WholeFront(const FurnitureBuilder& b, float low_m, float high_m) {
  return {low_m, high_m, -0.5f * b.width(), 0.5f * b.width()};
}

void AddCarcass(FurnitureBuilder& b, float low_m, float high_m) {
  b.Box("body", {-0.5f * b.depth(), -0.5f * b.width(), low_m},
        {FaceOf(b), 0.5f * b.width(), high_m});
}

void AddFeet(FurnitureBuilder& b, float height_m) {
  const float x_m = 0.5f * b.depth() - 0.07f;
  const float y_m = 0.5f * b.width() - 0.04f;
  for (const float x : {-x_m, x_m - kHandleM}) {
    for (const float y : {-y_m, y_m}) {
      b.Add("body", BeamMesh({x, y, 0}, {x, y, height_m}, {0.028f, 0.028f}, {0.04f, 0.04f}));
    }
  }
}

void AddTopBoard(FurnitureBuilder& b, float thickness_m) {
  b.Box("top", {-0.5f * b.depth(), -0.5f * b.width(), b.height() - thickness_m},
        {0.5f * b.depth() - 0.5f * kHandleM, 0.5f * b.width(), b.height()});
}

}  // namespace semantic_slam
