#include <algorithm>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kLegsM = 0.16f;
constexpr float kFrameM = 0.16f;  // height of the boards around the mattress

void AddBedFrame(FurnitureBuilder& b) {
  const float head = -0.5f * b.depth();
  const float side = 0.5f * b.width();
  b.Box("frame", {head, -side, kLegsM}, {head + 0.05f, side, b.height()});
  b.Box("frame", {head + 0.05f, -side + 0.02f, kLegsM}, {-head, side - 0.02f, kLegsM + kFrameM});
  for (const float x : {head + 0.035f, -head - 0.06f}) {
    for (const float y : {-side + 0.05f, side - 0.05f}) {
      b.Add("frame", BeamMesh({x, y, 0}, {x, y, kLegsM}, {0.045f, 0.045f}, {0.06f, 0.06f}));
    }
  }
}

// The duvet lies over the mattress from its foot to below the pillows, and hangs down a little.
void BuildBed(FurnitureBuilder& b) {
  const float head = -0.5f * b.depth() + 0.05f;
  const float foot = 0.5f * b.depth();
  const float mattress_m = b.Number("mattress_top_m");
  AddBedFrame(b);
  const float low = kLegsM + kFrameM - 0.04f;
  b.Add("mattress",
        RoundedBoxMesh({0.5f * (head + foot) - 0.01f, 0, 0.5f * (low + mattress_m)},
                       {foot - head - 0.04f, b.width() - 0.08f, mattress_m - low}, 0.05f));
  const float duvet_head = head + 0.28f * b.depth();
  const float duvet_top = mattress_m + 0.045f;
  const float duvet_low = kLegsM + 0.4f * kFrameM;
  b.Add("duvet", RoundedBoxMesh({0.5f * (duvet_head + foot), 0, 0.5f * (duvet_low + duvet_top)},
                                {foot - duvet_head, b.width(), duvet_top - duvet_low}, 0.06f));
  // Its upper edge is folded back.
  b.Add("mattress", RoundedBoxMesh({duvet_head + 0.14f, 0, duvet_top + 0.006f},
                                   {0.3f, b.width() - 0.04f, 0.05f}, 0.024f));
}

void BuildPillow(FurnitureBuilder& b) {
  b.Add("cover", PillowMesh({0, 0, 0.5f * b.height()}, b.depth() * Eigen::Vector3f::UnitX() +
                                                           b.width() * Eigen::Vector3f::UnitY() +
                                                           b.height() * Eigen::Vector3f::UnitZ()));
}

FurnitureKind BedOf(const std::string& name, float width_m) {
  return {name,
          "bed",
          Mount::kFloor,
          {2.1f, width_m, 1.0f},
          {{"frame", MakeMaterial("wood", {120, 82, 52}, 0.2f)},
           {"mattress", MakeMaterial("cloth", {228, 226, 220})},
           {"duvet", MakeMaterial("fabric", {96, 120, 150})}},
          {{"mattress_top_m", {0.5, 0.4, 0.7}}},
          BuildBed};
}

}  // namespace

std::vector<FurnitureKind> BedKinds() {
  return {BedOf("bed", 1.6f),
          BedOf("single_bed", 0.95f),
          {"pillow",
           "pillow",
           Mount::kFloor,
           {0.48f, 0.68f, 0.16f},
           {{"cover", MakeMaterial("cloth", {232, 230, 226})}},
           {},
           BuildPillow}};
}

}  // namespace semantic_slam
