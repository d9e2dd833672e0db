#include <cmath>
#include <vector>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/lamp_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// All are drawn at their usual size and stretched to the one asked for at the end.

constexpr float kPi = 3.14159265f;

// A bowl that is open below, from its rim at `rim_m` up.
Mesh BowlMesh(const Eigen::Vector3f& rim_m, float radius_m, float height_m) {
  constexpr int kSteps = 8;
  constexpr float kWallM = 0.004f;
  std::vector<Eigen::Vector2f> profile_m;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle = 0.5f * kPi * i / kSteps;
    profile_m.emplace_back(i == kSteps ? 0.0f : radius_m * std::cos(angle),
                           height_m * std::sin(angle));
  }
  for (int i = kSteps; i >= 0; --i) {
    const float angle = 0.5f * kPi * i / kSteps;
    profile_m.emplace_back(i == kSteps ? 0.0f : (radius_m - kWallM) * std::cos(angle),
                           (height_m - kWallM) * std::sin(angle));
  }
  profile_m.push_back(profile_m.front());
  return LatheMesh(rim_m, profile_m, 28);
}

void AddBulb(FurnitureBuilder& b, const Eigen::Vector3f& at_m, float radius_m) {
  b.Add("shade", EllipsoidMesh(at_m, Eigen::Vector3f::Constant(radius_m), 16));
}

// A long bow from a heavy foot that holds its bowl far to the front.
void BuildArcLamp(FurnitureBuilder& b) {
  b.Add("stand", CylinderMesh({-0.5f, 0, 0}, 0.16f, 0.16f, 0.05f, 28));
  std::vector<Eigen::Vector3f> bow_m{{-0.5f, 0, 0.03f}, {-0.5f, 0, 0.9f}};
  for (int i = 1; i <= 10; ++i) {
    const float angle = kPi - 0.85f * kPi * i / 10;
    bow_m.emplace_back(0.52f * std::cos(angle), 0, 0.95f + 0.9f * std::sin(angle));
  }
  AddTube(b, "stand", bow_m, 0.012f);
  const Eigen::Vector3f tip_m = bow_m.back();
  b.Add("stand", BowlMesh(tip_m - Eigen::Vector3f(0, 0, 0.16f), 0.17f, 0.16f));
  AddBulb(b, tip_m - Eigen::Vector3f(0, 0, 0.12f), 0.06f);
  b.FitToSize();
}

// A drum on three legs of wood.
void BuildTripodLamp(FurnitureBuilder& b) {
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f out = Turned(2 * kPi * i / 3).linear().col(0).cast<float>();
    const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
    AddTube(b, "stand", {0.28f * out + 0.015f * up, 0.03f * out + 1.15f * up}, 0.016f);
  }
  b.Add("stand", CylinderMesh({0, 0, 1.12f}, 0.05f, 0.05f, 0.06f, 16));
  b.Add("stand", CylinderMesh({0, 0, 1.15f}, 0.012f, 0.012f, 0.15f, 8));
  b.Add("shade", ShadeMesh({0, 0, 1.15f}, 0.24f, 0.24f, 0.32f));
  AddBulb(b, {0, 0, 1.3f}, 0.05f);
  b.FitToSize();
}

// A thin stem with a bowl that shines at the ceiling.
void BuildUplighter(FurnitureBuilder& b) {
  b.Add("stand", CylinderMesh({0, 0, 0}, 0.14f, 0.13f, 0.025f, 28));
  b.Add("stand", CylinderMesh({0, 0, 0.025f}, 0.012f, 0.012f, 1.7f, 10));
  b.Add("shade", LatheMesh({0, 0, 1.7f},
                           {{0, 0},
                            {0.05f, 0.005f},
                            {0.14f, 0.05f},
                            {0.18f, 0.11f},
                            {0.174f, 0.11f},
                            {0.13f, 0.06f},
                            {0, 0.02f}},
                           28));
  b.FitToSize();
}

// A paper lantern as high as a child, on a low foot.
void BuildColumnLamp(FurnitureBuilder& b) {
  for (const float x : {-0.13f, 0.115f}) {
    for (const float y : {-0.13f, 0.115f})
      b.Box("stand", {x, y, 0}, {x + 0.015f, y + 0.015f, 1.2f});
  }
  for (int i = 0; i < 5; ++i) {
    const float low = 0.06f + 0.27f * i;
    for (const float x : {-0.115f, 0.11f}) {
      b.Box("stand", {x, -0.115f, low}, {x + 0.006f, 0.115f, low + 0.012f});
    }
  }
  b.Box("shade", {-0.117f, -0.117f, 0.08f}, {0.117f, 0.117f, 1.18f});
  b.FitToSize();
}

// For who reads: a stem with a joint, and a small cone at its end.
void BuildReadingLamp(FurnitureBuilder& b) {
  b.Add("stand", CylinderMesh({0, 0, 0}, 0.13f, 0.12f, 0.03f, 24));
  AddTube(b, "stand", {{0, 0, 0.02f}, {0, 0, 1.25f}, {0.22f, 0, 1.42f}}, 0.01f);
  b.Add("stand", ShadeMesh({0.25f, 0, 1.28f}, 0.1f, 0.035f, 0.16f));
  AddBulb(b, {0.25f, 0, 1.34f}, 0.04f);
  b.FitToSize();
}

// A globe on a ring.
void BuildGlobeTableLamp(FurnitureBuilder& b) {
  b.Add("stand", CylinderMesh({0, 0, 0}, 0.075f, 0.06f, 0.05f, 24));
  AddBulb(b, {0, 0, 0.17f}, 0.13f);
  b.FitToSize();
}

// A mushroom: a dome over a stem that widens to the foot.
void BuildMushroomLamp(FurnitureBuilder& b) {
  b.Add(
      "stand",
      LatheMesh({0, 0, 0},
                {{0, 0}, {0.1f, 0}, {0.09f, 0.02f}, {0.035f, 0.1f}, {0.03f, 0.3f}, {0, 0.3f}}, 24));
  b.Add("shade", BowlMesh({0, 0, 0.24f}, 0.19f, 0.16f));
  b.FitToSize();
}

// A drum on a cube.
void BuildCubeTableLamp(FurnitureBuilder& b) {
  b.Box("stand", {-0.075f, -0.075f, 0}, {0.075f, 0.075f, 0.22f});
  b.Add("stand", CylinderMesh({0, 0, 0.22f}, 0.01f, 0.01f, 0.15f, 8));
  b.Add("shade", ShadeMesh({0, 0, 0.26f}, 0.16f, 0.16f, 0.2f));
  AddBulb(b, {0, 0, 0.34f}, 0.04f);
  b.FitToSize();
}

// A banker's: half a barrel across a stem.
void BuildBankersLamp(FurnitureBuilder& b) {
  b.Add("stand", CylinderMesh({0, 0, 0}, 0.09f, 0.08f, 0.02f, 24));
  AddTube(b, "stand", {{-0.02f, 0, 0.02f}, {-0.04f, 0, 0.2f}, {0, 0, 0.33f}, {0.04f, 0, 0.32f}},
          0.01f);
  for (int i = 0; i < 6; ++i) {
    const float from = kPi * i / 6, to = kPi * (i + 1) / 6;
    const auto at = [](float angle) {
      return Eigen::Vector3f(0.04f + 0.08f * std::cos(angle), 0, 0.26f + 0.07f * std::sin(angle));
    };
    const Eigen::Vector3f middle = 0.5f * (at(from) + at(to));
    const Eigen::Vector3f along = at(to) - at(from);
    b.Add("shade", BoxMesh({0, 0, 0}, {along.norm() + 0.004f, 0.28f, 0.006f}),
          Leaning(middle, std::atan2(-along.z(), along.x())));
  }
  b.FitToSize();
}

// A flat bar on two arms.
void BuildBarDeskLamp(FurnitureBuilder& b) {
  b.Box("stand", {-0.24f, -0.08f, 0}, {-0.08f, 0.08f, 0.015f});
  AddTube(b, "stand", {{-0.2f, 0, 0.01f}, {-0.2f, 0, 0.38f}, {0.0f, 0, 0.42f}}, 0.009f);
  b.Box("stand", {-0.02f, -0.022f, 0.41f}, {0.3f, 0.022f, 0.425f});
  b.Box("shade", {0.0f, -0.018f, 0.405f}, {0.29f, 0.018f, 0.41f});
  b.FitToSize();
}

void AddCord(FurnitureBuilder& b, float low_m, float high_m) {
  b.Add("stand", CylinderMesh({0, 0, low_m}, 0.005f, 0.005f, high_m - low_m - 0.02f, 8));
  b.Add("stand", CylinderMesh({0, 0, high_m - 0.02f}, 0.05f, 0.05f, 0.02f, 16));
}

// A globe of milky glass.
void BuildGlobePendant(FurnitureBuilder& b) {
  AddBulb(b, {0, 0, 0.17f}, 0.17f);
  b.Add("stand", CylinderMesh({0, 0, 0.32f}, 0.03f, 0.03f, 0.04f, 12));
  AddCord(b, 0.35f, 0.9f);
  b.FitToSize();
  AddLightBelow(b, 0.3f);
}

// A bell of metal, as in a workshop.
void BuildBellPendant(FurnitureBuilder& b) {
  b.Add("stand", BowlMesh({0, 0, 0}, 0.22f, 0.2f));
  b.Add("stand", CylinderMesh({0, 0, 0.19f}, 0.04f, 0.03f, 0.07f, 12));
  AddBulb(b, {0, 0, 0.07f}, 0.06f);
  AddCord(b, 0.25f, 0.9f);
  b.FitToSize();
  AddLightBelow(b, 0.35f);
}

// A long bar on two wires, above a table.
void BuildBarPendant(FurnitureBuilder& b) {
  b.Box("stand", {-0.03f, -0.55f, 0.015f}, {0.03f, 0.55f, 0.05f});
  b.Box("shade", {-0.025f, -0.54f, 0}, {0.025f, 0.54f, 0.015f});
  AddTubePair(b, "stand", {{0, 0.4f, 0.04f}, {0, 0.4f, 0.78f}}, 0.003f);
  b.Box("stand", {-0.03f, -0.45f, 0.77f}, {0.03f, 0.45f, 0.8f});
  b.FitToSize();
  AddLightBelow(b, 0.4f);
}

// A bar with three spots that look aside.
void BuildSpotBar(FurnitureBuilder& b) {
  b.Box("stand", {-0.03f, -0.35f, 0.16f}, {0.03f, 0.35f, 0.19f});
  for (int i = -1; i <= 1; ++i) {
    const Rigid3d T = Leaning({0, 0.26f * i, 0.1f}, 0.5f);
    b.Add("stand", CylinderMesh({0, 0, -0.06f}, 0.045f, 0.035f, 0.12f, 16), T);
    b.Add("shade", CylinderMesh({0, 0, -0.066f}, 0.04f, 0.04f, 0.006f, 16), T);
    b.Add("stand", CylinderMesh({0, 0.26f * i, 0.12f}, 0.01f, 0.01f, 0.05f, 8));
  }
  b.FitToSize();
  AddLightBelow(b, 0.4f);
}

// A square box with rounded edges.
void BuildSquareCeilingLamp(FurnitureBuilder& b) {
  AddPadding(b, "shade", {-0.2f, -0.2f, 0}, {0.2f, 0.2f, 0.08f}, 0.025f);
  b.Box("stand", {-0.21f, -0.21f, 0.07f}, {0.21f, 0.21f, 0.09f});
  b.FitToSize();
  AddLightBelow(b, 0.4f);
}

// A ring that shines below a small disc.
void BuildRingCeilingLamp(FurnitureBuilder& b) {
  b.Add("shade", LatheMesh({0, 0, 0},
                           {{0.2f, 0}, {0.26f, 0}, {0.26f, 0.05f}, {0.2f, 0.05f}, {0.2f, 0}}, 36));
  b.Add("stand", CylinderMesh({0, 0, 0.1f}, 0.08f, 0.08f, 0.03f, 24));
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f out = Turned(2 * kPi * i / 3).linear().col(0).cast<float>();
    AddTube(
        b, "stand",
        {0.23f * out + Eigen::Vector3f(0, 0, 0.045f), 0.05f * out + Eigen::Vector3f(0, 0, 0.11f)},
        0.005f);
  }
  b.FitToSize();
  AddLightBelow(b, 0.4f);
}

}  // namespace

DesignTable LampDesigns() {
  return {{"floor_lamp",
           {{BuildTripodLamp, {0.56f, 0.56f, 1.5f}},
            {BuildUplighter, {0.36f, 0.36f, 1.8f}},
            {BuildReadingLamp, {0.48f, 0.26f, 1.45f}},
            {BuildArcLamp, {1.3f, 0.34f, 1.9f}},
            {BuildColumnLamp, {0.26f, 0.26f, 1.2f}}}},
          {"table_lamp",
           {{BuildMushroomLamp, {0.36f, 0.36f, 0.4f}},
            {BuildCubeTableLamp, {0.32f, 0.32f, 0.46f}},
            {BuildGlobeTableLamp, {0.26f, 0.26f, 0.3f}}}},
          {"desk_lamp",
           {{BuildBarDeskLamp, {0.54f, 0.16f, 0.44f}}, {BuildBankersLamp, {0.22f, 0.28f, 0.36f}}}},
          {"pendant_lamp",
           {{BuildBellPendant, {0.44f, 0.44f, 0.9f}},
            {BuildBarPendant, {0.06f, 1.1f, 0.8f}},
            {BuildGlobePendant, {0.34f, 0.34f, 0.9f}}}},
          {"ceiling_lamp",
           {{BuildSquareCeilingLamp, {0.42f, 0.42f, 0.09f}},
            {BuildSpotBar, {0.16f, 0.7f, 0.2f}},
            {BuildRingCeilingLamp, {0.52f, 0.52f, 0.13f}}}}};
}

}  // namespace semantic_slam
