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

constexpr float kPi = 3.14159265f;

// Cushions to sit on and to lean on, side by side between two places (y); the latter lean back.
struct CushionRow {
  float right_m;
  float left_m;
  float rear_m;
  float front_m;
  float seat_low_m;
  float seat_high_m;
  float back_high_m;
};

void AddCushions(FurnitureBuilder& b, const CushionRow& row) {
  constexpr float kUsualM = 0.68f;  // width of one
  const float whole_m = row.left_m - row.right_m;
  const int count = std::max(1, static_cast<int>(std::lround(whole_m / kUsualM)));
  for (int i = 0; i < count; ++i) {
    const float right = row.right_m + i * whole_m / count + 0.004f;
    const float left = row.right_m + (i + 1) * whole_m / count - 0.004f;
    AddPadding(b, "cushions", {row.rear_m, right, row.seat_low_m},
               {row.front_m, left, row.seat_high_m}, 0.045f);
    const float rise_m = row.back_high_m - row.seat_high_m + 0.02f;
    b.Add("cushions",
          RoundedBoxMesh({0.08f, 0.5f * (right + left), 0.5f * rise_m},
                         {0.17f, left - right - 0.02f, rise_m}, 0.07f),
          Leaning({row.rear_m, 0, row.seat_high_m - 0.02f}, -0.12f));
  }
}

// An L: its right end reaches far to the front, to lie on.
void BuildChaise(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  const float chaise_m = std::min(0.95f, 0.4f * b.width());
  const float front = rear + std::min(0.95f, 0.65f * b.depth());
  AddPadding(b, "cover", {rear, -side, 0.05f}, {front, side, 0.28f}, 0.02f);
  AddPadding(b, "cover", {front - 0.06f, -side, 0.05f}, {-rear, -side + chaise_m, 0.28f}, 0.02f);
  AddPadding(b, "cover", {rear, -side, 0.27f}, {rear + 0.2f, side, b.height() - 0.08f}, 0.05f);
  AddPadding(b, "cover", {rear + 0.02f, side - 0.2f, 0.27f}, {front, side, 0.6f}, 0.05f);
  AddPadding(b, "cover", {rear + 0.02f, -side, 0.27f}, {front - 0.1f, -side + 0.16f, 0.6f}, 0.05f);
  AddPadding(b, "cushions", {rear + 0.18f, -side + 0.16f, 0.28f},
             {-rear - 0.01f, -side + chaise_m, 0.43f}, 0.045f);
  b.Add("cushions",
        RoundedBoxMesh({0.08f, -side + 0.5f * (chaise_m + 0.16f), 0.19f},
                       {0.17f, chaise_m - 0.2f, 0.4f}, 0.07f),
        Leaning({rear + 0.2f, 0, 0.41f}, -0.12f));
  AddCushions(b, {-side + chaise_m, side - 0.2f, rear + 0.18f, front + 0.01f, 0.28f, 0.43f,
                  b.height() - 0.02f});
  for (const auto& [x, y] : {std::pair(rear + 0.08f, -side + 0.08f),
                             {rear + 0.08f, side - 0.08f},
                             {front - 0.08f, side - 0.08f},
                             {-rear - 0.08f, -side + 0.08f},
                             {-rear - 0.08f, -side + chaise_m - 0.08f}}) {
    b.Add("legs", CylinderMesh({x, y, 0}, 0.025f, 0.03f, 0.06f, 10));
  }
  b.FitToSize();
}

// Low blocks on the floor, one of them without a back.
void BuildModularSofa(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  const int blocks = std::max(2, static_cast<int>(std::lround(b.width() / 0.85f)));
  const float each_m = b.width() / blocks;
  AddLegs(b, "legs", b.depth() - 0.2f, b.width() - 0.2f, 0.05f, 0.08f);
  for (int i = 0; i < blocks; ++i) {
    const float right = -side + i * each_m + 0.004f;
    const float left = right + each_m - 0.008f;
    AddPadding(b, "cover", {rear, right, 0.03f}, {-rear, left, 0.22f}, 0.04f);
    AddPadding(b, "cushions", {rear + 0.01f, right, 0.2f}, {-rear, left, 0.4f}, 0.08f);
    if (i == 0) continue;
    AddPadding(b, "cushions", {rear, right, 0.36f}, {rear + 0.28f, left, 0.66f}, 0.1f);
  }
  AddPadding(b, "cushions", {rear + 0.1f, side - 0.24f, 0.36f}, {-rear - 0.05f, side, 0.56f},
             0.09f);
  b.FitToSize();
}

// Arms and back of one height that roll outwards, on turned feet.
void BuildRolledArmSofa(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  constexpr float kRollM = 0.11f;
  const float arm_m = std::min(0.2f, 0.2f * b.width());
  for (const float x : {rear + 0.12f, -rear - 0.12f}) {
    for (const float y : {-side + 0.14f, side - 0.14f}) {
      b.Add("legs", EllipsoidMesh({x, y, 0.06f}, {0.04f, 0.04f, 0.06f}, 10));
    }
  }
  AddPadding(b, "cover", {rear + 0.08f, -side + 0.06f, 0.09f}, {-rear - 0.04f, side - 0.06f, 0.3f},
             0.03f);
  const float roll = 0.76f - kRollM;
  for (const float y : {-1.0f, 1.0f}) {
    const float inner = y * (side - arm_m), outer = y * (side - 0.05f);
    AddPadding(b, "cover", {rear + 0.1f, std::min(inner, outer), 0.1f},
               {-rear - 0.03f, std::max(inner, outer), roll}, 0.03f);
    b.Add("cover", LimbMesh({rear + kRollM, y * (side - kRollM), roll},
                            {-rear - 0.05f, y * (side - kRollM), roll}, kRollM, 0.9f * kRollM, 16));
  }
  AddPadding(b, "cover", {rear + 0.08f, -side + 0.06f, 0.1f}, {rear + 0.24f, side - 0.06f, roll},
             0.03f);
  b.Add("cover", LimbMesh({rear + kRollM, -side + kRollM, roll},
                          {rear + kRollM, side - kRollM, roll}, kRollM, kRollM, 16));
  AddPadding(b, "cushions", {rear + 0.2f, -side + arm_m, 0.28f}, {-rear, side - arm_m, 0.45f},
             0.06f);
  for (int row = 0; row < 2; ++row) {  // buttons of the tufted back
    for (float y = -side + arm_m + 0.1f + 0.08f * row; y < side - arm_m - 0.05f; y += 0.16f) {
      b.Add("cushions",
            EllipsoidMesh({rear + 0.24f, y, 0.52f + 0.09f * row}, {0.012f, 0.02f, 0.02f}, 8));
    }
  }
  b.FitToSize();
}

// A frame of wood with slats below its arms; all cushions are loose.
void BuildWoodenFramed(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  constexpr float kBarM = 0.05f;
  for (const float y : {-side + 0.5f * kBarM, side - 0.5f * kBarM}) {
    const Eigen::Vector2f bar(kBarM, kBarM);
    b.Add("legs", BeamMesh({-rear - 0.06f, y, 0}, {-rear - 0.04f, y, 0.6f}, 0.7f * bar, bar));
    b.Add("legs", BeamMesh({rear + 0.14f, y, 0}, {rear + 0.08f, y, 0.6f}, 0.7f * bar, bar));
    b.Box("legs", {rear, y - 0.04f, 0.6f}, {-rear, y + 0.04f, 0.63f});
    b.Box("legs", {rear + 0.12f, y - 0.02f, 0.25f}, {-rear - 0.06f, y + 0.02f, 0.31f});
    for (float x = rear + 0.24f; x < -rear - 0.1f; x += 0.13f) {
      b.Box("legs", {x, y - 0.008f, 0.31f}, {x + 0.03f, y + 0.008f, 0.6f});
    }
  }
  b.Box("legs", {-rear - 0.09f, -side + kBarM, 0.25f}, {-rear - 0.06f, side - kBarM, 0.31f});
  b.Box("legs", {rear + 0.12f, -side + kBarM, 0.25f}, {rear + 0.15f, side - kBarM, 0.31f});
  b.Box("cover", {rear + 0.15f, -side + kBarM, 0.27f}, {-rear - 0.09f, side - kBarM, 0.3f});
  b.Box("legs", {rear, -side + 0.02f, b.height() - 0.14f},
        {rear + 0.03f, side - 0.02f, b.height() - 0.09f});
  for (const float y : {-side + 0.06f, side - 0.06f}) {
    b.Add("legs", BeamMesh({rear + 0.1f, y, 0.3f}, {rear + 0.015f, y, b.height() - 0.09f},
                           {0.04f, 0.04f}, {0.03f, 0.04f}));
  }
  AddCushions(b, {-side + 0.07f, side - 0.07f, rear + 0.14f, -rear - 0.02f, 0.3f, 0.44f,
                  b.height() - 0.01f});
  b.FitToSize();
}

// Slender: thin arms, high thin legs, and a back of loose pillows.
void BuildLooseBackSofa(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  AddSplayedLegs(b, "legs", {b.depth() - 0.06f, b.width() - 0.1f},
                 {b.depth() - 0.2f, b.width() - 0.26f}, 0.2f, 0.016f);
  AddPadding(b, "cover", {rear + 0.03f, -side, 0.2f}, {-rear, side, 0.3f}, 0.02f);
  AddPadding(b, "cover", {rear, -side, 0.2f}, {rear + 0.1f, side, 0.66f}, 0.03f);
  for (const float y : {-side, side - 0.08f}) {
    AddPadding(b, "cover", {rear + 0.04f, y, 0.2f}, {-rear - 0.02f, y + 0.08f, 0.56f}, 0.03f);
  }
  AddPadding(b, "cushions", {rear + 0.09f, -side + 0.08f, 0.29f},
             {-rear - 0.01f, side - 0.08f, 0.43f}, 0.05f);
  const int pillows = std::max(2, static_cast<int>(std::lround(b.width() / 0.55f)));
  const float each_m = (b.width() - 0.18f) / pillows;
  for (int i = 0; i < pillows; ++i) {
    const float y = -side + 0.09f + (i + 0.5f) * each_m;
    b.Add("cushions", PillowMesh(Eigen::Vector3f::Zero(), {0.46f, 1.08f * each_m, 0.2f}),
          Leaning({rear + 0.2f, y, 0.62f}, kPi / 2 - 0.25f));
  }
  b.FitToSize();
}

// A corner: two wings at a right angle, along the back and along the right.
void BuildCornerSofa(FurnitureBuilder& b) {
  const float rear = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  constexpr float kDeepM = 0.92f;
  for (const auto& [x, y] : {std::pair(rear + 0.08f, -side + 0.08f),
                             {rear + 0.08f, side - 0.08f},
                             {rear + kDeepM - 0.08f, side - 0.08f},
                             {-rear - 0.08f, -side + 0.08f},
                             {-rear - 0.08f, -side + kDeepM - 0.08f}}) {
    b.Add("legs", CylinderMesh({x, y, 0}, 0.02f, 0.028f, 0.09f, 10));
  }
  AddPadding(b, "cover", {rear, -side, 0.08f}, {rear + kDeepM, side, 0.29f}, 0.02f);
  AddPadding(b, "cover", {rear + kDeepM - 0.04f, -side, 0.08f}, {-rear, -side + kDeepM, 0.29f},
             0.02f);
  AddPadding(b, "cover", {rear, -side, 0.28f}, {rear + 0.22f, side, 0.74f}, 0.06f);
  AddPadding(b, "cover", {rear + 0.1f, -side, 0.28f}, {-rear, -side + 0.22f, 0.74f}, 0.06f);
  AddPadding(b, "cover", {rear + 0.02f, side - 0.2f, 0.28f}, {rear + kDeepM, side, 0.6f}, 0.06f);
  AddCushions(b, {-side + kDeepM, side - 0.2f, rear + 0.2f, rear + kDeepM, 0.28f, 0.43f, 0.84f});
  const int count = std::max(1, static_cast<int>(std::lround((b.depth() - kDeepM) / 0.6f)));
  const float each_m = (b.depth() - kDeepM) / count;
  AddPadding(b, "cushions", {rear + 0.2f, -side + 0.2f, 0.28f},
             {rear + kDeepM, -side + kDeepM, 0.43f}, 0.045f);
  for (int i = 0; i < count; ++i) {
    const float near = rear + kDeepM + i * each_m;
    AddPadding(b, "cushions", {near, -side + 0.2f, 0.28f},
               {near + each_m - 0.006f, -side + kDeepM, 0.43f}, 0.045f);
    AddPadding(b, "cushions", {near + 0.01f, -side + 0.14f, 0.42f},
               {near + each_m - 0.02f, -side + 0.34f, 0.82f}, 0.07f);
  }
  b.FitToSize();
}

}  // namespace

DesignTable SofaDesigns() {
  return {{"sofa",
           {{BuildChaise, {1.6f, 2.5f, 0.82f}},
            {BuildRolledArmSofa, {0.95f, 2.1f, 0.76f}},
            {BuildWoodenFramed, {0.82f, 1.9f, 0.8f}},
            {BuildCornerSofa, {1.9f, 2.4f, 0.84f}},
            {BuildLooseBackSofa, {0.86f, 1.5f, 0.84f}},
            {BuildModularSofa, {0.98f, 2.5f, 0.66f}}}}};
}

}  // namespace semantic_slam
