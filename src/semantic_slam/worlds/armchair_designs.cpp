#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// All are drawn at their usual size and stretched to the one asked for at the end.

constexpr float kPi = 3.14159265f;

// Two bent sides of laminated wood that spring, and one long cushion.
void BuildSpringChair(FurnitureBuilder& b) {
  for (const float y : {-0.31f, 0.31f}) {
    const auto board = [&](const Eigen::Vector3f& foot_m, const Eigen::Vector3f& head_m) {
      b.Add("legs", BeamMesh(foot_m, head_m, {0.035f, 0.055f}, {0.035f, 0.055f}));
    };
    b.Box("legs", {-0.3f, y - 0.0275f, 0}, {0.33f, y + 0.0275f, 0.03f});
    board({0.33f, y, 0}, {0.4f, y, 0.1f});
    board({0.4f, y, 0.1f}, {0.36f, y, 0.52f});
    b.Box("legs", {-0.32f, y - 0.0275f, 0.5f}, {0.375f, y + 0.0275f, 0.53f});
    board({-0.2f, y, 0.2f}, {-0.3f, y, 0.5f});
  }
  for (const float x : {-0.26f, 0.24f}) b.Box("legs", {x, -0.31f, 0.26f}, {x + 0.04f, 0.31f, 0.3f});
  b.Add("cushions", RoundedBoxMesh({0.28f, 0, 0.05f}, {0.62f, 0.54f, 0.11f}, 0.045f),
        Leaning({-0.26f, 0, 0.29f}, -0.16f));
  b.Add("cushions", RoundedBoxMesh({0, 0, 0.36f}, {0.11f, 0.54f, 0.72f}, 0.045f),
        Leaning({-0.22f, 0, 0.32f}, -0.4f));
  b.Add("cover", RoundedBoxMesh({0.06f, 0, 0.62f}, {0.1f, 0.48f, 0.17f}, 0.045f),
        Leaning({-0.22f, 0, 0.32f}, -0.4f));
  b.FitToSize();
}

// A high back with wings at the head, on thin legs.
void BuildWingChair(FurnitureBuilder& b) {
  AddSplayedLegs(b, "legs", {0.66f, 0.62f}, {0.54f, 0.54f}, 0.22f, 0.018f);
  AddPadding(b, "cover", {-0.34f, -0.36f, 0.2f}, {0.36f, 0.36f, 0.34f}, 0.04f);
  AddPadding(b, "cushions", {-0.26f, -0.27f, 0.32f}, {0.38f, 0.27f, 0.47f}, 0.05f);
  b.Add("cover", RoundedBoxMesh({0, 0, 0.4f}, {0.14f, 0.68f, 0.82f}, 0.06f),
        Leaning({-0.28f, 0, 0.28f}, -0.14f));
  for (const float y : {-0.33f, 0.33f}) {
    AddPadding(b, "cover", {-0.32f, y - 0.05f, 0.3f}, {0.32f, y + 0.05f, 0.58f}, 0.04f);
    b.Add("cover", RoundedBoxMesh({0.12f, y, 0.58f}, {0.28f, 0.075f, 0.42f}, 0.035f),
          Leaning({-0.28f, 0, 0.28f}, -0.14f));
  }
  b.FitToSize();
}

// A tub whose back comes around to the front in one curve.
void BuildBarrelChair(FurnitureBuilder& b) {
  constexpr int kStaves = 13;
  b.Add("legs", CylinderMesh({0, 0, 0}, 0.3f, 0.32f, 0.07f, 28));
  b.Add("cover", CylinderMesh({0, 0, 0.07f}, 0.39f, 0.39f, 0.22f, 28));
  b.Add("cushions", LatheMesh({0.03f, 0, 0.27f},
                              {{0, 0}, {0.3f, 0}, {0.33f, 0.05f}, {0.3f, 0.15f}, {0, 0.17f}}, 28));
  for (int i = 0; i < kStaves; ++i) {
    const float angle = kPi * (0.3f + 1.4f * i / (kStaves - 1));
    const float behind = 0.5f - 0.5f * std::cos(angle);  // 1 at the rear
    const float rise_m = 0.32f + 0.17f * behind;
    const Mesh stave =
        RoundedBoxMesh({0.36f, 0, 0.25f + 0.5f * rise_m}, {0.11f, 0.15f, rise_m}, 0.045f);
    b.Add("cover", stave, Turned(angle));
  }
  b.FitToSize();
}

// Thick cubes in a cage of steel tube.
void BuildCubeChair(FurnitureBuilder& b) {
  for (const float z : {0.06f, 0.3f, 0.62f}) {
    const float front = z > 0.5f ? 0.34f : 0.36f;
    AddTubePair(b, "legs", {{-0.35f, 0.38f, z}, {front, 0.38f, z}}, 0.014f);
    AddTube(b, "legs", {{-0.35f, -0.38f, z}, {-0.35f, 0.38f, z}}, 0.014f);
  }
  AddTubePair(b, "legs", {{0.35f, 0.38f, 0.014f}, {0.35f, 0.38f, 0.62f}}, 0.014f);
  AddTubePair(b, "legs", {{-0.35f, 0.38f, 0.014f}, {-0.35f, 0.38f, 0.62f}}, 0.014f);
  AddTube(b, "legs", {{0.35f, -0.38f, 0.1f}, {0.35f, 0.38f, 0.1f}}, 0.014f);
  AddPadding(b, "cover", {-0.33f, -0.21f, 0.1f}, {0.36f, 0.21f, 0.27f}, 0.035f);
  AddPadding(b, "cushions", {-0.2f, -0.21f, 0.27f}, {0.36f, 0.21f, 0.42f}, 0.035f);
  AddPadding(b, "cushions", {-0.335f, -0.21f, 0.26f}, {-0.2f, 0.21f, 0.67f}, 0.04f);
  for (const float y : {-0.365f, 0.215f}) {
    AddPadding(b, "cushions", {-0.33f, y, 0.1f}, {0.335f, y + 0.15f, 0.6f}, 0.04f);
  }
  b.FitToSize();
}

// A wide moulded shell with a cushion, turning on a star.
void BuildLoungeShell(FurnitureBuilder& b) {
  AddStarFoot(b, "legs", 5, 0.33f, 0.3f);
  AddShell(b, "cover",
           {{0.36f, 0.35f},
            {0.28f, 0.37f},
            {0.08f, 0.32f},
            {-0.1f, 0.29f},
            {-0.22f, 0.33f},
            {-0.29f, 0.48f},
            {-0.35f, 0.68f},
            {-0.4f, 0.9f}},
           0.72f, 0.2f);
  b.Add("cushions", RoundedBoxMesh({0.3f, 0, 0.05f}, {0.5f, 0.46f, 0.1f}, 0.045f),
        Leaning({-0.2f, 0, 0.32f}, -0.1f));
  b.Add("cushions", RoundedBoxMesh({0.04f, 0, 0.3f}, {0.1f, 0.42f, 0.46f}, 0.045f),
        Leaning({-0.25f, 0, 0.38f}, -0.26f));
  b.FitToSize();
}

}  // namespace

DesignTable ArmchairDesigns() {
  return {{"armchair",
           {{BuildBarrelChair, {0.8f, 0.82f, 0.74f}},
            {BuildSpringChair, {0.86f, 0.68f, 0.98f}},
            {BuildWingChair, {0.84f, 0.76f, 1.08f}},
            {BuildCubeChair, {0.74f, 0.8f, 0.67f}},
            {BuildLoungeShell, {0.84f, 0.8f, 0.94f}}}}};
}

}  // namespace semantic_slam
