#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

// What can be seen through it is a picture, on the front; a bar in the middle and a sill.
void BuildWindow(FurnitureBuilder& b) {
  const float bar_m = 0.06f;
  const float x = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float sill_m = 0.03f;
  b.Box("frame", {-0.6f * x, -side, 0}, {x, side, sill_m});
  const float low = sill_m;
  b.Box("frame", {-x, -side, low}, {0.2f * x, side, low + bar_m});
  b.Box("frame", {-x, -side, b.height() - bar_m}, {0.2f * x, side, b.height()});
  for (const float y : {-side, side - bar_m}) {
    b.Box("frame", {-x, y, low + bar_m}, {0.2f * x, y + bar_m, b.height() - bar_m});
  }
  const int panes = std::max(1, static_cast<int>(std::lround(b.width() / 0.8f)));
  for (int i = 1; i < panes; ++i) {
    const float y = -side + i * b.width() / panes;
    b.Box("frame", {-0.5f * x, y - 0.5f * bar_m, low + bar_m},
          {0.1f * x, y + 0.5f * bar_m, b.height() - bar_m});
  }
  b.BoxWithPicture("frame", "view", {-0.4f * x, -side + bar_m, low + bar_m},
                   {-0.3f * x, side - bar_m, b.height() - bar_m});
}

// A view behind `columns` x `rows` panes, in a frame of bars without a sill.
void AddPanedWindow(FurnitureBuilder& b, int columns, int rows, float frame_m, float muntin_m) {
  const float x = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  b.Box("frame", {-x, -side, 0}, {x, side, frame_m});
  b.Box("frame", {-x, -side, b.height() - frame_m}, {x, side, b.height()});
  for (const float y : {-side, side - frame_m}) {
    b.Box("frame", {-x, y, frame_m}, {x, y + frame_m, b.height() - frame_m});
  }
  for (int i = 1; i < columns; ++i) {
    const float y = -side + i * b.width() / columns;
    b.Box("frame", {-0.4f * x, y - 0.5f * muntin_m, frame_m},
          {0.2f * x, y + 0.5f * muntin_m, b.height() - frame_m});
  }
  for (int i = 1; i < rows; ++i) {
    const float z = i * b.height() / rows;
    b.Box("frame", {-0.4f * x, -side + frame_m, z - 0.5f * muntin_m},
          {0.15f * x, side - frame_m, z + 0.5f * muntin_m});
  }
  b.BoxWithPicture("frame", "view", {-0.5f * x, -side + frame_m, frame_m},
                   {-0.3f * x, side - frame_m, b.height() - frame_m});
}

// Many small panes, as in old houses.
void BuildMuntinWindow(FurnitureBuilder& b) {
  AddPanedWindow(b, std::max(2, static_cast<int>(std::lround(b.width() / 0.4f))),
                 std::max(2, static_cast<int>(std::lround(b.height() / 0.42f))), 0.07f, 0.025f);
}

// One large pane in a slender frame.
void BuildPictureWindow(FurnitureBuilder& b) {
  AddPanedWindow(b, 1, 1, 0.035f, 0.0f);
}

// The height of the rod, which sticks out at the ends, on two brackets.
float AddRod(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float rod = b.height() - 0.03f;
  const float x = b.depth() - 0.05f;
  b.Add("rod", LimbMesh({x, -side + 0.014f, rod}, {x, side - 0.014f, rod}, 0.014f, 0.014f, 8));
  b.Add("rod", EllipsoidMesh({x, 0, rod}, {0.03f, 0.02f, 0.03f}, 8));
  for (const float y : {-side + 0.06f, side - 0.06f}) {
    b.Box("rod", {0, y - 0.01f, rod - 0.01f}, {x, y + 0.01f, rod + 0.01f});
  }
  return rod;
}

// A curtain that covers `wide_m` from `from_m` (y) on; folds hang straight down.
void AddFolds(FurnitureBuilder& b, float rod_m, float from_m, float wide_m) {
  const float x = b.depth() - 0.05f;
  const float phase = b.Random(0, 2 * kPi);
  const int folds = std::max(2, static_cast<int>(std::lround(wide_m / 0.11f)));
  const auto middle_m = [&](float u, float v) -> Eigen::Vector3f {
    const float deep = 0.032f * std::sin(2 * kPi * folds * u + phase) * (0.55f + 0.45f * v);
    return {x + deep, from_m + u * wide_m, rod_m + 0.012f - v * (rod_m + 0.012f)};
  };
  b.Add("curtain",
        SheetMesh(
            middle_m, [](float, float) { return 0.004f; }, Eigen::Vector3f::UnitX(), folds * 8, 6));
}

// Two curtains on a rod, drawn apart by `open`.
void BuildCurtain(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float rod_m = AddRod(b);
  const float each_m = (side - 0.02f) * (1.0f - 0.75f * b.Number("open"));
  for (const float hand : {-1.0f, 1.0f}) {
    AddFolds(b, rod_m, hand < 0 ? -side + 0.02f : side - 0.02f - each_m, each_m);
  }
  b.FitToSize();
}

// A single one, drawn to its left.
void BuildOneCurtain(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float rod_m = AddRod(b);
  const float wide_m = (b.width() - 0.04f) * (1.0f - 0.75f * b.Number("open"));
  AddFolds(b, rod_m, side - 0.02f - wide_m, wide_m);
  b.FitToSize();
}

// Cloth that is drawn up by cords: smooth below, in broad pleats above, as far as it is open.
void BuildRomanShade(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float rail_m = 0.05f;
  const int pleats = 2 + static_cast<int>(std::lround(4 * b.Number("open")));
  const float pleated_m = 0.09f * pleats;
  b.Box("rod", {0, -side, b.height() - rail_m}, {0.5f * b.depth(), side, b.height()});
  const float top = b.height() - rail_m;
  const float low = std::max(top - pleated_m, 0.1f);
  b.Box("curtain", {0.02f, -side + 0.01f, 0}, {0.028f, side - 0.01f, low});
  for (int i = 0; i < pleats; ++i) {
    const float z = low + (top - low) * (static_cast<float>(i) + 0.5f) / static_cast<float>(pleats);
    const float radius_m = 0.5f * (top - low) / static_cast<float>(pleats);
    b.Add("curtain",
          RoundedBoxMesh({0.5f * b.depth(), 0, z}, {b.depth(), b.width() - 0.02f, 2.2f * radius_m},
                         0.45f * std::min(b.depth(), 2 * radius_m)));
  }
  b.FitToSize();
}

void BuildBlinds(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float case_m = 0.05f;
  const float pitch_m = 0.045f;
  b.Box("slats", {0, -side, b.height() - case_m}, {b.depth(), side, b.height()});
  const float x = 0.5f * b.depth();
  const float reach = 0.4f * b.depth();
  b.Box("slats", {x - 0.01f, -side + 0.01f, 0}, {x + 0.01f, side - 0.01f, 0.02f});
  for (float z = 0.05f; z < b.height() - case_m - 0.02f; z += pitch_m) {
    Rigid3d T = Rigid3d(Eigen::Translation3d(x, 0, z));
    T.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY()));
    b.Add("slats", BoxMesh({0, 0, 0}, {2 * reach, b.width() - 0.02f, 0.002f}), T);
  }
  for (const float y : {-0.7f * side, 0.7f * side}) {
    b.Box("cords", {x - 0.001f, y - 0.002f, 0.02f}, {x + 0.001f, y + 0.002f, b.height() - case_m});
  }
}

}  // namespace

std::vector<FurnitureKind> OpeningKinds() {
  const Material white = MakeMaterial("wood", {228, 226, 220}, 0.2f);
  const Material steel = MakeMaterial("metal", {150, 150, 150}, 0.5f);
  return {{"window",
           "window",
           Mount::kFloor,
           {0.14f, 1.4f, 1.3f},
           {{"frame", white}, {"view", MakeMaterial("window_view", {150, 190, 225}, 0.4f, 0.8f)}},
           {},
           BuildWindow},
          {"curtain",
           "curtain",
           Mount::kWall,
           {0.13f, 2.0f, 2.2f},
           {{"rod", steel}, {"curtain", MakeMaterial("curtain", {170, 150, 120})}},
           {{"open", {0.6, 0, 1}}},
           BuildCurtain},
          {"blinds",
           "blinds",
           Mount::kWall,
           {0.06f, 1.4f, 1.3f},
           {{"slats", MakeMaterial("plastic", {222, 218, 206}, 0.2f)},
            {"cords", MakeMaterial("cloth", {200, 200, 195})}},
           {},
           BuildBlinds}};
}

DesignTable OpeningDesigns() {
  return {{"window",
           {{BuildMuntinWindow, {0.14f, 1.4f, 1.3f}}, {BuildPictureWindow, {0.14f, 1.6f, 1.4f}}}},
          {"curtain",
           {{BuildOneCurtain, {0.13f, 1.4f, 2.3f}}, {BuildRomanShade, {0.08f, 1.2f, 1.5f}}}}};
}

}  // namespace semantic_slam
