#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

// Two trestles, each like an A, and a beam between them.
void BuildTrestleTable(FurnitureBuilder& b) {
  const float top_m = 0.035f;
  const float under_m = b.height() - top_m;
  const float spread_m = 0.4f * b.depth();
  AddTableTop(b, top_m);
  for (const float side : {-1.0f, 1.0f}) {
    const float y = side * 0.36f * b.width();
    for (const float x : {-spread_m, spread_m}) {
      b.Add("legs",
            BeamMesh({x, y, 0}, {0.3f * x, y, under_m - 0.05f}, {0.05f, 0.06f}, {0.05f, 0.06f}));
    }
    b.Box("legs", {-spread_m, y - 0.04f, under_m - 0.05f}, {spread_m, y + 0.04f, under_m});
    b.Box("legs", {-0.72f * spread_m, y - 0.02f, 0.36f * under_m},
          {0.72f * spread_m, y + 0.02f, 0.36f * under_m + 0.05f});
  }
  b.Box("legs", {-0.02f, -0.36f * b.width(), 0.36f * under_m},
        {0.02f, 0.36f * b.width(), 0.36f * under_m + 0.08f});
}

// Legs that cross like an X at both ends.
void BuildCrossLegs(FurnitureBuilder& b) {
  const float top_m = 0.05f;
  const float under_m = b.height() - top_m;
  const float x_m = 0.42f * b.depth();
  const Eigen::Vector2f bar(0.09f, 0.07f);
  AddTableTop(b, top_m);
  for (const float side : {-1.0f, 1.0f}) {
    const float y = side * 0.34f * b.width();
    b.Add("legs", BeamMesh({-x_m, y, 0}, {x_m, y, under_m}, bar, bar));
    b.Add("legs", BeamMesh({x_m, y, 0}, {-x_m, y, under_m}, bar, 0.98f * bar));
  }
  b.Box("legs", {-0.035f, -0.34f * b.width(), 0.5f * under_m - 0.03f},
        {0.035f, 0.34f * b.width(), 0.5f * under_m + 0.03f});
}

// Its ends are boards down to the floor, as wide as the top.
void BuildPanelTable(FurnitureBuilder& b) {
  const float board_m = 0.05f;
  const float under_m = b.height() - board_m;
  const float y_m = 0.5f * b.width() - board_m;
  AddTableTop(b, board_m);
  for (const float y : {-0.5f * b.width(), y_m}) {
    b.Box("legs", {-0.48f * b.depth(), y, 0}, {0.48f * b.depth(), y + board_m, under_m});
  }
  b.Box("legs", {-0.02f, -y_m, under_m - 0.12f}, {0.02f, y_m, under_m});
}

// A thin top on two closed frames of square tube.
void BuildFrameTable(FurnitureBuilder& b) {
  const float top_m = 0.025f;
  const float bar_m = 0.05f;
  const float under_m = b.height() - top_m;
  const float x_m = 0.46f * b.depth();
  AddTableTop(b, top_m);
  for (const float side : {-1.0f, 1.0f}) {
    const float y = side * 0.4f * b.width();
    const float right = y - 0.5f * bar_m, left = y + 0.5f * bar_m;
    b.Box("legs", {-x_m, right, 0}, {x_m, left, bar_m});
    b.Box("legs", {-x_m, right, under_m - bar_m}, {x_m, left, under_m});
    for (const float x : {-x_m, x_m - bar_m}) {
      b.Box("legs", {x, right, bar_m}, {x + bar_m, left, under_m - bar_m});
    }
  }
  b.Box("legs", {-0.02f, -0.4f * b.width() + 0.5f * bar_m, under_m - 0.04f},
        {0.02f, 0.4f * b.width() - 0.5f * bar_m, under_m});
}

// A rounded top on round legs that lean outwards.
void BuildSplayedTable(FurnitureBuilder& b) {
  const float top_m = 0.028f;
  const float radius_m = 0.02f + 0.008f * b.height();
  const float under_m = b.height() - top_m;
  b.Add("top",
        SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.22f * b.depth()), under_m, b.height()));
  AddSplayedLegs(b, "legs", {0.96f * b.depth(), 0.96f * b.width()},
                 {0.62f * b.depth(), 0.72f * b.width()}, under_m - radius_m, radius_m);
  b.FitToSize();
}

// A stem that widens to a disc on the floor and to another below the top.
Mesh TulipMesh(float foot_radius_m, float height_m) {
  return LatheMesh({0, 0, 0},
                   {{0, 0},
                    {foot_radius_m, 0},
                    {foot_radius_m, 0.012f},
                    {0.6f * foot_radius_m, 0.04f * height_m + 0.012f},
                    {0.22f * foot_radius_m, 0.2f * height_m},
                    {0.16f * foot_radius_m, 0.5f * height_m},
                    {0.24f * foot_radius_m, 0.85f * height_m},
                    {0.55f * foot_radius_m, height_m},
                    {0, height_m}},
                   32);
}

// A round or oval top on one stem.
void BuildTulipTable(FurnitureBuilder& b) {
  const float top_m = 0.022f;
  const float under_m = b.height() - top_m;
  b.Add("top", SlabMesh(EllipseOutline({b.depth(), b.width()}), under_m, b.height()));
  b.Add("legs", TulipMesh(0.28f * std::min(b.depth(), b.width()), under_m));
  b.FitToSize();
}

// A round or oval top on a turned column with four curved feet.
void BuildClawFootTable(FurnitureBuilder& b) {
  const float top_m = 0.03f;
  const float under_m = b.height() - top_m;
  const float radius_m = 0.5f * std::min(b.depth(), b.width());
  b.Add("top", SlabMesh(EllipseOutline({b.depth(), b.width()}), under_m, b.height()));
  b.Add("legs", LatheMesh({0, 0, 0.2f * under_m},
                          {{0, 0},
                           {0.05f, 0},
                           {0.06f, 0.1f * under_m},
                           {0.035f, 0.25f * under_m},
                           {0.055f, 0.45f * under_m},
                           {0.035f, 0.6f * under_m},
                           {0.4f * radius_m, 0.8f * under_m},
                           {0, 0.8f * under_m}},
                          20));
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3f out = Turned(kPi / 4 + kPi / 2 * i).linear().col(0).cast<float>();
    const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
    AddTube(b, "legs",
            {0.03f * out + 0.38f * under_m * up, 0.35f * radius_m * out + 0.26f * under_m * up,
             0.68f * radius_m * out + 0.022f * up},
            0.022f);
  }
  b.FitToSize();
}

// Three legs of wire that bend back on themselves below a round top.
void BuildHairpinTable(FurnitureBuilder& b) {
  const float top_m = 0.03f;
  const float under_m = b.height() - top_m;
  b.Add("top", SlabMesh(EllipseOutline({b.depth(), b.width()}), under_m, b.height()));
  for (int i = 0; i < 3; ++i) {
    const float angle = 2 * kPi * i / 3;
    const auto place = [&](float turn, float share, float z) {
      return Eigen::Vector3f(share * 0.5f * b.depth() * std::cos(angle + turn),
                             share * 0.5f * b.width() * std::sin(angle + turn), z);
    };
    AddTube(b, "legs",
            {place(-0.22f, 0.62f, under_m), place(0, 0.86f, 0.008f), place(0.22f, 0.62f, under_m)},
            0.008f);
  }
  b.FitToSize();
}

// A frame around an upper and a lower board.
void BuildShelfTable(FurnitureBuilder& b) {
  const float bar_m = 0.03f;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  b.Box("top", {-x, -y, b.height() - 0.02f}, {x, y, b.height()});
  b.Box("top", {-x + bar_m, -y + bar_m, 0.25f * b.height()},
        {x - bar_m, y - bar_m, 0.25f * b.height() + 0.018f});
  for (const float front : {-x, x - bar_m}) {
    for (const float left : {-y, y - bar_m}) {
      b.Box("legs", {front, left, 0}, {front + bar_m, left + bar_m, b.height() - 0.02f});
    }
    b.Box("legs", {front, -y + bar_m, 0.25f * b.height()},
          {front + bar_m, y - bar_m, 0.25f * b.height() + bar_m});
  }
}

// A drum of staves with gaps below a round top.
void BuildDrumTable(FurnitureBuilder& b) {
  constexpr int kStaves = 20;
  const float under_m = b.height() - 0.03f;
  b.Add("top", SlabMesh(EllipseOutline({b.depth(), b.width()}), under_m, b.height()));
  const Eigen::Vector2f ring_m(0.42f * b.depth(), 0.42f * b.width());
  for (int i = 0; i < kStaves; ++i) {
    const float angle = 2 * kPi * i / kStaves;
    const float x = ring_m.x() * std::cos(angle), y = ring_m.y() * std::sin(angle);
    b.Add("legs",
          BeamMesh({x, y, 0}, {0.8f * x, 0.8f * y, under_m}, {0.02f, 0.02f}, {0.02f, 0.02f}));
  }
  b.FitToSize();
}

// Its foot lies below a seat, its top above it: an upright at the rear alone.
void BuildCTable(FurnitureBuilder& b) {
  const float bar_m = 0.025f;
  const float x = 0.5f * b.depth(), y = 0.44f * b.width();
  AddTableTop(b, 0.022f);
  for (const float left : {-y, y - bar_m}) {
    b.Box("legs", {-x, left, 0}, {x, left + bar_m, bar_m});
    b.Box("legs", {-x, left, bar_m}, {-x + bar_m, left + bar_m, b.height() - 0.022f});
  }
  b.Box("legs", {-x, -y + bar_m, 0}, {-x + bar_m, y - bar_m, bar_m});
}

}  // namespace

DesignTable TableDesigns() {
  return {{"table",
           {{BuildTrestleTable, {0.9f, 1.9f, 0.75f}},
            {BuildTulipTable, {1.05f, 1.7f, 0.73f}},
            {BuildFrameTable, {0.8f, 1.5f, 0.74f}},
            {BuildSplayedTable, {0.85f, 1.5f, 0.74f}},
            {BuildCrossLegs, {0.95f, 1.9f, 0.76f}},
            {BuildPanelTable, {0.9f, 1.8f, 0.75f}}}},
          {"round_table",
           {{BuildTulipTable, {1.1f, 1.1f, 0.73f}},
            {BuildClawFootTable, {1.15f, 1.15f, 0.75f}},
            {BuildDrumTable, {1.2f, 1.2f, 0.74f}}}},
          {"coffee_table",
           {{BuildHairpinTable, {0.75f, 0.75f, 0.38f}},
            {BuildShelfTable, {0.6f, 1.1f, 0.42f}},
            {BuildSplayedTable, {0.55f, 1.15f, 0.42f}},
            {BuildDrumTable, {0.8f, 0.8f, 0.36f}},
            {BuildPanelTable, {0.6f, 1.0f, 0.36f}}}},
          {"side_table",
           {{BuildTulipTable, {0.5f, 0.5f, 0.52f}},
            {BuildShelfTable, {0.4f, 0.4f, 0.52f}},
            {BuildCTable, {0.34f, 0.46f, 0.62f}}}}};
}

}  // namespace semantic_slam
