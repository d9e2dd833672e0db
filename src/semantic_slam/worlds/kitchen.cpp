#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kTopM = 0.04f;    // thickness of a worktop
constexpr float kPlinthM = 0.1f;  // the space for feet below
constexpr float kFrontM = 0.02f;  // thickness of doors
constexpr float kHandleM = 0.025f;
const Eigen::Vector2f kBasinM(0.4f, 0.5f);  // hole for a sink: depth, width

void AddWorktop(FurnitureBuilder& b, bool with_hole) {
  const float rear = -0.5f * b.depth();
  const float front = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float low = b.height() - kTopM;
  if (!with_hole) {
    b.Box("top", {rear, -side, low}, {front, side, b.height()});
    return;
  }
  const Eigen::Vector2f half = 0.5f * kBasinM;
  b.Box("top", {rear, -side, low}, {-half.x(), side, b.height()});
  b.Box("top", {half.x(), -side, low}, {front, side, b.height()});
  b.Box("top", {-half.x(), -side, low}, {half.x(), -half.y(), b.height()});
  b.Box("top", {-half.x(), half.y(), low}, {half.x(), side, b.height()});
}

// One cupboard of the row below a worktop: a drawer above a door.
void AddUnitFront(FurnitureBuilder& b, float right_m, float left_m) {
  const float face = 0.5f * b.depth() - kFrontM - kHandleM;
  const float split = b.height() - kTopM - 0.16f;
  const float middle = 0.5f * (right_m + left_m);
  b.Box("fronts", {face, right_m + 0.003f, kPlinthM}, {face + kFrontM, left_m - 0.003f, split});
  b.Box("fronts", {face, right_m + 0.003f, split + 0.005f},
        {face + kFrontM, left_m - 0.003f, b.height() - kTopM - 0.005f});
  for (const float z : {split - 0.05f, split + 0.09f}) {
    b.Box("handles", {face + kFrontM, middle - 0.08f, z},
          {0.5f * b.depth() - 0.005f, middle + 0.08f, z + 0.014f});
  }
}

void BuildCounter(FurnitureBuilder& b) {
  const bool with_hole = b.Number("sink_hole") > 0.5f;
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float face = 0.5f * b.depth() - kFrontM - kHandleM;
  b.Box("fronts", {rear + 0.03f, -side, 0}, {face - 0.05f, side, kPlinthM});
  const float body_top = b.height() - kTopM - (with_hole ? 0.24f : 0.0f);
  b.Box("body", {rear, -side, kPlinthM}, {face, side, body_top});
  if (with_hole) {  // around the basin only walls
    b.Box("body", {face - 0.018f, -side, body_top}, {face, side, b.height() - kTopM});
    b.Box("body", {rear, -side, body_top}, {face - 0.018f, -side + 0.018f, b.height() - kTopM});
    b.Box("body", {rear, side - 0.018f, body_top}, {face - 0.018f, side, b.height() - kTopM});
  }
  AddWorktop(b, with_hole);
  const int units = std::max(1, static_cast<int>(std::lround(b.width() / 0.6f)));
  for (int i = 0; i < units; ++i) {
    AddUnitFront(b, -side + i * b.width() / units, -side + (i + 1) * b.width() / units);
  }
}

// The basin hangs from a rim, for which the frame's origin is too low: it is below the basin.
void BuildSink(FurnitureBuilder& b) {
  const float rim = 0.17f / 0.45f * b.height();
  const float sheet_m = 0.006f;
  const Eigen::Vector2f hole = 0.5f * kBasinM.array() - 0.01f;
  const float x_m = 0.5f * b.depth();
  const float y_m = 0.5f * b.width();
  b.Box("steel", {-hole.x(), -hole.y(), 0}, {hole.x(), hole.y(), sheet_m});
  for (const float side : {-1.0f, 1.0f}) {
    const float x = side * (hole.x() - 0.5f * sheet_m);
    const float y = side * (hole.y() - 0.5f * sheet_m);
    b.Add("steel", BoxMesh({x, 0, 0.5f * rim}, {sheet_m, 2 * hole.y(), rim}));
    b.Add("steel", BoxMesh({0, y, 0.5f * rim}, {2 * hole.x(), sheet_m, rim}));
    b.Add("steel", BoxMesh({side * 0.5f * (x_m + hole.x()), 0, rim + 0.5f * sheet_m},
                           {x_m - hole.x(), 2 * y_m, sheet_m}));
    b.Add("steel", BoxMesh({0, side * 0.5f * (y_m + hole.y()), rim + 0.5f * sheet_m},
                           {2 * hole.x(), y_m - hole.y(), sheet_m}));
  }
  const float tap_x = -x_m + 0.03f;
  const float bend = b.height() - 0.02f;
  b.Add("steel", CylinderMesh({tap_x, 0, rim}, 0.022f, 0.018f, bend - rim, 12));
  b.Add("steel", LimbMesh({tap_x, 0, b.height() - 0.015f}, {tap_x + 0.2f, 0, b.height() - 0.03f},
                          0.015f, 0.012f));
  b.Add("steel", CylinderMesh({tap_x + 0.2f, 0, bend - 0.05f}, 0.012f, 0.012f, 0.04f, 10));
  b.FitToSize();
}

// A stove: an oven with a glass door, knobs above it and plates on top.
void BuildOven(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float front = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float face = front - 0.05f;
  const float hob = b.height() - 0.012f;
  b.Box("body", {rear, -side, 0.04f}, {face, side, hob});
  b.Box("plates", {rear + 0.02f, -side + 0.02f, 0}, {face - 0.04f, side - 0.02f, 0.04f});
  b.Box("plates", {rear, -side, hob}, {face, side, b.height() - 0.006f});
  for (const float x : {-0.13f, 0.12f}) {
    for (const float y : {-0.14f, 0.14f}) {
      b.Add("rings", CylinderMesh({x * b.depth() / 0.6f, y * b.width() / 0.6f, b.height() - 0.006f},
                                  0.085f, 0.085f, 0.006f, 24));
    }
  }
  const float panel = b.height() - 0.14f;
  b.Box("body", {face, -side + 0.004f, 0.22f}, {face + 0.02f, side - 0.004f, panel - 0.01f});
  b.Box("glass", {face + 0.02f, -side + 0.07f, 0.3f}, {face + 0.024f, side - 0.07f, panel - 0.12f});
  b.Box("body", {face, -side + 0.004f, 0.05f}, {face + 0.02f, side - 0.004f, 0.21f});
  b.Box("rings", {front - 0.022f, -side + 0.06f, panel - 0.07f},
        {front, side - 0.06f, panel - 0.05f});
  for (const float y : {-0.8f * side, 0.8f * side - 0.02f}) {
    b.Box("rings", {face + 0.02f, y, panel - 0.07f}, {front - 0.022f, y + 0.02f, panel - 0.05f});
  }
  for (int i = 0; i < 5; ++i) {
    const float y = side * (-0.7f + 0.35f * i);
    b.Box("rings", {face, y - 0.018f, panel + 0.04f}, {face + 0.025f, y + 0.018f, panel + 0.076f});
  }
}

void BuildFridge(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float front = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float face = front - 0.1f;
  const float split = 0.38f * b.height();
  b.Box("body", {rear, -side + 0.004f, 0.03f}, {face, side - 0.004f, b.height()});
  b.Box("handles", {rear + 0.03f, -side + 0.03f, 0}, {face - 0.03f, side - 0.03f, 0.03f});
  b.Add("doors", RoundedBoxMesh({face + 0.03f, 0, 0.5f * (split + 0.03f)},
                                {0.06f, b.width(), split - 0.04f}, 0.012f));
  b.Add("doors", RoundedBoxMesh({face + 0.03f, 0, 0.5f * (split + b.height())},
                                {0.06f, b.width(), b.height() - split - 0.006f}, 0.012f));
  for (const float low : {split - 0.42f, split + 0.08f}) {
    b.Add("handles", LimbMesh({front - 0.014f, side - 0.06f, low},
                              {front - 0.014f, side - 0.06f, low + 0.34f}, 0.014f, 0.014f, 8));
    for (const float z : {low + 0.02f, low + 0.32f}) {
      b.Box("handles", {face + 0.055f, side - 0.07f, z - 0.01f},
            {front - 0.014f, side - 0.05f, z + 0.01f});
    }
  }
  b.BoxWithPicture("handles", "note", {face + 0.06f, -0.1f, 0.72f * b.height()},
                   {face + 0.062f, 0.05f, 0.72f * b.height() + 0.2f});
}

void BuildMicrowave(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float front = 0.5f * b.depth() - 0.02f;
  const float side = 0.5f * b.width();
  b.Box("body", {rear, -side, 0.012f}, {front, side, b.height()});
  for (const float x : {rear + 0.04f, front - 0.04f}) {
    for (const float y : {-side + 0.04f, side - 0.04f}) {
      b.Add("glass", CylinderMesh({x, y, 0}, 0.012f, 0.012f, 0.012f, 8));
    }
  }
  b.Box("glass", {front, -0.55f * side, 0.04f}, {front + 0.005f, side - 0.02f, b.height() - 0.03f});
  b.Box("handles", {front, -0.62f * side, 0.05f},
        {0.5f * b.depth(), -0.58f * side, b.height() - 0.05f});
  for (int i = 0; i < 4; ++i) {
    const float z = 0.05f + 0.045f * i;
    b.Box("handles", {front, -0.95f * side, z}, {front + 0.004f, -0.68f * side, z + 0.028f});
  }
}

}  // namespace

std::vector<FurnitureKind> KitchenKinds() {
  const Material white = MakeMaterial("plastic", {232, 232, 228}, 0.4f);
  const Material steel = MakeMaterial("metal", {175, 178, 182}, 0.6f);
  const Material dark = MakeMaterial("metal", {60, 61, 64}, 0.5f);
  const Material glass = MakeMaterial("glass", {28, 30, 34}, 0.9f);
  return {{"counter",
           "counter",
           Mount::kFloor,
           {0.64f, 1.8f, 0.92f},
           {{"top", MakeMaterial("marble", {205, 200, 192}, 0.5f)},
            {"body", MakeMaterial("wood", {200, 196, 186}, 0.1f)},
            {"fronts", MakeMaterial("wood", {118, 140, 128}, 0.2f)},
            {"handles", steel}},
           {{"sink_hole", {0, 0, 1}}},
           BuildCounter},
          {"sink", "sink", Mount::kFloor, {0.5f, 0.58f, 0.45f}, {{"steel", steel}}, {}, BuildSink},
          {"oven",
           "oven",
           Mount::kFloor,
           {0.64f, 0.6f, 0.92f},
           {{"body", white}, {"glass", glass}, {"plates", glass}, {"rings", dark}},
           {},
           BuildOven},
          {"fridge",
           "fridge",
           Mount::kFloor,
           {0.68f, 0.62f, 1.8f},
           {{"body", white},
            {"doors", MakeMaterial("metal", {205, 208, 212}, 0.4f)},
            {"handles", dark},
            {"note", MakeMaterial("magazine", {230, 225, 200})}},
           {},
           BuildFridge},
          {"microwave",
           "microwave",
           Mount::kFloor,
           {0.38f, 0.5f, 0.29f},
           {{"body", steel}, {"glass", glass}, {"handles", dark}},
           {},
           BuildMicrowave}};
}

}  // namespace semantic_slam
