#include <algorithm>
#include <cmath>
#include <vector>

#include "semantic_slam/worlds/bed_parts.h"
#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// A board across the bed that bends: `profile_m` is its middle line (x, z) from below upwards.
void AddBentBoard(FurnitureBuilder& b, const std::vector<Eigen::Vector2f>& profile_m, float width_m,
                  float thickness_m) {
  const Eigen::Vector2f section(thickness_m, width_m);
  for (std::size_t i = 0; i + 1 < profile_m.size(); ++i) {
    const Eigen::Vector2f &low = profile_m[i], &high = profile_m[i + 1];
    b.Add("frame", BeamMesh({low.x(), 0, low.y()}, {high.x(), 0, high.y()}, section, section));
  }
  const Eigen::Vector2f& top = profile_m.back();
  const float half = 0.5f * width_m - thickness_m;
  b.Add("frame", LimbMesh({top.x(), -half, top.y()}, {top.x(), half, top.y()}, thickness_m,
                          thickness_m, 14));
}

// The boards along both sides, and the slats that carry the mattress as one board.
void AddSideBoards(FurnitureBuilder& b, float head_m, float foot_m, float width_m) {
  const float half = 0.5f * width_m;
  for (const float right : {-half, half - 0.03f}) {
    b.Box("frame", {head_m, right, 0.16f}, {foot_m, right + 0.03f, 0.34f});
  }
  b.Box("frame", {head_m, -half + 0.03f, 0.24f}, {foot_m, half - 0.03f, 0.27f});
}

// A sleigh: head and foot roll outwards.
void BuildSleighBed(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float high = b.height(), foot = 0.68f * b.height();
  AddBentBoard(b,
               {{-x + 0.17f, 0.06f},
                {-x + 0.18f, 0.5f * high},
                {-x + 0.15f, 0.72f * high},
                {-x + 0.09f, 0.88f * high},
                {-x + 0.045f, high - 0.045f}},
               2 * y, 0.045f);
  AddBentBoard(b,
               {{x - 0.16f, 0.06f},
                {x - 0.17f, 0.5f * foot},
                {x - 0.14f, 0.75f * foot},
                {x - 0.09f, 0.9f * foot},
                {x - 0.045f, foot - 0.045f}},
               2 * y, 0.045f);
  for (const float at : {-x + 0.17f, x - 0.16f}) {
    for (const float side : {-y + 0.05f, y - 0.05f}) {
      b.Add("frame", EllipsoidMesh({at, side, 0.05f}, {0.05f, 0.045f, 0.05f}, 10));
    }
  }
  AddSideBoards(b, -x + 0.18f, x - 0.17f, 2 * y - 0.02f);
  AddBedding(b, -x + 0.21f, x - 0.2f, 2 * y - 0.1f, 0.27f);
  b.FitToSize();
}

// Four posts as high as a door, and rails above.
void BuildFourPoster(FurnitureBuilder& b) {
  constexpr float kPostM = 0.07f;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  for (const float rear : {-x, x - kPostM}) {
    for (const float right : {-y, y - kPostM}) {
      b.Box("frame", {rear, right, 0}, {rear + kPostM, right + kPostM, b.height()});
    }
    b.Box("frame", {rear + 0.012f, -y + kPostM, b.height() - 0.06f},
          {rear + kPostM - 0.012f, y - kPostM, b.height() - 0.01f});
  }
  for (const float right : {-y, y - kPostM}) {
    b.Box("frame", {-x + kPostM, right + 0.012f, b.height() - 0.06f},
          {x - kPostM, right + kPostM - 0.012f, b.height() - 0.01f});
  }
  b.Box("frame", {-x + 0.02f, -y + kPostM, 0.2f}, {-x + 0.05f, y - kPostM, 0.52f * b.height()});
  b.Box("frame", {x - 0.05f, -y + kPostM, 0.16f}, {x - 0.02f, y - kPostM, 0.36f});
  AddSideBoards(b, -x + kPostM, x - kPostM, 2 * y - 0.04f);
  AddBedding(b, -x + 0.06f, x - 0.06f, 2 * y - 0.16f, 0.27f);
}

// The head is a bookcase: a shelf between its sides, and one on top.
void AddBookcaseHead(FurnitureBuilder& b, float head_m, float deep_m) {
  constexpr float kBoardM = 0.025f;
  const float y = 0.5f * b.width(), high = b.height();
  b.Box("frame", {head_m, -y, 0}, {head_m + 0.015f, y, high});
  for (const float right : {-y, -0.5f * kBoardM, y - kBoardM}) {
    b.Box("frame", {head_m + 0.015f, right, 0}, {head_m + deep_m, right + kBoardM, high});
  }
  for (const float low : {0.62f * high, high - kBoardM}) {
    for (const float right : {-y + kBoardM, 0.5f * kBoardM}) {
      b.Box("frame", {head_m + 0.015f, right, low},
            {head_m + deep_m, right + y - 1.5f * kBoardM, low + kBoardM});
    }
  }
}

// A chest below the mattress: drawers in both sides, a bookcase at the head.
void BuildStorageBed(FurnitureBuilder& b) {
  constexpr float kHeadM = 0.24f;
  constexpr int kDrawers = 3;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float rear = -x + kHeadM;
  AddBookcaseHead(b, -x, kHeadM);
  b.Box("frame", {rear, -y + 0.06f, 0}, {x - 0.04f, y - 0.06f, 0.06f});
  b.Box("frame", {rear, -y + 0.02f, 0.06f}, {x, y - 0.02f, 0.36f});
  const float each_m = (x - rear) / kDrawers;
  for (int i = 0; i < kDrawers; ++i) {
    for (const float right : {-y, y - 0.02f}) {
      b.Box("frame", {rear + i * each_m + 0.006f, right, 0.075f},
            {rear + (i + 1) * each_m - 0.006f, right + 0.02f, 0.315f});
    }
  }
  AddBedding(b, rear + 0.01f, x - 0.02f, 2 * y - 0.08f, 0.35f);
  b.FitToSize();
}

// Upright planks whose tops make an arch, thin legs that lean outwards, no board at the foot.
void BuildArchedBed(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const int planks = std::max(6, static_cast<int>(std::lround(b.width() / 0.14f)));
  const float each_m = 2 * y / planks;
  for (int i = 0; i < planks; ++i) {
    const float share = 2.0f * (i + 0.5f) / planks - 1.0f;
    const float top_m = b.height() * (0.66f + 0.34f * std::sqrt(1.0f - share * share));
    const float right = -y + i * each_m;
    AddPadding(b, "frame", {-x, right + 0.002f, 0.22f},
               {-x + 0.04f, right + each_m - 0.002f, top_m}, 0.012f);
  }
  AddSplayedLegs(b, "frame", {b.depth() - 0.06f, b.width() - 0.06f},
                 {b.depth() - 0.2f, b.width() - 0.2f}, 0.24f, 0.024f);
  b.Box("frame", {-x + 0.04f, -y + 0.01f, 0.22f}, {x, y - 0.01f, 0.3f});
  AddBedding(b, -x + 0.05f, x - 0.03f, 2 * y - 0.08f, 0.29f);
  b.FitToSize();
}

// A daybed: boards of one height at both ends and along its left side.
void BuildDaybed(FurnitureBuilder& b) {
  constexpr float kBarM = 0.045f;
  const float x = 0.5f * b.depth(), y = 0.5f * b.width();
  const float high = b.height();
  for (const float rear : {-x, x - kBarM}) {
    for (const float right : {-y, y - kBarM}) {
      b.Box("frame", {rear, right, 0}, {rear + kBarM, right + kBarM, high});
    }
    for (const float low : {0.22f, 0.62f * high, high - 0.09f}) {
      b.Box("frame", {rear + 0.01f, -y + kBarM, low}, {rear + 0.03f, y - kBarM, low + 0.09f});
    }
  }
  for (const float low : {0.62f * high, high - 0.09f}) {
    b.Box("frame", {-x + kBarM, y - 0.03f, low}, {x - kBarM, y - 0.01f, low + 0.09f});
  }
  AddSideBoards(b, -x + kBarM, x - kBarM, 2 * y);
  AddBedding(b, -x + kBarM, x - kBarM - 0.01f, 2 * y - 0.12f, 0.27f);
  b.FitToSize();
}

}  // namespace

DesignTable BedsteadDesigns() {
  return {{"bed",
           {{BuildSleighBed, {2.35f, 1.75f, 1.15f}},
            {BuildFourPoster, {2.15f, 1.75f, 2.0f}},
            {BuildStorageBed, {2.3f, 1.65f, 0.95f}},
            {BuildArchedBed, {2.1f, 1.6f, 1.2f}}}},
          {"single_bed",
           {{BuildDaybed, {2.08f, 1.0f, 0.85f}},
            {BuildStorageBed, {2.25f, 1.0f, 0.9f}},
            {BuildSleighBed, {2.3f, 1.05f, 1.0f}},
            {BuildArchedBed, {2.08f, 0.98f, 1.1f}}}}};
}

}  // namespace semantic_slam
