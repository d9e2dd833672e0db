#include <algorithm>
#include <utility>

#include "semantic_slam/worlds/bed_parts.h"
#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// A frame of tubes: bars at the head and, lower, at the foot.
void BuildTubeBed(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth() - 0.02f, y = 0.5f * b.width() - 0.02f;
  const float foot_top = 0.62f * b.height();
  for (const auto& [at, top] : {std::pair(-x, b.height() - 0.02f), {x, foot_top}}) {
    AddTubePair(b, "frame", {{at, y, 0.02f}, {at, y, top}}, 0.02f);
    for (const float z : {0.3f, top}) AddTube(b, "frame", {{at, -y, z}, {at, y, z}}, 0.016f);
    const int bars = std::max(3, static_cast<int>(b.width() / 0.16f));
    for (int i = 1; i < bars; ++i) {
      const float across = -y + 2 * y * i / bars;
      AddTube(b, "frame", {{at, across, 0.3f}, {at, across, top}}, 0.008f);
    }
  }
  AddTubePair(b, "frame", {{-x, y, 0.3f}, {x, y, 0.3f}}, 0.02f);
  AddBedding(b, -x + 0.04f, x - 0.04f, 2 * y - 0.06f, 0.29f);
  b.FitToSize();
}

// Upholstered down to the floor, with a high head of padded fields.
void BuildBoxSpring(FurnitureBuilder& b) {
  const float head = -0.5f * b.depth();
  const float y = 0.5f * b.width();
  constexpr int kFields = 4;
  for (int i = 0; i < kFields; ++i) {
    const float right = -y + 2 * y * i / kFields;
    AddPadding(b, "frame", {head, right, 0.04f},
               {head + 0.12f, right + 2 * y / kFields, b.height()}, 0.035f);
  }
  AddPadding(b, "frame", {head + 0.1f, -y + 0.02f, 0.04f}, {-head - 0.01f, y - 0.02f, 0.32f},
             0.03f);
  AddBedding(b, head + 0.12f, -head - 0.02f, 2 * y - 0.06f, 0.31f);
  for (const float x : {head + 0.1f, -head - 0.1f}) {
    for (const float side : {-y + 0.1f, y - 0.1f}) {
      b.Add("frame", CylinderMesh({x, side, 0}, 0.03f, 0.03f, 0.05f, 12));
    }
  }
  b.FitToSize();
}

// A low platform that is wider than the mattress, without any end.
void BuildPlatformBed(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  b.Box("frame", {-x + 0.2f, -y + 0.2f, 0}, {x - 0.2f, y - 0.2f, 0.14f});
  b.Box("frame", {-x, -y, 0.14f}, {x, y, 0.22f});
  AddBedding(b, -x + 0.06f, x - 0.1f, 2 * y - 0.2f, 0.21f);
  b.FitToSize();
}

}  // namespace

DesignTable BedDesigns() {
  return {{"bed",
           {{BuildBoxSpring, {2.15f, 1.8f, 1.15f}},
            {BuildPlatformBed, {2.15f, 1.8f, 0.56f}},
            {BuildTubeBed, {2.08f, 1.5f, 1.1f}}}},
          {"single_bed",
           {{BuildBoxSpring, {2.1f, 1.0f, 1.1f}},
            {BuildPlatformBed, {2.1f, 1.1f, 0.56f}},
            {BuildTubeBed, {2.06f, 0.95f, 1.0f}}}}};
}

}  // namespace semantic_slam
