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

// Thin ribs between two rails that run from the seat up into the back; arms like loops.
void BuildRibbed(FurnitureBuilder& b) {
  constexpr float kSpacingM = 0.03f;
  AddCastorFoot(b, "base", 0.31f, 0.44f);
  b.Box("base", {-0.1f, -0.24f, 0.43f}, {0.06f, 0.24f, 0.45f});
  const std::vector<Eigen::Vector3f> rail_m{
      {0.25f, 0.25f, 0.44f},  {0.2f, 0.25f, 0.47f},   {-0.1f, 0.25f, 0.45f}, {-0.18f, 0.25f, 0.47f},
      {-0.22f, 0.25f, 0.54f}, {-0.29f, 0.25f, 0.86f}, {-0.32f, 0.25f, 0.94f}};
  AddTubePair(b, "base", rail_m, 0.013f);
  float next_m = 0.0f;  // along the stretch, to the next rib
  for (std::size_t i = 0; i + 1 < rail_m.size(); ++i) {
    const Eigen::Vector3f along = rail_m[i + 1] - rail_m[i];
    for (; next_m < along.norm(); next_m += kSpacingM) {
      Eigen::Vector3f left_m = rail_m[i] + next_m * along.normalized();
      Eigen::Vector3f right_m = left_m;
      right_m.y() = -left_m.y();
      b.Add("seat", LimbMesh(left_m, right_m, 0.015f, 0.015f, 8));
    }
    next_m -= along.norm();
  }
  AddTubePair(b, "base",
              {{0.02f, 0.26f, 0.45f},
               {0.1f, 0.3f, 0.62f},
               {0.06f, 0.3f, 0.66f},
               {-0.16f, 0.3f, 0.66f},
               {-0.24f, 0.26f, 0.62f}},
              0.014f);
  b.FitToSize();
}

// For high desks: a round seat far up, a ring for the feet, and a small back.
void BuildDraftingStool(FurnitureBuilder& b) {
  AddCastorFoot(b, "base", 0.3f, 0.62f);
  std::vector<Eigen::Vector3f> ring_m;
  for (int i = 0; i <= 16; ++i) {
    const float angle = 2 * kPi * i / 16;
    ring_m.emplace_back(0.22f * std::cos(angle), 0.22f * std::sin(angle), 0.27f);
  }
  AddTube(b, "base", ring_m, 0.011f);
  for (int i = 0; i < 16; i += 4) AddTube(b, "base", {{0, 0, 0.3f}, ring_m[i]}, 0.008f);
  b.Add("seat",
        LatheMesh({0, 0, 0.61f},
                  {{0, 0}, {0.17f, 0}, {0.205f, 0.03f}, {0.2f, 0.07f}, {0.17f, 0.09f}, {0, 0.09f}},
                  28));
  AddTube(b, "base", {{0, 0, 0.605f}, {-0.24f, 0, 0.605f}, {-0.265f, 0, 0.66f}, {-0.25f, 0, 0.95f}},
          0.013f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.09f}, {0.05f, 0.34f, 0.18f}, 0.024f),
        Leaning({-0.215f, 0, 0.86f}, -0.06f));
  b.FitToSize();
}

// A racing driver's: bolsters along seat and back, shoulders, and pillows at neck and loins.
void BuildRacingSeat(FurnitureBuilder& b) {
  AddCastorFoot(b, "base", 0.34f, 0.44f);
  AddPadding(b, "seat", {-0.24f, -0.2f, 0.42f}, {0.28f, 0.2f, 0.52f}, 0.04f);
  const Rigid3d T = Leaning({-0.23f, 0, 0.48f}, -0.2f);
  b.Add("seat", RoundedBoxMesh({-0.02f, 0, 0.36f}, {0.1f, 0.4f, 0.74f}, 0.045f), T);
  b.Add("seat", RoundedBoxMesh({-0.02f, 0, 0.74f}, {0.1f, 0.28f, 0.2f}, 0.045f), T);
  b.Add("base", RoundedBoxMesh({0.045f, 0, 0.7f}, {0.07f, 0.24f, 0.13f}, 0.03f), T);
  b.Add("base", RoundedBoxMesh({0.045f, 0, 0.18f}, {0.08f, 0.3f, 0.18f}, 0.035f), T);
  for (const float y : {-1.0f, 1.0f}) {
    AddPadding(b, "base", {-0.2f, y > 0 ? 0.18f : -0.27f, 0.43f},
               {0.26f, y > 0 ? 0.27f : -0.18f, 0.57f}, 0.04f);
    b.Add("base", RoundedBoxMesh({0.03f, 0.22f * y, 0.22f}, {0.14f, 0.09f, 0.36f}, 0.04f), T);
    b.Add("base", RoundedBoxMesh({0.01f, 0.24f * y, 0.54f}, {0.12f, 0.12f, 0.26f}, 0.045f), T);
    b.Box("base", {-0.05f, 0.32f * y - 0.018f, 0.44f}, {0.01f, 0.32f * y + 0.018f, 0.66f});
    b.Box("base", {-0.06f, y > 0 ? 0.2f : -0.338f, 0.41f}, {0.02f, y > 0 ? 0.338f : -0.2f, 0.44f});
    AddPadding(b, "base", {-0.16f, 0.32f * y - 0.045f, 0.65f}, {0.13f, 0.32f * y + 0.045f, 0.685f},
               0.014f);
  }
  b.FitToSize();
}

}  // namespace

DesignTable SwivelChairDesigns() {
  return {{"office_chair",
           {{BuildRibbed, {0.64f, 0.64f, 0.96f}},
            {BuildDraftingStool, {0.6f, 0.6f, 1.06f}},
            {BuildRacingSeat, {0.72f, 0.73f, 1.3f}}}}};
}

}  // namespace semantic_slam
