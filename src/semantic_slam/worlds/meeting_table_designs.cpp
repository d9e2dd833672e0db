#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// Nearly square, for eight, with round corners, on four blocks down to the floor.
void BuildPlinthTable(FurnitureBuilder& b) {
  const float top_m = 0.05f;
  const float under_m = b.height() - top_m;
  b.Add("top",
        SlabMesh(RoundedRectangle({b.depth(), b.width()}, 0.12f * b.depth()), under_m, b.height()));
  for (const float x : {-0.27f * b.depth(), 0.27f * b.depth()}) {
    for (const float y : {-0.29f * b.width(), 0.29f * b.width()}) {
      b.Add("legs", BeamMesh({x, y, 0.03f}, {x, y, under_m}, {0.2f, 0.2f}, {0.28f, 0.28f}));
      b.Add("legs", BeamMesh({x, y, 0}, {x, y, 0.03f}, {0.16f, 0.16f}, {0.16f, 0.16f}));
    }
  }
}

// Before a screen: it narrows towards its right end, so that all see the picture; on runners.
void BuildTrapezoidTable(FurnitureBuilder& b) {
  const float top_m = 0.03f;
  const float bar_m = 0.06f;
  const float under_m = b.height() - top_m;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  constexpr float kNarrow = 0.58f;
  b.Add("top",
        SlabMesh({{x, y}, {-x, y}, {-kNarrow * x, -y}, {kNarrow * x, -y}}, under_m, b.height()));
  for (const float at : {-0.72f * y, 0.72f * y}) {
    const float reach_m = (at > 0 ? 0.78f : 0.52f) * x;
    for (const float low : {0.0f, under_m - 0.03f}) {
      b.Box("legs", {-reach_m, at - 0.5f * bar_m, low}, {reach_m, at + 0.5f * bar_m, low + 0.03f});
    }
    for (const float side : {-reach_m, reach_m}) {
      b.Add("legs", BeamMesh({0.9f * side, at, 0.03f}, {0.55f * side, at, under_m - 0.03f},
                             {0.04f, bar_m}, {0.05f, bar_m}));
    }
  }
  b.Box("legs", {-0.02f, -0.72f * y + 0.5f * bar_m, under_m - 0.1f},
        {0.02f, 0.72f * y - 0.5f * bar_m, under_m});
}

// Two rows of narrow tables on castors, their tops to be folded, pushed together back to back.
void BuildFlipTopTable(FurnitureBuilder& b) {
  const float top_m = 0.025f;
  const float under_m = b.height() - top_m;
  const float x = 0.5f * b.depth();
  const int count = std::max(1, static_cast<int>(std::lround(b.width() / 1.5f)));
  const float each_m = b.width() / count;
  for (int i = 0; i < count; ++i) {
    const float right = -0.5f * b.width() + i * each_m + (i > 0 ? 0.012f : 0.0f);
    const float left = -0.5f * b.width() + (i + 1) * each_m;
    for (const float rear : {-x, 0.006f}) {
      const float front = rear + x - 0.006f, middle = rear + 0.5f * x;
      b.Box("top", {rear, right, under_m}, {front, left, b.height()});
      for (const float y : {right + 0.16f, left - 0.16f}) {
        b.Box("legs", {middle - 0.035f, y - 0.02f, 0.09f}, {middle + 0.035f, y + 0.02f, under_m});
        b.Box("legs", {rear + 0.05f, y - 0.025f, 0.06f}, {front - 0.05f, y + 0.025f, 0.09f});
        for (const float at : {rear + 0.09f, front - 0.09f}) {
          b.Add("legs", EllipsoidMesh({at, y, 0.032f}, {0.032f, 0.02f, 0.032f}, 10));
        }
      }
      b.Box("legs", {middle - 0.02f, right + 0.18f, under_m - 0.06f},
            {middle + 0.02f, left - 0.18f, under_m - 0.02f});
    }
  }
}

// A bevelled top on two frames that lean against each other, each as wide as it.
void BuildLeaningFrameTable(FurnitureBuilder& b) {
  const float top_m = 0.06f;
  const float bar_m = 0.09f;
  const float under_m = b.height() - top_m;
  const float x = 0.42f * b.depth();
  b.Add("top", BeamMesh({0, 0, under_m}, {0, 0, b.height()}, {b.depth() - 0.16f, b.width() - 0.16f},
                        {b.depth(), b.width()}));
  for (const float side : {-1.0f, 1.0f}) {
    const float foot = side * 0.42f * b.width(), head = side * 0.24f * b.width();
    const Eigen::Vector2f bar(0.05f, bar_m);
    for (const float front : {-x, x}) {
      b.Add("legs", BeamMesh({front, foot, 0.04f}, {0.8f * front, head, under_m}, bar, bar));
    }
    b.Box("legs", {-x - 0.025f, foot - 0.5f * bar_m, 0}, {x + 0.025f, foot + 0.5f * bar_m, 0.04f});
  }
  b.Box("legs", {-0.04f, -0.24f * b.width(), under_m - 0.06f}, {0.04f, 0.24f * b.width(), under_m});
}

}  // namespace

DesignTable MeetingTableDesigns() {
  return {{"conference_table",
           {{BuildPlinthTable, {1.9f, 2.1f, 0.74f}},
            {BuildTrapezoidTable, {1.5f, 2.6f, 0.74f}},
            {BuildFlipTopTable, {1.3f, 2.9f, 0.73f}},
            {BuildLeaningFrameTable, {1.25f, 3.0f, 0.75f}}}}};
}

}  // namespace semantic_slam
