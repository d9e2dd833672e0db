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

// A rail around the rear, from the left arm to the right one: half axes `radii_m` about the middle
// of the seat, from `front_m` high at its ends to `rear_m` high behind.
std::vector<Eigen::Vector3f> ArmRail(const Eigen::Vector2f& radii_m, float front_m, float rear_m) {
  constexpr int kSteps = 14;
  constexpr float kReachRad = 0.68f * kPi;  // from straight behind to an end
  std::vector<Eigen::Vector3f> rail_m;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle = kPi + kReachRad * (2.0f * i / kSteps - 1.0f);
    const float behind = 0.5f - 0.5f * std::cos(angle);
    rail_m.emplace_back(radii_m.x() * std::cos(angle), radii_m.y() * std::sin(angle),
                        front_m + (rear_m - front_m) * behind);
  }
  return rail_m;
}

// A rail that is back and arms in one, a splat like a Y below it, and a woven seat.
void BuildWishbone(FurnitureBuilder& b) {
  const std::vector<Eigen::Vector3f> rail_m = ArmRail({0.23f, 0.26f}, 0.66f, 0.75f);
  AddTube(b, "frame", rail_m, 0.016f);
  AddTubePair(b, "frame",
              {{-0.23f, 0.2f, 0.02f},
               {-0.17f, 0.23f, 0.32f},
               {-0.14f, 0.24f, 0.5f},
               {-0.13f, 0.215f, 0.7f}},
              0.017f);
  AddTubePair(b, "frame", {{0.22f, 0.23f, 0.02f}, {0.21f, 0.225f, 0.45f}}, 0.018f);
  for (const float z : {0.26f, 0.42f}) {
    AddTubePair(b, "frame", {{-0.18f, 0.22f, z}, {0.21f, 0.225f, z}}, 0.011f);
    AddTube(b, "frame", {{0.21f, -0.22f, z}, {0.21f, 0.22f, z}}, 0.012f);
    AddTube(b, "frame", {{-0.17f, -0.22f, z}, {-0.17f, 0.22f, z}}, 0.012f);
  }
  b.Add("frame",
        BeamMesh({-0.165f, 0, 0.43f}, {-0.19f, 0, 0.57f}, {0.014f, 0.075f}, {0.014f, 0.07f}));
  for (const float y : {-1.0f, 1.0f}) {
    b.Add("frame", BeamMesh({-0.19f, 0.018f * y, 0.565f}, {-0.222f, 0.075f * y, 0.745f},
                            {0.014f, 0.034f}, {0.014f, 0.026f}));
  }
  AddPadding(b, "seat", {-0.18f, -0.225f, 0.42f}, {0.22f, 0.225f, 0.452f}, 0.014f);
  b.FitToSize();
}

// A director's: legs that cross below a seat of cloth, another cloth to lean on.
void BuildDirector(FurnitureBuilder& b) {
  const Eigen::Vector2f bar(0.016f, 0.032f);
  for (const float x : {-0.172f, 0.19f}) {
    for (const float side : {-1.0f, 1.0f}) {
      const float apart = 0.009f * side;  // the bars of a cross lie behind each other
      b.Add("frame", BeamMesh({x + apart, -0.25f * side, 0.02f}, {x + apart, 0.25f * side, 0.45f},
                              bar, bar));
    }
  }
  for (const float y : {-0.25f, 0.25f}) {
    b.Box("frame", {-0.2f, y - 0.018f, 0}, {0.22f, y + 0.018f, 0.025f});
    b.Box("frame", {-0.2f, y - 0.015f, 0.44f}, {0.23f, y + 0.015f, 0.465f});
    b.Box("frame", {0.175f, y - 0.013f, 0.46f}, {0.205f, y + 0.013f, 0.65f});
    b.Add("frame", BeamMesh({-0.17f, y, 0.46f}, {-0.21f, y, 0.88f}, bar, bar));
    AddPadding(b, "frame", {-0.22f, y - 0.028f, 0.645f}, {0.25f, y + 0.028f, 0.67f}, 0.01f);
  }
  AddPadding(b, "seat", {-0.19f, -0.24f, 0.445f}, {0.22f, 0.24f, 0.458f}, 0.005f);
  b.Add("seat", RoundedBoxMesh({0, 0, 0.08f}, {0.036f, 0.55f, 0.17f}, 0.012f),
        Leaning({-0.197f, 0, 0.705f}, -0.1f));
  b.FitToSize();
}

// A banker's: it turns on castors, with spindles below a rail of wood.
void BuildBanker(FurnitureBuilder& b) {
  AddCastorFoot(b, "base", 0.31f, 0.42f);
  b.Add("base", SlabMesh(RoundedRectangle({0.48f, 0.5f}, 0.16f), 0.42f, 0.46f));
  AddPadding(b, "seat", {-0.18f, -0.2f, 0.455f}, {0.2f, 0.2f, 0.49f}, 0.016f);
  const std::vector<Eigen::Vector3f> rail_m = ArmRail({0.27f, 0.29f}, 0.68f, 0.74f);
  AddTube(b, "base", rail_m, 0.02f);
  for (std::size_t i = 0; i < rail_m.size(); ++i) {
    AddTube(b, "base", {{0.78f * rail_m[i].x(), 0.76f * rail_m[i].y(), 0.45f}, rail_m[i]},
            i == 0 || i + 1 == rail_m.size() ? 0.016f : 0.009f);
  }
  for (const float y : {-0.16f, -0.08f, 0.0f, 0.08f, 0.16f}) {  // the crest above the rail
    AddTube(b, "base", {{-0.25f, y, 0.74f}, {-0.3f, y, 0.9f}}, 0.009f);
  }
  b.Add("base", RoundedBoxMesh({0, 0, 0.05f}, {0.025f, 0.42f, 0.1f}, 0.012f),
        Leaning({-0.295f, 0, 0.88f}, -0.2f));
  b.FitToSize();
}

}  // namespace

DesignTable WoodenChairDesigns() {
  return {{"chair", {{BuildWishbone, {0.5f, 0.55f, 0.76f}}, {BuildDirector, {0.5f, 0.6f, 0.88f}}}},
          {"office_chair", {{BuildBanker, {0.64f, 0.64f, 0.98f}}}}};
}

}  // namespace semantic_slam
