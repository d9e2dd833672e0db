#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// All are drawn at their usual size and stretched to the one asked for at the end.

constexpr float kSeatM = 0.44f;  // where the column ends

// A high back in a frame with a rest for the head, and arms like a T.
void BuildMeshBack(FurnitureBuilder& b) {
  AddCastorFoot(b, "base", 0.33f, kSeatM);
  AddPadding(b, "seat", {-0.22f, -0.25f, kSeatM}, {0.27f, 0.25f, kSeatM + 0.07f}, 0.03f);
  const Rigid3d T = Leaning({-0.26f, 0, kSeatM + 0.08f}, -0.13f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.29f}, {0.02f, 0.42f, 0.52f}, 0.009f), T);
  for (const float y : {-0.225f, 0.225f}) {
    b.Add("base", BoxMesh({0, y, 0.29f}, {0.035f, 0.03f, 0.58f}), T);
  }
  for (const float z : {0.015f, 0.565f}) {
    b.Add("base", BoxMesh({0, 0, z}, {0.035f, 0.42f, 0.03f}), T);
  }
  b.Add("base", BoxMesh({-0.03f, 0, 0.36f}, {0.03f, 0.06f, 0.76f}), T);
  b.Add("seat", RoundedBoxMesh({0.02f, 0, 0.68f}, {0.07f, 0.3f, 0.14f}, 0.03f), T);
  for (const float y : {-1.0f, 1.0f}) {
    b.Box("base", {-0.02f, y * 0.29f - 0.02f, kSeatM + 0.02f},
          {0.04f, y * 0.29f + 0.02f, kSeatM + 0.22f});
    b.Box("base", {-0.03f, y > 0 ? 0.2f : -0.29f, kSeatM - 0.01f},
          {0.04f, y > 0 ? 0.29f : -0.2f, kSeatM + 0.02f});
    AddPadding(b, "base", {-0.12f, y * 0.29f - 0.045f, kSeatM + 0.22f},
               {0.14f, y * 0.29f + 0.045f, kSeatM + 0.25f}, 0.012f);
  }
  b.FitToSize();
}

// A typist's: without arms, with a small back on a bent bar.
void BuildTaskChair(FurnitureBuilder& b) {
  AddCastorFoot(b, "base", 0.29f, kSeatM);
  AddPadding(b, "seat", {-0.2f, -0.22f, kSeatM}, {0.22f, 0.22f, kSeatM + 0.06f}, 0.028f);
  AddTube(b, "base",
          {{0, 0, kSeatM - 0.01f},
           {-0.25f, 0, kSeatM - 0.01f},
           {-0.28f, 0, kSeatM + 0.05f},
           {-0.27f, 0, kSeatM + 0.34f}},
          0.014f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.13f}, {0.055f, 0.38f, 0.27f}, 0.025f),
        Leaning({-0.23f, 0, kSeatM + 0.2f}, -0.08f));
  b.FitToSize();
}

// For who presides: thick rolls of padding, high and wide, with padded arms in loops.
void BuildExecutive(FurnitureBuilder& b) {
  AddCastorFoot(b, "base", 0.34f, kSeatM);
  for (int i = 0; i < 3; ++i) {
    AddPadding(b, "seat", {-0.24f + 0.18f * i, -0.26f, kSeatM},
               {-0.05f + 0.18f * i, 0.26f, kSeatM + 0.13f}, 0.06f);
  }
  const Rigid3d T = Leaning({-0.22f, 0, kSeatM + 0.08f}, -0.17f);
  for (int i = 0; i < 4; ++i) {
    b.Add("seat",
          RoundedBoxMesh({-0.02f, 0, 0.1f + 0.175f * i}, {0.15f, i == 3 ? 0.44f : 0.54f, 0.185f},
                         0.07f),
          T);
  }
  AddTubePair(b, "base",
              {{0.1f, 0.25f, kSeatM + 0.02f},
               {0.14f, 0.31f, kSeatM + 0.26f},
               {-0.18f, 0.31f, kSeatM + 0.28f},
               {-0.26f, 0.28f, kSeatM + 0.2f}},
              0.018f);
  for (const float y : {-0.31f, 0.31f}) {
    AddPadding(b, "seat", {-0.16f, y - 0.04f, kSeatM + 0.26f}, {0.13f, y + 0.04f, kSeatM + 0.31f},
               0.02f);
  }
  b.FitToSize();
}

// A moulded shell on castors.
void BuildShellOnCastors(FurnitureBuilder& b) {
  AddCastorFoot(b, "base", 0.28f, 0.45f);
  AddShell(b, "seat",
           {{0.25f, 0.45f},
            {0.2f, 0.48f},
            {0.06f, 0.46f},
            {-0.1f, 0.455f},
            {-0.17f, 0.5f},
            {-0.21f, 0.6f},
            {-0.23f, 0.72f},
            {-0.24f, 0.86f}},
           0.56f, 0.12f);
  b.FitToSize();
}

}  // namespace

DesignTable OfficeChairDesigns() {
  return {{"office_chair",
           {{BuildTaskChair, {0.58f, 0.58f, 0.92f}},
            {BuildMeshBack, {0.66f, 0.68f, 1.26f}},
            {BuildShellOnCastors, {0.58f, 0.58f, 0.86f}},
            {BuildExecutive, {0.74f, 0.7f, 1.2f}}}}};
}

}  // namespace semantic_slam
