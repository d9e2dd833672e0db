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

// Round posts, rungs between them as on a ladder, and a woven seat.
void BuildLadderBack(FurnitureBuilder& b) {
  AddTubePair(b, "frame", {{0.2f, 0.2f, 0.02f}, {0.2f, 0.2f, 0.47f}}, 0.018f);
  AddTubePair(b, "frame", {{-0.2f, 0.19f, 0.02f}, {-0.2f, 0.19f, 0.45f}, {-0.26f, 0.19f, 1.0f}},
              0.018f);
  for (const float z : {0.14f, 0.28f}) {
    AddTubePair(b, "frame", {{-0.2f, 0.19f, z}, {0.2f, 0.2f, z}}, 0.01f);
    AddTube(b, "frame", {{0.2f, -0.2f, z + 0.05f}, {0.2f, 0.2f, z + 0.05f}}, 0.01f);
  }
  for (int i = 0; i < 4; ++i) {
    const float z = 0.56f + 0.115f * i;
    const float x = -0.2f - 0.06f * (z - 0.45f) / 0.55f;
    b.Add("frame",
          BeamMesh({x, 0, z}, {x - 0.006f, 0, z + 0.055f}, {0.014f, 0.37f}, {0.014f, 0.34f}));
  }
  AddPadding(b, "seat", {-0.21f, -0.2f, 0.435f}, {0.215f, 0.2f, 0.465f}, 0.014f);
  b.FitToSize();
}

// A Windsor chair: a slab on splayed legs, with a bow and spindles for its back.
void BuildSpindleBack(FurnitureBuilder& b) {
  AddSplayedLegs(b, "frame", {0.46f, 0.46f}, {0.3f, 0.3f}, 0.43f, 0.016f);
  AddTubePair(b, "frame", {{-0.19f, 0.19f, 0.2f}, {0.19f, 0.19f, 0.2f}}, 0.01f);
  AddTube(b, "frame", {{0, -0.19f, 0.2f}, {0, 0.19f, 0.2f}}, 0.01f);
  b.Add("seat", SlabMesh(RoundedRectangle({0.42f, 0.44f}, 0.14f), 0.43f, 0.465f));
  std::vector<Eigen::Vector3f> bow_m;
  for (int i = 0; i <= 10; ++i) {
    const float angle = kPi * i / 10;
    const float rise_m = 0.46f * std::pow(std::max(std::sin(angle), 0.0f), 0.6f);
    bow_m.emplace_back(-0.16f - 0.2f * rise_m, 0.2f * std::cos(angle), 0.46f + rise_m);
  }
  AddTube(b, "frame", bow_m, 0.012f);
  for (int i = 2; i <= 8; ++i) {
    AddTube(b, "frame", {{-0.16f, 0.8f * bow_m[i].y(), 0.46f}, bow_m[i]}, 0.006f);
  }
  b.FitToSize();
}

// The middle line (x, z) of a moulded seat and back.
std::vector<Eigen::Vector2f> ShellProfile() {
  return {{0.24f, 0.42f},  {0.2f, 0.45f},    {0.08f, 0.44f},   {-0.06f, 0.43f}, {-0.14f, 0.45f},
          {-0.19f, 0.52f}, {-0.215f, 0.62f}, {-0.235f, 0.72f}, {-0.26f, 0.82f}};
}

// A moulded shell on four splayed wooden legs.
void BuildShellOnLegs(FurnitureBuilder& b) {
  AddShell(b, "seat", ShellProfile(), 0.47f, 0.05f);
  AddSplayedLegs(b, "frame", {0.44f, 0.44f}, {0.22f, 0.2f}, 0.425f, 0.014f);
  AddTubePair(b, "frame", {{-0.17f, 0.16f, 0.22f}, {0.17f, -0.16f, 0.22f}}, 0.005f);
  b.FitToSize();
}

// A moulded shell on two runners of wire.
void BuildShellOnSled(FurnitureBuilder& b) {
  AddShell(b, "seat", ShellProfile(), 0.46f, 0.035f);
  AddTubePair(b, "frame",
              {{0.12f, 0.14f, 0.425f},
               {0.22f, 0.22f, 0.012f},
               {-0.22f, 0.22f, 0.012f},
               {-0.1f, 0.14f, 0.415f},
               {0.12f, 0.14f, 0.425f}},
              0.009f);
  AddTube(b, "frame", {{0.12f, -0.14f, 0.425f}, {0.12f, 0.14f, 0.425f}}, 0.009f);
  AddTube(b, "frame", {{-0.1f, -0.14f, 0.415f}, {-0.1f, 0.14f, 0.415f}}, 0.009f);
  b.FitToSize();
}

// A bent tube that carries its seat from the front alone.
void BuildCantilever(FurnitureBuilder& b) {
  AddTubePair(b, "frame",
              {{-0.25f, 0.22f, 0.86f},
               {-0.19f, 0.22f, 0.46f},
               {0.24f, 0.22f, 0.44f},
               {0.26f, 0.22f, 0.41f},
               {0.24f, 0.22f, 0.03f},
               {0.21f, 0.22f, 0.013f},
               {-0.23f, 0.22f, 0.013f}},
              0.013f);
  AddTube(b, "frame", {{-0.23f, -0.22f, 0.013f}, {-0.23f, 0.22f, 0.013f}}, 0.013f);
  AddPadding(b, "seat", {-0.2f, -0.21f, 0.44f}, {0.23f, 0.21f, 0.475f}, 0.015f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.17f}, {0.03f, 0.42f, 0.34f}, 0.013f),
        Leaning({-0.195f, 0, 0.52f}, -0.15f));
  b.FitToSize();
}

// Two frames that cross; a thin seat, and a board to lean on.
void BuildFoldingChair(FurnitureBuilder& b) {
  AddTubePair(b, "frame", {{0.22f, 0.2f, 0.01f}, {-0.24f, 0.2f, 0.82f}}, 0.011f);
  AddTubePair(b, "frame", {{-0.24f, 0.175f, 0.01f}, {0.14f, 0.175f, 0.44f}}, 0.011f);
  AddTube(b, "frame", {{0.18f, -0.2f, 0.08f}, {0.18f, 0.2f, 0.08f}}, 0.009f);
  AddTube(b, "frame", {{-0.18f, -0.175f, 0.08f}, {-0.18f, 0.175f, 0.08f}}, 0.009f);
  AddPadding(b, "seat", {-0.17f, -0.19f, 0.44f}, {0.22f, 0.19f, 0.462f}, 0.01f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.08f}, {0.018f, 0.42f, 0.17f}, 0.008f),
        Leaning({-0.155f, 0, 0.65f}, -0.52f));
  b.FitToSize();
}

// Bent wood, as in a coffee house: a round seat, and a hoop in a hoop for its back.
void BuildBentwood(FurnitureBuilder& b) {
  AddSplayedLegs(b, "frame", {0.42f, 0.4f}, {0.3f, 0.3f}, 0.44f, 0.015f);
  b.Add("frame", CylinderMesh({0, 0, 0.42f}, 0.2f, 0.205f, 0.03f, 24));
  b.Add("seat", CylinderMesh({0, 0, 0.45f}, 0.2f, 0.19f, 0.018f, 24));
  for (const float scale : {1.0f, 0.6f}) {
    std::vector<Eigen::Vector3f> hoop_m;
    for (int i = 0; i <= 10; ++i) {
      const float angle = kPi * i / 10;
      const float rise_m = scale * 0.43f * std::pow(std::max(std::sin(angle), 0.0f), 0.7f);
      hoop_m.emplace_back(-0.17f - 0.16f * rise_m, scale * 0.18f * std::cos(angle), 0.45f + rise_m);
    }
    AddTube(b, "frame", hoop_m, 0.012f);
  }
  std::vector<Eigen::Vector3f> ring_m;
  for (int i = 0; i <= 12; ++i) {
    const float angle = 2 * kPi * i / 12;
    ring_m.emplace_back(0.17f * std::cos(angle), 0.165f * std::sin(angle), 0.2f);
  }
  AddTube(b, "frame", ring_m, 0.008f);
  b.FitToSize();
}

// Wholly upholstered, with a high straight back.
void BuildUpholstered(FurnitureBuilder& b) {
  AddLegs(b, "frame", 0.5f, 0.44f, 0.36f, 0.045f);
  AddPadding(b, "seat", {-0.26f, -0.23f, 0.34f}, {0.26f, 0.23f, 0.49f}, 0.03f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.31f}, {0.085f, 0.46f, 0.62f}, 0.03f),
        Leaning({-0.22f, 0, 0.42f}, -0.12f));
  b.FitToSize();
}

// A tub: a round seat in a low back that comes around to its sides.
void BuildTubChair(FurnitureBuilder& b) {
  AddSplayedLegs(b, "frame", {0.5f, 0.5f}, {0.36f, 0.36f}, 0.42f, 0.015f);
  b.Add("seat", LatheMesh({0.02f, 0, 0.39f},
                          {{0, 0}, {0.22f, 0}, {0.25f, 0.04f}, {0.24f, 0.09f}, {0, 0.1f}}, 24));
  constexpr int kStaves = 17;
  for (int i = 0; i < kStaves; ++i) {
    const float angle = kPi * (0.52f + 0.96f * i / (kStaves - 1));
    const float rise_m = 0.24f - 0.08f * std::cos(angle);  // highest at the rear
    const Mesh stave =
        RoundedBoxMesh({0.26f, 0, 0.41f + 0.5f * rise_m}, {0.05f, 0.085f, rise_m}, 0.02f);
    b.Add("seat", stave, Turned(angle));
  }
  b.FitToSize();
}

// A shell on the four-armed foot of a meeting room's chair.
void BuildShellOnStar(FurnitureBuilder& b) {
  AddShell(b, "seat", ShellProfile(), 0.5f, 0.09f);
  AddStarFoot(b, "frame", 4, 0.3f, 0.43f);
  b.FitToSize();
}

}  // namespace

DesignTable ChairDesigns() {
  return {{"chair",
           {{BuildLadderBack, {0.5f, 0.44f, 1.0f}},
            {BuildShellOnLegs, {0.54f, 0.47f, 0.83f}},
            {BuildCantilever, {0.54f, 0.47f, 0.86f}},
            {BuildUpholstered, {0.56f, 0.46f, 1.03f}},
            {BuildBentwood, {0.45f, 0.42f, 0.88f}},
            {BuildFoldingChair, {0.5f, 0.44f, 0.82f}},
            {BuildSpindleBack, {0.5f, 0.48f, 0.93f}},
            {BuildShellOnStar, {0.56f, 0.56f, 0.84f}},
            {BuildTubChair, {0.56f, 0.6f, 0.73f}},
            {BuildShellOnSled, {0.54f, 0.48f, 0.82f}}}}};
}

}  // namespace semantic_slam
