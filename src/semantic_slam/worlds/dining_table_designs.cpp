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

// A turned column with three feet that sweep down from it.
void AddTurnedPillar(FurnitureBuilder& b, float y_m, float top_m, float turn_rad) {
  b.Add("legs", LatheMesh({0, y_m, 0.22f},
                          {{0, 0},
                           {0.055f, 0},
                           {0.065f, 0.06f},
                           {0.04f, 0.14f},
                           {0.06f, 0.26f},
                           {0.038f, 0.36f},
                           {0.05f, top_m - 0.24f},
                           {0.05f, top_m - 0.22f},
                           {0, top_m - 0.22f}},
                          18));
  const Eigen::Vector3f middle(0, y_m, 0), up = Eigen::Vector3f::UnitZ();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f out =
        Turned(turn_rad + 2 * kPi * static_cast<float>(i) / 3).linear().col(0).cast<float>();
    AddTube(b, "legs",
            {middle + 0.03f * out + 0.29f * up, middle + 0.16f * out + 0.24f * up,
             middle + 0.3f * out + 0.1f * up, middle + 0.38f * out + 0.022f * up},
            0.024f);
  }
}

// Two pillars below a long top with a thin rim.
void BuildTwoPillarTable(FurnitureBuilder& b) {
  const float top_m = 0.026f;
  const float under_m = b.height() - top_m;
  b.Add("top",
        SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.1f * b.depth()), under_m, b.height()));
  b.Box("legs", {-0.36f * b.depth(), -0.38f * b.width(), under_m - 0.03f},
        {0.36f * b.depth(), 0.38f * b.width(), under_m});
  for (const float side : {-1.0f, 1.0f}) {
    AddTurnedPillar(b, side * 0.25f * b.width(), under_m - 0.03f, side * kPi / 2);
  }
  b.FitToSize();
}

// Its left leaf hangs down; the right one is up, on legs that swing like a gate.
void BuildDropLeafTable(FurnitureBuilder& b) {
  const float top_m = 0.022f;
  const float under_m = b.height() - top_m;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float leaf = y - 0.03f;  // where the left leaf hangs
  const float core = leaf - 0.42f * b.width();
  b.Box("top", {-x, core, under_m}, {x, leaf, b.height()});
  b.Box("top", {-x, -y, under_m}, {x, core - 0.004f, b.height()});
  b.Box("top", {-x, leaf + 0.005f, 0.32f * b.height()}, {x, y, b.height() - 0.004f});
  for (const float front : {-x + 0.06f, x - 0.06f}) {
    for (const float left : {core + 0.03f, leaf - 0.04f}) {
      b.Add("legs", CylinderMesh({front, left, 0}, 0.02f, 0.026f, under_m, 12));
    }
    b.Box("legs", {front - 0.012f, core + 0.05f, 0.1f}, {front + 0.012f, leaf - 0.06f, 0.13f});
  }
  for (const float left : {core + 0.03f, leaf - 0.04f}) {
    b.Box("legs", {-x + 0.08f, left - 0.01f, under_m - 0.1f}, {x - 0.08f, left + 0.01f, under_m});
  }
  b.Box("legs", {-x + 0.08f, core + 0.02f, 0.09f}, {x - 0.08f, core + 0.04f, 0.115f});
  b.Add("legs", CylinderMesh({0.1f * x, -y + 0.1f, 0}, 0.018f, 0.024f, under_m, 12));
  for (const float z : {0.1f, under_m - 0.04f}) {
    AddTube(b, "legs", {{0.5f * x, core + 0.02f, z}, {0.1f * x, -y + 0.1f, z}}, 0.012f);
  }
}

// A column on a cross of four low arms, as in canteens.
void AddCrossFoot(FurnitureBuilder& b, float radius_m, float top_m) {
  for (int i = 0; i < 4; ++i) {
    b.Add("legs",
          BeamMesh({0.5f * radius_m, 0, 0}, {0.46f * radius_m, 0, 0.035f}, {radius_m, 0.07f},
                   {0.92f * radius_m, 0.05f}),
          Turned(kPi / 4 + kPi / 2 * static_cast<float>(i)));
  }
  b.Add("legs", CylinderMesh({0, 0, 0.03f}, 0.038f, 0.038f, top_m - 0.03f, 16));
  b.Add("legs", BoxMesh({0, 0, top_m - 0.006f}, {0.3f, 0.3f, 0.012f}));
}

// A small square top for two on one column.
void BuildCanteenTable(FurnitureBuilder& b) {
  const float top_m = 0.03f;
  const float under_m = b.height() - top_m;
  b.Add("top", SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.03f), under_m, b.height()));
  AddCrossFoot(b, 0.44f * std::min(b.depth(), b.width()), under_m);
}

// A small round one with a rim of metal, on a disc.
void BuildBistroTable(FurnitureBuilder& b) {
  const float under_m = b.height() - 0.03f;
  const float radius_m = 0.5f * std::min(b.depth(), b.width());
  b.Add("top",
        CylinderMesh({0, 0, under_m + 0.002f}, radius_m - 0.012f, radius_m - 0.012f, 0.028f, 40));
  b.Add("legs", CylinderMesh({0, 0, under_m}, radius_m, radius_m, 0.024f, 40));
  b.Add("legs", LatheMesh({0, 0, 0},
                          {{0, 0},
                           {0.6f * radius_m, 0},
                           {0.58f * radius_m, 0.02f},
                           {0.07f, 0.05f},
                           {0.03f, 0.1f},
                           {0.03f, under_m - 0.05f},
                           {0.1f, under_m},
                           {0, under_m}},
                          28));
  b.FitToSize();
}

// Rods that cross like dropped sticks: each goes from one side of the floor to the other of the
// top.
void AddCrossingRods(FurnitureBuilder& b, int rods, float head_share, float foot_share,
                     float under_m) {
  constexpr float kTwistRad = 2.3f;
  for (int i = 0; i < rods; ++i) {
    const float angle = kPi / 4 + 2 * kPi * static_cast<float>(i) / rods;
    const Eigen::Vector3f foot(foot_share * 0.5f * b.depth() * std::cos(angle),
                               foot_share * 0.5f * b.width() * std::sin(angle), 0.022f);
    const Eigen::Vector3f head(head_share * 0.5f * b.depth() * std::cos(angle + kTwistRad),
                               head_share * 0.5f * b.width() * std::sin(angle + kTwistRad),
                               under_m);
    AddTube(b, "legs", {foot, head}, 0.024f);
  }
}

// A round or oval top over crossing rods.
void BuildCrossingRodsTable(FurnitureBuilder& b) {
  const float under_m = b.height() - 0.024f;
  b.Add("top", SlabMesh(EllipseOutline({b.depth(), b.width()}), under_m, b.height()));
  AddCrossingRods(b, 4, 0.55f, 0.72f, under_m - 0.02f);
  b.FitToSize();
}

}  // namespace

DesignTable DiningTableDesigns() {
  return {
      {"table",
       {{BuildTwoPillarTable, {1.0f, 2.0f, 0.75f}},
        {BuildDropLeafTable, {0.85f, 1.1f, 0.75f}},
        {BuildCanteenTable, {0.7f, 0.75f, 0.74f}},
        {BuildCrossingRodsTable, {1.0f, 1.7f, 0.74f}}}},
      {"round_table",
       {{BuildBistroTable, {0.7f, 0.7f, 0.73f}}, {BuildCrossingRodsTable, {1.2f, 1.2f, 0.74f}}}}};
}

}  // namespace semantic_slam
