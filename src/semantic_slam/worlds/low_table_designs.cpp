#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// All are drawn at their usual size and stretched to the one asked for at the end.

constexpr float kPi = 3.14159265f;

// A round top on three round legs, in the middle at `at_m`.
void AddTripodTable(FurnitureBuilder& b, const Eigen::Vector2f& at_m, float radius_m,
                    float height_m) {
  const Eigen::Vector3f middle(at_m.x(), at_m.y(), 0);
  b.Add("top", CylinderMesh(middle + Eigen::Vector3f(0, 0, height_m - 0.025f), radius_m - 0.01f,
                            radius_m, 0.025f, 36));
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f out =
        Turned(2 * kPi * static_cast<float>(i) / 3).linear().col(0).cast<float>();
    AddTube(b, "legs",
            {middle + 0.9f * radius_m * out + Eigen::Vector3f(0, 0, 0.012f),
             middle + 0.6f * radius_m * out + Eigen::Vector3f(0, 0, height_m - 0.03f)},
            0.014f);
  }
}

// Two round tables, the lower one half below the other.
void BuildNestedTables(FurnitureBuilder& b) {
  AddTripodTable(b, {-0.06f, 0.14f}, 0.36f, 0.44f);
  AddTripodTable(b, {0.1f, -0.24f}, 0.26f, 0.34f);
  b.FitToSize();
}

// A tray with a rim and grips, on legs that cross below it and fold.
void BuildTrayTable(FurnitureBuilder& b) {
  constexpr float kTrayM = 0.38f;
  const float x = 0.28f, y = 0.42f;
  const Eigen::Vector2f bar(0.03f, 0.022f);
  b.Box("top", {-x, -y, kTrayM}, {x, y, kTrayM + 0.014f});
  for (const float side : {-1.0f, 1.0f}) {
    b.Add("top",
          BeamMesh({side * (x - 0.006f), 0, kTrayM + 0.014f}, {side * (x + 0.01f), 0, 0.425f},
                   {0.012f, 2 * y}, {0.012f, 2 * y + 0.03f}));
    b.Add("top",
          BeamMesh({0, side * (y - 0.006f), kTrayM + 0.014f}, {0, side * (y + 0.01f), 0.445f},
                   {2 * x - 0.02f, 0.012f}, {0.3f, 0.012f}));
    for (const float lean : {-1.0f, 1.0f}) {
      const float at = side * 0.3f + lean * 0.012f;
      b.Add("legs", BeamMesh({-0.23f * lean, at, 0}, {0.23f * lean, at, kTrayM}, bar, bar));
    }
  }
  for (const float lean : {-1.0f, 1.0f}) {
    const float at = 0.19f * lean, z = lean > 0 ? 0.34f : 0.05f;
    AddTube(b, "legs", {{at, -0.3f, z}, {at, 0.3f, z}}, 0.01f);
  }
  b.FitToSize();
}

// A thick pane like a triangle with round sides, on two bent pieces of wood across each other.
void BuildSculptedTable(FurnitureBuilder& b) {
  constexpr int kCorners = 48;
  constexpr float kUnderM = 0.385f;
  std::vector<Eigen::Vector2f> outline_m;
  for (int i = 0; i < kCorners; ++i) {
    const float angle = 2 * kPi * i / kCorners;
    const float radius_m = 0.5f + 0.045f * std::cos(3 * angle);  // convex below a tenth
    outline_m.emplace_back(0.8f * radius_m * std::cos(angle - kPi / 6),
                           1.15f * radius_m * std::sin(angle - kPi / 6));
  }
  b.Add("top", SlabMesh(outline_m, kUnderM, kUnderM + 0.02f));
  const auto add_piece = [&](float turn_rad, bool upside_down) {
    const auto at = [&](float along, float z) -> Eigen::Vector3f {
      return {along, 0, upside_down ? kUnderM - z : z};
    };
    const std::vector<Eigen::Vector3f> line{at(-0.31f, 0.042f), at(-0.1f, 0.055f), at(0.1f, 0.13f),
                                            at(0.25f, 0.24f), at(0.34f, 0.365f)};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      b.Add("legs", LimbMesh(line[i], line[i + 1], 0.042f - 0.004f * i, 0.038f - 0.004f * i, 10),
            Turned(turn_rad));
    }
  };
  add_piece(1.25f, false);
  add_piece(1.25f + 0.6f * kPi, true);
  b.FitToSize();
}

// A sea chest: bands of metal around it, grips at its ends, a lid with a rim.
void BuildTrunk(FurnitureBuilder& b) {
  const float x = 0.27f, y = 0.47f;
  b.Box("legs", {-x + 0.03f, -y + 0.03f, 0}, {x - 0.03f, y - 0.03f, 0.03f});
  b.Box("top", {-x, -y, 0.03f}, {x, y, 0.32f});
  b.Box("top", {-x - 0.006f, -y - 0.006f, 0.325f}, {x + 0.006f, y + 0.006f, 0.43f});
  b.Box("legs", {-x + 0.01f, -y + 0.01f, 0.32f}, {x - 0.01f, y - 0.01f, 0.325f});
  for (const float at : {-0.62f * y, 0.62f * y}) {
    b.Box("legs", {-x - 0.012f, at - 0.022f, 0.035f}, {x + 0.012f, at + 0.022f, 0.315f});
    b.Box("legs", {-x - 0.014f, at - 0.022f, 0.33f}, {x + 0.014f, at + 0.022f, 0.436f});
  }
  for (const float front : {-x + 0.026f, x - 0.026f}) {
    for (const float left : {-y + 0.026f, y - 0.026f}) {
      b.Add("legs", BoxMesh({front, left, 0.06f}, {0.07f, 0.07f, 0.06f}));
      b.Add("legs", BoxMesh({front, left, 0.4f}, {0.075f, 0.075f, 0.075f}));
    }
  }
  b.Box("legs", {x, -0.04f, 0.26f}, {x + 0.02f, 0.04f, 0.38f});
  AddTubePair(b, "legs",
              {{-0.07f, y + 0.005f, 0.24f},
               {-0.06f, y + 0.035f, 0.2f},
               {0.06f, y + 0.035f, 0.2f},
               {0.07f, y + 0.005f, 0.24f}},
              0.009f);
  b.FitToSize();
}

}  // namespace

DesignTable LowTableDesigns() {
  return {{"coffee_table",
           {{BuildNestedTables, {0.72f, 0.98f, 0.45f}},
            {BuildTrayTable, {0.6f, 0.9f, 0.47f}},
            {BuildSculptedTable, {0.88f, 1.2f, 0.4f}},
            {BuildTrunk, {0.6f, 1.05f, 0.44f}}}}};
}

}  // namespace semantic_slam
