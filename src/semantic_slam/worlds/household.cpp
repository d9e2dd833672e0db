#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// A carton, closed with tape.
void BuildBox(FurnitureBuilder& b) {
  constexpr float kTapeM = 0.001f;
  const float x = 0.5f * b.depth();
  const float y = 0.5f * b.width();
  b.Box("board", {-x, -y, 0}, {x, y, b.height() - kTapeM});
  b.Box("tape", {-0.03f, -y, b.height() - kTapeM}, {0.03f, y, b.height()});
}

// An open crate with things in it.
void BuildCrate(FurnitureBuilder& b) {
  constexpr float kWallM = 0.012f;
  const float x = 0.5f * b.depth();
  const float y = 0.5f * b.width();
  b.Box("board", {-x, -y, 0}, {x, y, kWallM});
  for (const float side : {-1.0f, 1.0f}) {
    b.Add("board", BoxMesh({side * (x - 0.5f * kWallM), 0, 0.5f * (b.height() + kWallM)},
                           {kWallM, 2 * y, b.height() - kWallM}));
    b.Add("board", BoxMesh({0, side * (y - 0.5f * kWallM), 0.5f * (b.height() + kWallM)},
                           {2 * (x - kWallM), kWallM, b.height() - kWallM}));
  }
  for (int i = 0; i < 4; ++i) {
    const float each = 2 * (y - kWallM) / 4;
    const float low = -y + kWallM + i * each;
    b.Add(i % 2 == 0 ? "red" : "blue",
          RoundedBoxMesh({0, low + 0.5f * each, 0.5f * b.height()},
                         {b.Random(0.6f, 0.9f) * 2 * (x - kWallM), 0.9f * each,
                          b.Random(0.6f, 0.9f) * b.height()},
                         0.02f));
  }
}

// A rucksack that stands: its front pocket to the front.
void BuildBag(FurnitureBuilder& b) {
  b.Add("cloth", RoundedBoxMesh({-0.02f, 0, 0.21f}, {0.17f, 0.3f, 0.42f}, 0.06f));
  b.Add("cloth", RoundedBoxMesh({0.075f, 0, 0.13f}, {0.07f, 0.24f, 0.2f}, 0.03f));
  b.Add("straps", LimbMesh({-0.03f, -0.05f, 0.42f}, {-0.03f, 0.05f, 0.42f}, 0.012f, 0.012f, 8));
  for (const float y : {-0.08f, 0.08f}) {
    b.Add("straps", LimbMesh({-0.11f, y, 0.08f}, {-0.125f, y, 0.22f}, 0.016f, 0.018f, 8));
    b.Add("straps", LimbMesh({-0.125f, y, 0.22f}, {-0.1f, y, 0.38f}, 0.018f, 0.016f, 8));
  }
  b.FitToSize();
}

// Folded laundry.
void BuildClothes(FurnitureBuilder& b) {
  const int pieces = 4;
  const float each = b.height() / pieces;
  const char* parts[] = {"white", "red", "blue", "red"};
  for (int i = 0; i < pieces; ++i) {
    const float scale = i == 0 ? 1.0f : b.Random(0.8f, 1.0f);
    b.Add(parts[i],
          RoundedBoxMesh({0, i == 0 ? 0 : b.Random(-0.01f, 0.01f), (i + 0.5f) * each},
                         {scale * b.depth(), 0.95f * scale * b.width(), each}, 0.45f * each));
  }
  b.FitToSize();
}

// A teddy bear that sits.
void BuildToy(FurnitureBuilder& b) {
  b.Add("fur", EllipsoidMesh({0, 0, 0.12f}, {0.075f, 0.085f, 0.11f}, 16));
  b.Add("fur", EllipsoidMesh({0.01f, 0, 0.27f}, {0.07f, 0.075f, 0.07f}, 16));
  b.Add("snout", EllipsoidMesh({0.07f, 0, 0.26f}, {0.03f, 0.03f, 0.025f}, 12));
  b.Add("eyes", EllipsoidMesh({0.1f, 0, 0.268f}, {0.009f, 0.011f, 0.008f}, 8));
  for (const float side : {-1.0f, 1.0f}) {
    b.Add("fur", EllipsoidMesh({0, side * 0.062f, 0.33f}, {0.015f, 0.028f, 0.028f}, 12));
    b.Add("eyes", EllipsoidMesh({0.07f, side * 0.03f, 0.295f}, {0.008f, 0.008f, 0.009f}, 8));
    b.Add("fur",
          LimbMesh({0.02f, side * 0.08f, 0.19f}, {0.07f, side * 0.12f, 0.11f}, 0.03f, 0.028f));
    b.Add("fur",
          LimbMesh({0.03f, side * 0.06f, 0.045f}, {0.14f, side * 0.09f, 0.04f}, 0.042f, 0.036f));
    b.Add("snout", EllipsoidMesh({0.172f, side * 0.092f, 0.045f}, {0.01f, 0.03f, 0.035f}, 10));
  }
  b.FitToSize();
}

void BuildRug(FurnitureBuilder& b) {
  b.Add("pile", SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.03f), 0, b.height()));
}

void BuildRoundRug(FurnitureBuilder& b) {
  b.Add("pile",
        SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.5f * std::min(b.depth(), b.width())), 0,
                 b.height()));
}

}  // namespace

std::vector<FurnitureKind> HouseholdKinds() {
  const Material card = MakeMaterial("cardboard", {176, 138, 96});
  const Material red = MakeMaterial("cloth", {176, 62, 54});
  const Material blue = MakeMaterial("cloth", {66, 94, 140});
  const Material rug = MakeMaterial("rug", {150, 60, 52});
  return {{"box",
           "box",
           Mount::kFloor,
           {0.4f, 0.5f, 0.32f},
           {{"board", card}, {"tape", MakeMaterial("plastic", {196, 170, 120}, 0.3f)}},
           {},
           BuildBox},
          {"crate",
           "box",
           Mount::kFloor,
           {0.36f, 0.5f, 0.28f},
           {{"board", MakeMaterial("wood", {190, 150, 100})}, {"red", red}, {"blue", blue}},
           {},
           BuildCrate},
          {"bag",
           "bag",
           Mount::kFloor,
           {0.26f, 0.32f, 0.44f},
           {{"cloth", MakeMaterial("cloth", {54, 84, 74})},
            {"straps", MakeMaterial("leather", {40, 34, 30})}},
           {},
           BuildBag},
          {"clothes",
           "clothes",
           Mount::kFloor,
           {0.3f, 0.36f, 0.2f},
           {{"white", MakeMaterial("cloth", {226, 224, 218})}, {"red", red}, {"blue", blue}},
           {},
           BuildClothes},
          {"toy",
           "toy",
           Mount::kFloor,
           {0.26f, 0.28f, 0.36f},
           {{"fur", MakeMaterial("carpet", {156, 108, 64})},
            {"snout", MakeMaterial("cloth", {214, 180, 130})},
            {"eyes", MakeMaterial("plastic", {24, 20, 18}, 0.6f)}},
           {},
           BuildToy},
          {"rug", "floor_mat", Mount::kFloor, {1.6f, 2.3f, 0.01f}, {{"pile", rug}}, {}, BuildRug},
          {"round_rug",
           "floor_mat",
           Mount::kFloor,
           {1.6f, 1.6f, 0.01f},
           {{"pile", rug}},
           {},
           BuildRoundRug}};
}

}  // namespace semantic_slam
