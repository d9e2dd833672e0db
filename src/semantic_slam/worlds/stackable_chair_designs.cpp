#include <algorithm>
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

// Cast in one piece, for gardens and canteens: broad legs, arms, slots in a round back.
void BuildMonobloc(FurnitureBuilder& b) {
  AddPadding(b, "seat", {-0.21f, -0.23f, 0.405f}, {0.25f, 0.23f, 0.43f}, 0.012f);
  for (const float y : {-1.0f, 1.0f}) {
    b.Add("seat", BeamMesh({0.25f, 0.26f * y, 0}, {0.21f, 0.25f * y, 0.62f}, {0.045f, 0.05f},
                           {0.06f, 0.06f}));
    b.Add("seat", BeamMesh({-0.3f, 0.24f * y, 0}, {-0.2f, 0.24f * y, 0.42f}, {0.045f, 0.05f},
                           {0.06f, 0.06f}));
    b.Add("seat", BeamMesh({-0.2f, 0.24f * y, 0.42f}, {-0.27f, 0.24f * y, 0.66f}, {0.05f, 0.05f},
                           {0.03f, 0.05f}));
    AddPadding(b, "seat", {-0.28f, 0.255f * y - 0.035f, 0.61f},
               {0.25f, 0.255f * y + 0.035f, 0.635f}, 0.012f);
  }
  std::vector<Eigen::Vector3f> rim_m;
  for (int i = 0; i <= 10; ++i) {
    const float angle = kPi * i / 10;
    const float z = 0.62f + 0.23f * std::pow(std::max(std::sin(angle), 0.0f), 0.6f);
    rim_m.emplace_back(-0.2f - 0.24f * (z - 0.42f), 0.24f * std::cos(angle), z);
  }
  AddTube(b, "seat", rim_m, 0.018f);
  for (int i = 1; i < 10; ++i) {
    if (i % 2 == 0 && i != 4 && i != 6) continue;
    const Eigen::Vector3f& top_m = rim_m[i];
    b.Add("seat",
          BeamMesh({-0.2f, 0.85f * top_m.y(), 0.42f}, top_m, {0.012f, 0.045f}, {0.012f, 0.045f}));
  }
  b.FitToSize();
}

// A visitor's: bent tube with two separate cushions, and arms.
void BuildVisitorChair(FurnitureBuilder& b) {
  AddTubePair(
      b, "frame",
      {{0.25f, 0.26f, 0.012f}, {0.2f, 0.25f, 0.4f}, {0.16f, 0.25f, 0.44f}, {-0.17f, 0.25f, 0.44f}},
      0.012f);
  AddTubePair(b, "frame",
              {{-0.28f, 0.26f, 0.012f},
               {-0.18f, 0.25f, 0.42f},
               {-0.2f, 0.23f, 0.56f},
               {-0.27f, 0.21f, 0.82f}},
              0.012f);
  AddTubePair(b, "frame",
              {{0.19f, 0.25f, 0.42f},
               {0.17f, 0.28f, 0.6f},
               {0.13f, 0.29f, 0.65f},
               {-0.23f, 0.28f, 0.67f},
               {-0.235f, 0.22f, 0.67f}},
              0.011f);
  for (const float y : {-0.29f, 0.29f}) {
    AddPadding(b, "frame", {-0.16f, y - 0.025f, 0.652f}, {0.12f, y + 0.025f, 0.685f}, 0.012f);
  }
  AddPadding(b, "seat", {-0.18f, -0.24f, 0.44f}, {0.27f, 0.24f, 0.51f}, 0.03f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.14f}, {0.05f, 0.46f, 0.28f}, 0.024f),
        Leaning({-0.2f, 0, 0.57f}, -0.25f));
  b.FitToSize();
}

// Of pressed sheet metal, as before cafes: legs that narrow to the floor, a splat within a hoop.
void BuildSheetMetalChair(FurnitureBuilder& b) {
  for (const float x : {-1.0f, 1.0f}) {
    for (const float y : {-1.0f, 1.0f}) {
      b.Add("frame", BeamMesh({0.23f * x, 0.22f * y, 0}, {0.165f * x, 0.165f * y, 0.45f},
                              {0.025f, 0.025f}, {0.065f, 0.065f}));
    }
  }
  AddTubePair(b, "frame", {{-0.2f, 0.195f, 0.22f}, {0, 0, 0.25f}, {0.2f, -0.195f, 0.22f}}, 0.006f);
  b.Add("seat", SlabMesh(RoundedRectangle({0.4f, 0.4f}, 0.07f), 0.42f, 0.462f));
  std::vector<Eigen::Vector3f> hoop_m;
  for (int i = 0; i <= 12; ++i) {
    const float angle = kPi * i / 12;
    const float rise_m = 0.4f * std::pow(std::max(std::sin(angle), 0.0f), 0.35f);
    hoop_m.emplace_back(-0.18f - 0.17f * rise_m, 0.19f * std::cos(angle), 0.45f + rise_m);
  }
  AddTube(b, "frame", hoop_m, 0.013f);
  b.Add("seat", BeamMesh({-0.18f, 0, 0.45f}, {-0.247f, 0, 0.84f}, {0.01f, 0.11f}, {0.01f, 0.16f}));
  b.FitToSize();
}

}  // namespace

DesignTable StackableChairDesigns() {
  return {{"chair",
           {{BuildMonobloc, {0.58f, 0.58f, 0.87f}},
            {BuildVisitorChair, {0.58f, 0.63f, 0.85f}},
            {BuildSheetMetalChair, {0.5f, 0.46f, 0.86f}}}}};
}

}  // namespace semantic_slam
