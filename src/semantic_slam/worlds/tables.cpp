#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

void AddCornerLegs(FurnitureBuilder& b, float leg_m, float inset_m, float height_m) {
  const float x_m = 0.5f * (b.depth() - leg_m) - inset_m;
  const float y_m = 0.5f * (b.width() - leg_m) - inset_m;
  for (const float x : {-x_m, x_m}) {
    for (const float y : {-y_m, y_m}) {
      b.Add("legs", BeamMesh({x, y, 0}, {x, y, height_m}, Eigen::Vector2f::Constant(0.7f * leg_m),
                             Eigen::Vector2f::Constant(leg_m)));
    }
  }
}

// The boards on edge under a top that hold its legs together.
void AddApron(FurnitureBuilder& b, float inset_m, float board_m, float top_m, float drop_m) {
  const float x_m = 0.5f * b.depth() - inset_m;
  const float y_m = 0.5f * b.width() - inset_m;
  for (const float side : {-1.0f, 1.0f}) {
    b.Add("legs", BoxMesh({side * (x_m - 0.5f * board_m), 0, top_m - 0.5f * drop_m},
                          {board_m, 2 * y_m, drop_m}));
    b.Add("legs", BoxMesh({0, side * (y_m - 0.5f * board_m), top_m - 0.5f * drop_m},
                          {2 * x_m - 2 * board_m, board_m, drop_m}));
  }
}

void BuildTable(FurnitureBuilder& b) {
  const float top_m = 0.04f * b.height() + 0.005f;
  const float leg_m = 0.08f * b.height() + 0.01f;
  AddTableTop(b, top_m);
  AddCornerLegs(b, leg_m, 0.03f, b.height() - top_m);
  AddApron(b, 0.04f, 0.02f, b.height() - top_m, 0.11f * b.height());
}

void BuildCoffeeTable(FurnitureBuilder& b) {
  const float top_m = 0.035f;
  AddTableTop(b, top_m);
  AddCornerLegs(b, 0.05f, 0.04f, b.height() - top_m);
}

void BuildRoundTable(FurnitureBuilder& b) {
  const float top_m = 0.03f;
  const float radius_m = 0.5f * std::min(b.depth(), b.width());
  b.Add("top", LatheMesh({0, 0, b.height() - top_m},
                         {{0, 0}, {radius_m - 0.015f, 0}, {radius_m, top_m}, {0, top_m}}, 40));
  const float leg_radius_m = 0.62f * radius_m;
  for (int i = 0; i < 4; ++i) {
    const float angle = kPi / 4 + kPi / 2 * i;
    const Eigen::Vector3f out(std::cos(angle), std::sin(angle), 0);
    b.Add("legs", BeamMesh(1.25f * leg_radius_m * out,
                           leg_radius_m * out + (b.height() - top_m) * Eigen::Vector3f::UnitZ(),
                           {0.03f, 0.03f}, {0.045f, 0.045f}));
  }
  b.FitToSize();
}

// Three drawers under the top at the left of who sits there.
void AddPedestal(FurnitureBuilder& b, float top_m) {
  constexpr float kWidthM = 0.42f;
  constexpr float kFloorM = 0.05f;
  const float front = 0.5f * b.depth() - 0.05f;
  const float left = 0.5f * b.width() - 0.06f;
  const float rear = front - std::min(0.5f, b.depth() - 0.1f);
  b.Box("legs", {rear, left - kWidthM, kFloorM}, {front - 0.018f, left, top_m});
  const float each_m = (top_m - kFloorM) / 3;
  for (int i = 0; i < 3; ++i) {
    const float low = kFloorM + i * each_m;
    b.Box("top", {front - 0.018f, left - kWidthM + 0.003f, low + 0.003f},
          {front, left - 0.003f, low + each_m - 0.003f});
    b.Box("handles", {front, left - 0.5f * kWidthM - 0.06f, low + 0.7f * each_m},
          {front + 0.02f, left - 0.5f * kWidthM + 0.06f, low + 0.7f * each_m + 0.012f});
  }
  for (const float x : {rear + 0.03f, front - 0.05f}) {
    for (const float y : {left - 0.03f, left - kWidthM + 0.03f}) {
      b.Add("handles", CylinderMesh({x, y, 0}, 0.02f, 0.02f, kFloorM, 10));
    }
  }
}

// Its front, where one sits, is open; a board closes its back.
void BuildDesk(FurnitureBuilder& b) {
  const float top_m = 0.028f;
  const float under_m = b.height() - top_m;
  AddTableTop(b, top_m);
  AddCornerLegs(b, 0.05f, 0.02f, under_m);
  b.Box("legs", {-0.5f * b.depth() + 0.04f, -0.5f * b.width() + 0.07f, under_m - 0.3f},
        {-0.5f * b.depth() + 0.058f, 0.5f * b.width() - 0.07f, under_m});
  if (b.Number("drawers") > 0.5f) AddPedestal(b, under_m);
}

// A long top with rounded ends on two pedestals.
void BuildConferenceTable(FurnitureBuilder& b) {
  const float top_m = 0.04f;
  const float under_m = b.height() - top_m;
  b.Add("top",
        SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.3f * b.depth()), under_m, b.height()));
  for (const float side : {-1.0f, 1.0f}) {
    const float y = side * 0.3f * b.width();
    b.Add("legs", BeamMesh({0, y, 0.05f}, {0, y, under_m}, {0.5f * b.depth(), 0.07f},
                           {0.4f * b.depth(), 0.07f}));
    b.Add("legs",
          BeamMesh({0, y, 0}, {0, y, 0.05f}, {0.7f * b.depth(), 0.12f}, {0.68f * b.depth(), 0.1f}));
  }
}

FurnitureKind TableOf(const std::string& name, const std::string& label,
                      const Eigen::Vector3f& size_m, const Material& top, const Material& legs,
                      void (*build)(FurnitureBuilder&)) {
  return {name, label, Mount::kFloor, size_m, {{"top", top}, {"legs", legs}}, {}, build};
}

}  // namespace

std::vector<FurnitureKind> TableKinds() {
  const Material oak = MakeMaterial("wood", {176, 130, 80}, 0.25f);
  const Material walnut = MakeMaterial("wood", {112, 74, 46}, 0.3f);
  const Material steel = MakeMaterial("metal", {70, 72, 76}, 0.4f);
  FurnitureKind desk = TableOf("desk", "desk", {0.75f, 1.5f, 0.74f}, oak,
                               MakeMaterial("metal", {200, 202, 205}, 0.3f), BuildDesk);
  desk.materials.emplace("handles", steel);
  desk.numbers.emplace("drawers", NumberRange{0, 0, 1});
  return {TableOf("table", "table", {0.9f, 1.6f, 0.75f}, oak, oak, BuildTable),
          TableOf("round_table", "table", {1.0f, 1.0f, 0.74f}, walnut, walnut, BuildRoundTable),
          TableOf("coffee_table", "coffee_table", {0.6f, 1.1f, 0.42f}, walnut, walnut,
                  BuildCoffeeTable),
          TableOf("side_table", "table", {0.45f, 0.45f, 0.55f}, oak, steel, BuildCoffeeTable),
          TableOf("conference_table", "conference_table", {1.2f, 3.2f, 0.74f}, walnut, steel,
                  BuildConferenceTable),
          desk};
}

}  // namespace semantic_slam
