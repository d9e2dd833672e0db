#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// All are drawn at their usual size and stretched to the one asked for at the end.

// A slender frame of turned wood with arms like paddles; two loose cushions lean on slats.
void BuildPaddleArmChair(FurnitureBuilder& b) {
  AddTubePair(b, "legs", {{0.32f, 0.33f, 0.015f}, {0.28f, 0.32f, 0.54f}}, 0.019f);
  AddTubePair(b, "legs", {{-0.3f, 0.33f, 0.015f}, {-0.2f, 0.32f, 0.5f}}, 0.019f);
  AddTubePair(b, "legs", {{0.3f, 0.32f, 0.31f}, {-0.25f, 0.32f, 0.25f}}, 0.016f);
  for (const float y : {-0.33f, 0.33f}) {
    b.Add("legs", RoundedBoxMesh({0, y, 0}, {0.66f, 0.075f, 0.028f}, 0.012f),
          Leaning({0.02f, 0, 0.535f}, -0.06f));
  }
  for (const float x : {-0.2f, 0.26f}) {
    AddTube(b, "legs", {{x, -0.32f, 0.29f}, {x, 0.32f, 0.29f}}, 0.014f);
  }
  const Rigid3d T_back = Leaning({-0.2f, 0, 0.28f}, -0.42f);
  for (const float y : {-0.26f, 0.26f}) {
    b.Add("legs", RoundedBoxMesh({-0.02f, y, 0.32f}, {0.024f, 0.035f, 0.66f}, 0.01f), T_back);
  }
  for (int i = 0; i < 4; ++i) {
    b.Add("legs", RoundedBoxMesh({-0.02f, 0, 0.14f + 0.16f * i}, {0.016f, 0.52f, 0.045f}, 0.007f),
          T_back);
  }
  b.Add("cushions", RoundedBoxMesh({0.27f, 0, 0.055f}, {0.56f, 0.58f, 0.11f}, 0.045f),
        Leaning({-0.22f, 0, 0.28f}, -0.09f));
  b.Add("cushions", RoundedBoxMesh({0.06f, 0, 0.36f}, {0.11f, 0.56f, 0.58f}, 0.045f), T_back);
  b.FitToSize();
}

// To lie in: its back leans far, its footrest is up, on a bracket of metal.
void BuildRecliner(FurnitureBuilder& b) {
  b.Box("legs", {-0.3f, -0.36f, 0}, {0.24f, 0.36f, 0.05f});
  AddPadding(b, "cover", {-0.36f, -0.4f, 0.04f}, {0.28f, 0.4f, 0.34f}, 0.03f);
  AddPadding(b, "cushions", {-0.26f, -0.29f, 0.3f}, {0.32f, 0.29f, 0.49f}, 0.07f);
  for (const float y : {-0.37f, 0.37f}) {
    AddPadding(b, "cover", {-0.4f, y - 0.095f, 0.05f}, {0.3f, y + 0.095f, 0.62f}, 0.07f);
  }
  const Rigid3d T_back = Leaning({-0.3f, 0, 0.36f}, -0.6f);
  b.Add("cover", RoundedBoxMesh({-0.06f, 0, 0.38f}, {0.12f, 0.66f, 0.78f}, 0.05f), T_back);
  for (int i = 0; i < 3; ++i) {
    b.Add("cushions", RoundedBoxMesh({0.04f, 0, 0.17f + 0.25f * i}, {0.16f, 0.6f, 0.27f}, 0.07f),
          T_back);
  }
  b.Add("cushions", RoundedBoxMesh({0.24f, 0, 0}, {0.46f, 0.56f, 0.11f}, 0.045f),
        Leaning({0.36f, 0, 0.41f}, 0.06f));
  AddTubePair(b, "legs", {{0.22f, 0.2f, 0.2f}, {0.42f, 0.2f, 0.24f}, {0.62f, 0.2f, 0.34f}}, 0.012f);
  b.FitToSize();
}

// The cloth of a sling chair: it hangs from four tips, those behind high, those before lower.
Mesh SlingMesh() {
  constexpr float kHalfM = 0.006f;
  const auto middle_m = [](float u, float v) -> Eigen::Vector3f {
    const float across = 2.0f * u - 1.0f;
    const float along = 2.0f * v - 1.0f;  // -1 at the top of the back, 1 at the front
    const float half_m = 0.27f + 0.11f * along * along;
    const float tip = across * across * along * along;  // 1 at the four tips
    const float x = 0.36f * along + (along > 0.0f ? 0.05f : -0.05f) * tip;
    const float sag_m = along < 0.0f ? 0.5f * along * along : 0.1f * along * along;
    return {x, half_m * across, 0.33f + sag_m + 0.12f * tip + 0.05f * across * across};
  };
  return SheetMesh(
      middle_m, [](float, float) { return kHalfM; }, Eigen::Vector3f(0.6f, 0, 0.8f), 12, 18);
}

// A butterfly: cloth on rods that cross and bend on the floor.
void BuildSlingChair(FurnitureBuilder& b) {
  b.Add("cushions", SlingMesh());
  const Eigen::Vector3f rear_tip_m(-0.4f, 0.37f, 0.97f), front_tip_m(0.4f, 0.37f, 0.58f);
  AddTubePair(b, "legs", {front_tip_m, {-0.3f, 0.3f, 0.012f}, {-0.3f, 0, 0.012f}}, 0.01f);
  AddTubePair(b, "legs", {rear_tip_m, {0.28f, 0.3f, 0.012f}, {0.28f, 0, 0.012f}}, 0.01f);
  b.FitToSize();
}

// Low and without arms, its back of upright rolls.
void BuildSlipperChair(FurnitureBuilder& b) {
  constexpr int kRolls = 5;
  AddSplayedLegs(b, "legs", {0.6f, 0.54f}, {0.5f, 0.46f}, 0.18f, 0.017f);
  AddPadding(b, "cover", {-0.3f, -0.3f, 0.16f}, {0.34f, 0.3f, 0.27f}, 0.03f);
  AddPadding(b, "cushions", {-0.26f, -0.31f, 0.26f}, {0.36f, 0.31f, 0.42f}, 0.06f);
  const Rigid3d T_back = Leaning({-0.26f, 0, 0.2f}, -0.2f);
  b.Add("cover", RoundedBoxMesh({-0.04f, 0, 0.31f}, {0.07f, 0.6f, 0.6f}, 0.03f), T_back);
  for (int i = 0; i < kRolls; ++i) {
    const float y = 0.6f * ((i + 0.5f) / kRolls - 0.5f);
    b.Add("cushions", RoundedBoxMesh({0.02f, y, 0.4f}, {0.11f, 0.6f / kRolls, 0.46f}, 0.05f),
          T_back);
  }
  b.FitToSize();
}

}  // namespace

DesignTable EasyChairDesigns() {
  return {{"armchair",
           {{BuildPaddleArmChair, {0.8f, 0.74f, 0.84f}},
            {BuildRecliner, {1.5f, 0.93f, 0.98f}},
            {BuildSlingChair, {0.8f, 0.78f, 0.92f}},
            {BuildSlipperChair, {0.74f, 0.64f, 0.8f}}}}};
}

}  // namespace semantic_slam
