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

// A back that swells to a hump in its middle, scrolls for arms, and legs of wood to be seen.
void BuildCamelback(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  AddLegs(b, "legs", b.depth() - 0.12f, b.width() - 0.12f, 0.22f, 0.055f);
  for (const float x : {rear + 0.09f, -rear - 0.09f}) {
    b.Box("legs", {x - 0.012f, -side + 0.09f, 0.08f}, {x + 0.012f, side - 0.09f, 0.11f});
  }
  AddPadding(b, "cover", {rear + 0.04f, -side + 0.04f, 0.2f}, {-rear - 0.03f, side - 0.04f, 0.33f},
             0.03f);
  AddPadding(b, "cushions", {rear + 0.14f, -side + 0.16f, 0.31f}, {-rear, side - 0.16f, 0.46f},
             0.06f);
  const int staves = std::max(8, static_cast<int>(std::lround(b.width() / 0.09f)));
  const float each_m = (b.width() - 0.12f) / staves;
  for (int i = 0; i < staves; ++i) {
    const float share = (i + 0.5f) / staves;
    const float hump = 0.5f - 0.5f * std::cos(2 * kPi * share);
    const float y = -side + 0.06f + (i + 0.5f) * each_m;
    b.Add("cover",
          RoundedBoxMesh({0, y, 0.24f + 0.11f * hump}, {0.12f, 1.7f * each_m, 0.48f + 0.22f * hump},
                         0.05f),
          Leaning({rear + 0.13f, 0, 0.24f}, -0.12f));
  }
  for (const float y : {-side + 0.1f, side - 0.1f}) {
    AddPadding(b, "cover", {rear + 0.08f, y - 0.05f, 0.22f}, {-rear - 0.06f, y + 0.05f, 0.62f},
               0.04f);
    b.Add("cover", LimbMesh({rear + 0.1f, y, 0.62f}, {-rear - 0.1f, y, 0.6f}, 0.08f, 0.085f, 16));
  }
  b.FitToSize();
}

// A thin mattress, folded over a frame of tube: a bed at night.
void BuildFuton(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float arm = side - 0.02f;
  AddTubePair(b, "legs",
              {{rear + 0.1f, arm, 0.02f},
               {rear + 0.14f, arm, 0.55f},
               {rear + 0.2f, arm, 0.6f},
               {-rear - 0.14f, arm, 0.6f},
               {-rear - 0.08f, arm, 0.55f},
               {-rear - 0.04f, arm, 0.02f}},
              0.02f);
  for (const float z : {0.2f, 0.33f, 0.46f}) {
    AddTubePair(b, "legs", {{rear + 0.12f, arm, z}, {-rear - 0.05f, arm, z}}, 0.011f);
  }
  for (const float x : {rear + 0.16f, -rear - 0.06f}) {
    AddTube(b, "legs", {{x, -arm, 0.24f}, {x, arm, 0.24f}}, 0.016f);
  }
  const float whole_m = b.width() - 0.12f;
  const float deep_m = b.depth() - 0.24f;
  b.Add("cushions", RoundedBoxMesh({0.5f * deep_m, 0, 0.075f}, {deep_m, whole_m, 0.15f}, 0.06f),
        Leaning({rear + 0.22f, 0, 0.25f}, -0.06f));
  const Rigid3d T_back = Leaning({rear + 0.17f, 0, 0.3f}, -0.3f);
  b.Add("cushions", RoundedBoxMesh({0.075f, 0, 0.29f}, {0.15f, whole_m, 0.58f}, 0.06f), T_back);
  for (int i = 0; i <= 6; ++i) {  // bars behind the back, and one across them
    const float y = 0.96f * whole_m * (i / 6.0f - 0.5f);
    b.Add("legs", RoundedBoxMesh({0, y, 0.22f}, {0.02f, 0.025f, 0.52f}, 0.009f), T_back);
  }
  b.Add("legs", RoundedBoxMesh({0, 0, 0.48f}, {0.025f, whole_m, 0.04f}, 0.012f), T_back);
  b.FitToSize();
}

// Bent like a bean about those who sit there, down to the floor.
void BuildCurvedSofa(FurnitureBuilder& b) {
  constexpr int kPieces = 11;
  constexpr float kRadiusM = 1.75f;  // of the back's outside, about a place in front
  constexpr float kReachRad = 0.75f;
  const float width_m = 2.2f * kRadiusM * kReachRad / kPieces;  // they overlap at the front
  for (int i = 0; i < kPieces; ++i) {
    const float share = 2.0f * i / (kPieces - 1) - 1.0f;
    Rigid3d T = Rigid3d(Eigen::Translation3d(kRadiusM, 0, 0));
    T.rotate(Eigen::AngleAxisd(share * kReachRad, Eigen::Vector3d::UnitZ()));
    const float end = share * share * share * share;  // where the back becomes an arm
    const float rise_m = 0.36f - 0.1f * end;
    const Eigen::Vector3f rear(-kRadiusM, 0, 0);
    b.Add("legs", BoxMesh(rear + Eigen::Vector3f(0.44f, 0, 0.025f), {0.6f, width_m, 0.05f}), T);
    b.Add("cover",
          RoundedBoxMesh(rear + Eigen::Vector3f(0.44f, 0, 0.15f), {0.86f, width_m, 0.22f}, 0.05f),
          T);
    b.Add("cushions",
          RoundedBoxMesh(rear + Eigen::Vector3f(0.52f, 0, 0.33f), {0.76f, width_m, 0.18f}, 0.07f),
          T);
    b.Add("cover",
          RoundedBoxMesh(rear + Eigen::Vector3f(0.12f, 0, 0.36f + 0.5f * rise_m),
                         {0.24f, width_m, rise_m + 0.1f}, 0.1f),
          T);
  }
  b.FitToSize();
}

// For offices: walls to the head on three sides, to be undisturbed.
void BuildBoothSofa(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  constexpr float kWallM = 0.07f;
  for (const float y : {-side + 0.12f, side - 0.12f}) {
    AddTube(b, "legs",
            {{rear + 0.08f, y, 0.18f},
             {rear + 0.08f, y, 0.012f},
             {-rear - 0.08f, y, 0.012f},
             {-rear - 0.08f, y, 0.18f}},
            0.012f);
  }
  AddPadding(b, "cover", {rear, -side, 0.16f}, {rear + kWallM, side, b.height()}, 0.025f);
  for (const float y : {-side, side - kWallM}) {
    AddPadding(b, "cover", {rear, y, 0.16f}, {-rear - 0.04f, y + kWallM, b.height()}, 0.025f);
  }
  const float inner = side - kWallM;
  AddPadding(b, "cover", {rear + kWallM, -inner, 0.17f}, {-rear - 0.02f, inner, 0.31f}, 0.02f);
  const int seats = std::max(2, static_cast<int>(std::lround(2 * inner / 0.7f)));
  for (int i = 0; i < seats; ++i) {
    const float right = -inner + 2 * inner * i / seats + 0.003f;
    const float left = -inner + 2 * inner * (i + 1) / seats - 0.003f;
    AddPadding(b, "cushions", {rear + kWallM, right, 0.3f}, {-rear, left, 0.45f}, 0.04f);
    AddPadding(b, "cushions", {rear + kWallM, right, 0.44f}, {rear + kWallM + 0.14f, left, 0.82f},
               0.05f);
  }
  b.FitToSize();
}

}  // namespace

DesignTable CouchDesigns() {
  return {{"sofa",
           {{BuildCamelback, {0.84f, 2.0f, 0.92f}},
            {BuildFuton, {0.95f, 2.0f, 0.84f}},
            {BuildCurvedSofa, {1.35f, 2.7f, 0.74f}},
            {BuildBoothSofa, {0.82f, 1.7f, 1.34f}}}}};
}

}  // namespace semantic_slam
