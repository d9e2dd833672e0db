#include <algorithm>
#include <utility>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// A thick plank, each of its legs two rods that meet on the floor.
void BuildHairpinDesk(FurnitureBuilder& b) {
  const float top_m = 0.038f;
  const float under_m = b.height() - top_m;
  const float x_m = 0.42f * b.depth(), y_m = 0.43f * b.width();
  AddTableTop(b, top_m);
  for (const float x : {-x_m, x_m}) {
    for (const float y : {-y_m, y_m}) {
      const Eigen::Vector3f foot(x, y, 0.008f);
      const float inwards_x = x > 0 ? -0.1f : 0.1f, inwards_y = y > 0 ? -0.1f : 0.1f;
      for (const auto& [dx, dy] : {std::pair(inwards_x, 0.0f), {0.0f, inwards_y}}) {
        AddTube(b, "legs", {{x + dx, y + dy, under_m}, foot}, 0.007f);
      }
      b.Box("legs", {std::min(x, x + inwards_x), std::min(y, y + inwards_y), under_m - 0.004f},
            {std::max(x, x + inwards_x), std::max(y, y + inwards_y), under_m});
    }
  }
  b.FitToSize();
}

// The pigeon holes of a secretary, above its top.
void AddPigeonHoles(FurnitureBuilder& b, float low_m, float deep_m) {
  constexpr float kBoardM = 0.014f;
  constexpr int kColumns = 4;
  const float rear = -0.5f * b.depth(), y = 0.48f * b.width();
  const float middle_m = 0.5f * (low_m + b.height());
  b.Box("legs", {rear, -y, low_m}, {rear + 0.01f, y, b.height() - kBoardM});
  b.Box("top", {rear, -y - 0.01f, b.height() - kBoardM}, {rear + deep_m, y + 0.01f, b.height()});
  const float each_m = (2 * y - kBoardM) / kColumns;
  for (int i = 0; i <= kColumns; ++i) {
    const float right = -y + i * each_m;
    b.Box("top", {rear + 0.01f, right, low_m},
          {rear + deep_m - 0.005f, right + kBoardM, b.height() - kBoardM});
    if (i == kColumns || i == 1) continue;
    b.Box("top", {rear + 0.01f, right + kBoardM, middle_m},
          {rear + deep_m - 0.01f, right + each_m, middle_m + kBoardM});
  }
}

// A secretary: on slender legs, one broad drawer, and pigeon holes at the rear of its top.
void BuildSecretary(FurnitureBuilder& b) {
  constexpr float kDeepM = 0.24f;
  const float top_m = 0.022f;
  const float high = 0.75f * b.height();  // of the top
  const float drawer = high - top_m - 0.1f;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  b.Box("top", {-x, -y, high - top_m}, {x, y, high});
  b.Box("legs", {-x + 0.02f, -y + 0.02f, drawer}, {x - 0.04f, y - 0.02f, high - top_m});
  b.Box("top", {x - 0.04f, -y + 0.06f, drawer + 0.006f}, {x - 0.02f, y - 0.06f, high - top_m});
  for (const float at : {-0.5f * y, 0.5f * y}) {
    b.Add("handles", EllipsoidMesh({x - 0.01f, at, drawer + 0.05f}, {0.014f, 0.016f, 0.016f}, 10));
  }
  for (const float rear : {-x + 0.045f, x - 0.06f}) {
    for (const float side : {-y + 0.045f, y - 0.045f}) {
      b.Add("legs",
            BeamMesh({rear, side, 0}, {rear, side, drawer}, {0.022f, 0.022f}, {0.045f, 0.045f}));
    }
  }
  AddPigeonHoles(b, high, kDeepM);
  b.FitToSize();
}

// Of an open-plan office: closed frames for legs, a tray for cables, and a screen of cloth (in the
// colour of the fronts) at the rear that reaches above the top.
void BuildScreenedDesk(FurnitureBuilder& b) {
  constexpr float kBarM = 0.045f;
  const float top_m = 0.024f;
  const float high = 0.64f * b.height();
  const float under_m = high - top_m;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  b.Box("top", {-x + 0.045f, -y, under_m}, {x, y, high});
  for (const float right : {-y + 0.03f, y - 0.03f - kBarM}) {
    for (const float low : {0.0f, under_m - kBarM}) {
      b.Box("legs", {-x + 0.06f, right, low}, {x - 0.04f, right + kBarM, low + kBarM});
    }
    for (const float rear : {-x + 0.06f, x - 0.04f - kBarM}) {
      b.Box("legs", {rear, right, kBarM}, {rear + kBarM, right + kBarM, under_m - kBarM});
    }
  }
  b.Box("legs", {-x + 0.12f, -0.8f * y, under_m - 0.14f}, {-x + 0.24f, 0.8f * y, under_m - 0.12f});
  b.Box("legs", {-x + 0.12f, -0.8f * y, under_m - 0.12f}, {-x + 0.125f, 0.8f * y, under_m});
  AddPadding(b, "handles", {-x, -y, under_m - 0.12f}, {-x + 0.035f, y, b.height()}, 0.012f);
}

// One of its ends is a bookcase, open to the side; the other a frame.
void BuildBookcaseDesk(FurnitureBuilder& b) {
  constexpr float kBoardM = 0.022f;
  constexpr float kWideM = 0.3f;
  const float top_m = 0.03f;
  const float under_m = b.height() - top_m;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  AddTableTop(b, top_m);
  for (const float rear : {-x + 0.01f, x - 0.02f - kBoardM}) {
    b.Box("top", {rear, y - kWideM, 0.02f}, {rear + kBoardM, y - 0.01f, under_m});
  }
  for (const float low : {0.02f, 0.5f * under_m}) {
    b.Box("top", {-x + 0.01f + kBoardM, y - kWideM, low},
          {x - 0.02f - kBoardM, y - 0.01f, low + kBoardM});
  }
  b.Box("legs", {-x + 0.01f + kBoardM, y - kWideM, 0.02f + kBoardM},
        {x - 0.02f - kBoardM, y - kWideM + 0.012f, 0.5f * under_m});
  b.Box("legs", {-x + 0.02f, y - kWideM + 0.01f, 0}, {x - 0.03f, y - 0.02f, 0.02f});
  for (const float rear : {-x + 0.02f, x - 0.06f}) {
    b.Box("handles", {rear, -y + 0.02f, 0}, {rear + 0.035f, -y + 0.055f, under_m});
  }
  for (const float low : {0.0f, under_m - 0.035f}) {
    b.Box("handles", {-x + 0.055f, -y + 0.02f, low}, {x - 0.06f, -y + 0.055f, low + 0.035f});
  }
}

}  // namespace

DesignTable WorkstationDesigns() {
  return {{"desk",
           {{BuildHairpinDesk, {0.7f, 1.4f, 0.74f}},
            {BuildSecretary, {0.6f, 1.05f, 1.0f}},
            {BuildScreenedDesk, {0.84f, 1.6f, 1.16f}},
            {BuildBookcaseDesk, {0.65f, 1.35f, 0.75f}}}}};
}

}  // namespace semantic_slam
