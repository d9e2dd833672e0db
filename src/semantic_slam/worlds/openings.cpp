#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kCoverM = 0.05f;  // how far a door's casing covers the wall around its opening
constexpr float kJambM = 0.03f;   // thickness of the lining inside
constexpr float kLeafM = 0.04f;

// The lining and the boards around it on both sides of the wall.
void AddDoorFrame(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth();
  const float outer = 0.5f * b.width();
  const float opening = outer - kCoverM;
  const float inner = opening - kJambM;
  const float lintel = b.height() - kCoverM - kJambM;
  for (const float side : {-1.0f, 1.0f}) {
    const auto upright = [&](float rear, float front, float edge, float top) {
      b.Box("frame", {rear, std::min(side * inner, side * edge), 0},
            {front, std::max(side * inner, side * edge), top});
    };
    upright(-x + 0.015f, x - 0.015f, opening, lintel + kJambM);
    upright(-x, -x + 0.015f, outer, b.height());
    upright(x - 0.015f, x, outer, b.height());
  }
  b.Box("frame", {-x + 0.015f, -inner, lintel}, {x - 0.015f, inner, lintel + kJambM});
  for (const float rear : {-x, x - 0.015f}) {
    b.Box("frame", {rear, -inner, lintel}, {rear + 0.015f, inner, b.height()});
  }
}

// A leaf with two raised panels and a handle on each side, opened about its hinges on the left or
// right as seen from the front, to which it opens.
void AddLeaf(FurnitureBuilder& b) {
  const float wide = b.width() - 2 * kCoverM - 2 * kJambM - 0.008f;
  const float high = b.height() - kCoverM - kJambM - 0.004f;
  const float hinge = b.Number("hinge_left") > 0.5f ? -1.0f : 1.0f;  // left as seen is -y
  const float handle_m = std::min(0.05f, 0.5f * (b.depth() - kLeafM) - 0.005f);
  Rigid3d T = Rigid3d(Eigen::Translation3d(0, hinge * 0.5f * wide, 0));
  T.rotate(Eigen::AngleAxisd(hinge * b.Number("open_deg") * kPi / 180, Eigen::Vector3d::UnitZ()));
  const auto add = [&](const char* part, const Eigen::Vector3f& centre,
                       const Eigen::Vector3f& size) {
    const Eigen::Vector3f mirrored(centre.x(), -hinge * centre.y(), centre.z());
    b.Add(part, BoxMesh(mirrored, size), T);
  };
  add("leaf", {0, 0.5f * wide, 0.5f * high + 0.004f}, {kLeafM, wide, high - 0.008f});
  for (const float side : {-1.0f, 1.0f}) {
    const float face = side * (0.5f * kLeafM + 0.003f);
    add("leaf", {face, 0.5f * wide, 0.26f * high}, {0.006f, wide - 0.24f, 0.32f * high});
    add("leaf", {face, 0.5f * wide, 0.71f * high}, {0.006f, wide - 0.24f, 0.42f * high});
    const float lever = side * (0.5f * kLeafM + handle_m - 0.008f);
    add("handle", {0.5f * (lever + side * 0.5f * kLeafM), wide - 0.06f, 1.03f},
        {std::abs(lever - side * 0.5f * kLeafM), 0.02f, 0.02f});
    add("handle", {lever, wide - 0.11f, 1.03f}, {0.016f, 0.12f, 0.022f});
  }
}

void BuildDoor(FurnitureBuilder& b) {
  AddDoorFrame(b);
  if (b.Number("leaf") > 0.5f) AddLeaf(b);
}

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

// Two curtains on a rod, drawn apart by `open`; folds hang straight down.
void BuildCurtain(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float rod = b.height() - 0.03f;
  const float x = b.depth() - 0.05f;
  b.Add("rod", LimbMesh({x, -side + 0.014f, rod}, {x, side - 0.014f, rod}, 0.014f, 0.014f, 8));
  b.Add("rod", EllipsoidMesh({x, 0, rod}, {0.03f, 0.02f, 0.03f}, 8));
  for (const float y : {-side + 0.06f, side - 0.06f}) {
    b.Box("rod", {0, y - 0.01f, rod - 0.01f}, {x, y + 0.01f, rod + 0.01f});
  }
  const float each_m = (side - 0.02f) * (1.0f - 0.75f * b.Number("open"));
  for (const float hand : {-1.0f, 1.0f}) {
    const float from = hand < 0 ? -side + 0.02f : side - 0.02f - each_m;
    const float phase = b.Random(0, 2 * kPi);
    const int folds = std::max(2, static_cast<int>(std::lround(each_m / 0.11f)));
    const auto middle_m = [&](float u, float v) -> Eigen::Vector3f {
      const float deep = 0.032f * std::sin(2 * kPi * folds * u + phase) * (0.55f + 0.45f * v);
      return {x + deep, from + u * each_m, rod + 0.012f - v * (rod + 0.012f)};
    };
    b.Add("curtain", SheetMesh(
                         middle_m, [](float, float) { return 0.004f; }, Eigen::Vector3f::UnitX(),
                         folds * 8, 6));
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
  return {
      {"door",
       "door",
       Mount::kFloor,
       {0.15f, 1.1f, 2.1f},
       {{"frame", white}, {"leaf", MakeMaterial("wood", {178, 134, 88}, 0.2f)}, {"handle", steel}},
       {{"leaf", {1, 0, 1}}, {"open_deg", {0, 0, 95}}, {"hinge_left", {1, 0, 1}}},
       BuildDoor},
      {"window",
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

}  // namespace semantic_slam
