#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// A box with drawers between two places (y), from `floor_m` up to `top_m`.
void AddDrawerBox(FurnitureBuilder& b, float right_m, float left_m, float floor_m, float top_m) {
  constexpr float kFrontM = 0.018f;
  constexpr int kRows = 3;
  const float rear = -0.5f * b.depth() + 0.02f;
  const float front = 0.5f * b.depth() - 0.04f;
  b.Box("legs", {rear, right_m, floor_m}, {front - kFrontM, left_m, top_m});
  const float each_m = (top_m - floor_m) / kRows;
  const float middle = 0.5f * (right_m + left_m);
  for (int i = 0; i < kRows; ++i) {
    const float low = floor_m + i * each_m;
    b.Box("top", {front - kFrontM, right_m + 0.003f, low + 0.003f},
          {front, left_m - 0.003f, low + each_m - 0.003f});
    b.Box("handles", {front, middle - 0.06f, low + 0.5f * each_m},
          {front + 0.02f, middle + 0.06f, low + 0.5f * each_m + 0.014f});
  }
}

// Boards for sides and back.
void BuildPanelDesk(FurnitureBuilder& b) {
  const float board_m = 0.025f;
  const float under_m = b.height() - board_m;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  AddTableTop(b, board_m);
  for (const float right : {-y, y - board_m}) {
    b.Box("legs", {-x, right, 0}, {x - 0.02f, right + board_m, under_m});
  }
  b.Box("legs", {-x, -y + board_m, 0.15f}, {-x + 0.02f, y - board_m, under_m});
}

// A board on two trestles.
void BuildTrestleDesk(FurnitureBuilder& b) {
  const float top_m = 0.025f;
  const float under_m = b.height() - top_m;
  const float x_m = 0.44f * b.depth();
  const Eigen::Vector2f bar(0.035f, 0.035f);
  AddTableTop(b, top_m);
  for (const float side : {-1.0f, 1.0f}) {
    const float y = side * 0.34f * b.width();
    for (const float x : {-x_m, x_m}) {
      for (const float spread_m : {-0.17f, 0.17f}) {
        b.Add("legs",
              BeamMesh({x, y + spread_m, 0}, {0.85f * x, y + 0.15f * spread_m, under_m}, bar, bar));
      }
      b.Box("legs", {0.94f * x - 0.012f, y - 0.12f, 0.3f * under_m},
            {0.94f * x + 0.012f, y + 0.12f, 0.3f * under_m + 0.03f});
    }
    b.Box("legs", {-0.9f * x_m, y - 0.03f, under_m - 0.05f}, {0.9f * x_m, y + 0.03f, under_m});
  }
}

// Drawers below both ends, a board at the back: one sits between.
void BuildPedestalDesk(FurnitureBuilder& b) {
  const float top_m = 0.04f;
  const float under_m = b.height() - top_m;
  const float y = 0.5f * b.width() - 0.02f;
  const float wide_m = std::min(0.42f, 0.3f * b.width());
  AddTableTop(b, top_m);
  AddDrawerBox(b, -y, -y + wide_m, 0, under_m);
  AddDrawerBox(b, y - wide_m, y, 0, under_m);
  b.Box("legs", {-0.5f * b.depth() + 0.03f, -y + wide_m, 0.1f},
        {-0.5f * b.depth() + 0.05f, y - wide_m, under_m});
}

// An L: the wing on its right comes forward, to whoever sits in the corner.
void BuildCornerDesk(FurnitureBuilder& b) {
  const float top_m = 0.028f;
  const float under_m = b.height() - top_m;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float deep_m = std::min(0.7f, 0.5f * b.depth());
  const float leg_m = 0.05f;
  b.Box("top", {-x, -y, under_m}, {-x + deep_m, y, b.height()});
  b.Box("top", {-x + deep_m, -y, under_m}, {x, -y + 0.9f * deep_m, b.height()});
  for (const auto& [rear, right] : {std::pair(-x, -y),
                                    {-x, y - leg_m},
                                    {-x + deep_m - leg_m, y - leg_m},
                                    {x - leg_m, -y},
                                    {x - leg_m, -y + 0.9f * deep_m - leg_m}}) {
    b.Box("legs", {rear, right, 0}, {rear + leg_m, right + leg_m, under_m});
  }
  b.Box("legs", {-x + 0.01f, -y + leg_m, under_m - 0.3f}, {-x + 0.03f, y - leg_m, under_m});
}

// Two lifting columns on feet like a T.
void BuildStandingDesk(FurnitureBuilder& b) {
  const float top_m = 0.025f;
  const float under_m = b.height() - top_m;
  const float x = 0.46f * b.depth();
  b.Add("top", SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.03f), under_m, b.height()));
  for (const float y : {-0.36f * b.width(), 0.36f * b.width()}) {
    b.Box("legs", {-x, y - 0.04f, 0}, {x, y + 0.04f, 0.03f});
    b.Box("legs", {-0.05f, y - 0.035f, 0.03f}, {0.05f, y + 0.035f, 0.55f * under_m});
    b.Box("legs", {-0.04f, y - 0.025f, 0.55f * under_m}, {0.04f, y + 0.025f, under_m - 0.04f});
    b.Box("legs", {-0.8f * x, y - 0.03f, under_m - 0.04f}, {0.8f * x, y + 0.03f, under_m});
  }
  b.Box("legs", {-0.04f, -0.36f * b.width() + 0.03f, under_m - 0.05f},
        {0.04f, 0.36f * b.width() - 0.03f, under_m - 0.005f});
  b.Box("handles", {0.5f * b.depth() - 0.07f, -0.4f * b.width(), under_m - 0.02f},
        {0.5f * b.depth() - 0.01f, -0.4f * b.width() + 0.12f, under_m});
}

// A slender frame with two flat drawers below the top.
void BuildWritingDesk(FurnitureBuilder& b) {
  const float top_m = 0.02f;
  const float under_m = b.height() - top_m;
  const float drawer_m = 0.13f * b.height();
  const float x = 0.5f * b.depth() - 0.03f, y = 0.5f * b.width() - 0.02f;
  AddTableTop(b, top_m);
  b.Box("top", {-x, -y, under_m - drawer_m}, {x - 0.02f, y, under_m});
  for (const float right : {-y, 0.0f}) {
    b.Box("legs", {x - 0.02f, right + 0.004f, under_m - drawer_m + 0.004f},
          {x, right + y - 0.004f, under_m - 0.004f});
    b.Add("handles", EllipsoidMesh({x + 0.01f, right + 0.5f * y, under_m - 0.5f * drawer_m},
                                   {0.012f, 0.015f, 0.015f}, 10));
  }
  AddSplayedLegs(b, "legs", {0.96f * b.depth(), 0.97f * b.width()},
                 {0.84f * b.depth(), 0.9f * b.width()}, under_m - drawer_m, 0.019f);
  b.FitToSize();
}

// A top that is broad in its middle, on two boards that face each other.
void BuildBoatTable(FurnitureBuilder& b) {
  constexpr int kSteps = 12;
  const float top_m = 0.04f;
  const float under_m = b.height() - top_m;
  std::vector<Eigen::Vector2f> outline_m;
  for (const float side : {1.0f, -1.0f}) {
    for (int i = 0; i <= kSteps; ++i) {
      const float along = side * (2.0f * i / kSteps - 1.0f);
      outline_m.emplace_back(side * 0.5f * b.depth() * (1.0f - 0.35f * along * along),
                             0.5f * b.width() * along);
    }
  }
  b.Add("top", SlabMesh(outline_m, under_m, b.height()));
  for (const float y : {-0.3f * b.width(), 0.3f * b.width()}) {
    b.Box("legs", {-0.3f * b.depth(), y - 0.03f, 0}, {0.3f * b.depth(), y + 0.03f, under_m});
  }
  b.Box("legs", {-0.015f, -0.3f * b.width() + 0.03f, 0.4f * under_m},
        {0.015f, 0.3f * b.width() - 0.03f, 0.7f * under_m});
}

// Half circles for ends, on columns that stand on discs.
void BuildRacetrackTable(FurnitureBuilder& b) {
  const float top_m = 0.03f;
  const float under_m = b.height() - top_m;
  const float radius_m = 0.5f * std::min(b.depth(), b.width());
  b.Add("top",
        SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.98f * radius_m), under_m, b.height()));
  const float y_m = 0.5f * b.width() - 0.9f * radius_m;
  for (const float y : {-y_m, y_m}) {
    b.Add("legs", CylinderMesh({0, y, 0}, 0.62f * radius_m, 0.6f * radius_m, 0.015f, 28));
    b.Add("legs", CylinderMesh({0, y, 0.015f}, 0.05f, 0.05f, under_m - 0.015f, 16));
  }
}

// Tables pushed together: seams across the top and a frame with legs below each.
void BuildSegmentedTable(FurnitureBuilder& b) {
  const float top_m = 0.028f;
  const float bar_m = 0.05f;
  const float under_m = b.height() - top_m;
  const float x = 0.5f * b.depth();
  const int count = std::max(2, static_cast<int>(std::lround(b.width() / 1.6f)));
  const float each_m = b.width() / count;
  for (int i = 0; i < count; ++i) {
    const float right = -0.5f * b.width() + i * each_m + (i > 0 ? 0.004f : 0.0f);
    const float left = -0.5f * b.width() + (i + 1) * each_m;
    b.Box("top", {-x, right, under_m}, {x, left, b.height()});
    for (const float y : {right + 0.02f, left - 0.02f - bar_m}) {
      for (const float rear : {-x + 0.02f, x - 0.02f - bar_m}) {
        b.Box("legs", {rear, y, 0}, {rear + bar_m, y + bar_m, under_m});
      }
      b.Box("legs", {-x + 0.02f + bar_m, y, under_m - bar_m},
            {x - 0.02f - bar_m, y + bar_m, under_m});
    }
  }
}

// Legs like a V at both ends.
void BuildVLegTable(FurnitureBuilder& b) {
  const float top_m = 0.035f;
  const float under_m = b.height() - top_m;
  const Eigen::Vector2f bar(0.07f, 0.06f);
  AddTableTop(b, top_m);
  for (const float y : {-0.36f * b.width(), 0.36f * b.width()}) {
    for (const float side : {-1.0f, 1.0f}) {
      b.Add("legs",
            BeamMesh({side * 0.05f, y, 0.03f}, {side * 0.38f * b.depth(), y, under_m}, bar, bar));
    }
    b.Box("legs", {-0.3f * b.depth(), y - 0.05f, 0}, {0.3f * b.depth(), y + 0.05f, 0.03f});
    b.Box("legs", {-0.42f * b.depth(), y - 0.03f, under_m - 0.03f},
          {0.42f * b.depth(), y + 0.03f, under_m});
  }
}

}  // namespace

DesignTable DeskDesigns() {
  return {{"desk",
           {{BuildPanelDesk, {0.7f, 1.4f, 0.74f}},
            {BuildPedestalDesk, {0.8f, 1.7f, 0.76f}},
            {BuildStandingDesk, {0.8f, 1.6f, 0.8f}},
            {BuildWritingDesk, {0.6f, 1.2f, 0.76f}},
            {BuildTrestleDesk, {0.75f, 1.6f, 0.74f}},
            {BuildCornerDesk, {1.5f, 1.7f, 0.74f}}}},
          {"conference_table",
           {{BuildSegmentedTable, {1.4f, 3.2f, 0.74f}},
            {BuildBoatTable, {1.3f, 3.6f, 0.75f}},
            {BuildVLegTable, {1.2f, 2.8f, 0.74f}},
            {BuildRacetrackTable, {1.2f, 2.6f, 0.74f}}}}};
}

}  // namespace semantic_slam
