#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

// A vessel from its outline (radius and height as fractions of the largest and the whole): outside
// up, `wall_m` thick, inside down.
Mesh VesselMesh(const std::vector<Eigen::Vector2f>& outline, float radius_m, float height_m,
                float wall_m) {
  std::vector<Eigen::Vector2f> profile_m{{0, 0}};
  for (const Eigen::Vector2f& p : outline) {
    profile_m.emplace_back(p.x() * radius_m, p.y() * height_m);
  }
  for (auto p = outline.rbegin(); p != outline.rend(); ++p) {
    const float inner_m = std::max(p->x() * radius_m - wall_m, 0.002f);
    profile_m.emplace_back(inner_m, std::max(p->y() * height_m, wall_m));
  }
  profile_m.emplace_back(0, wall_m);
  return LatheMesh(Eigen::Vector3f::Zero(), profile_m, 24);
}

void BuildCup(FurnitureBuilder& b) {
  const float radius_m = 0.5f * b.depth();
  const Rigid3d T(Eigen::Translation3d(0, 0.5 * (b.width() - b.depth()), 0));
  b.Add("china", VesselMesh({{0.7f, 0}, {0.95f, 0.2f}, {1, 1}}, radius_m, b.height(), 0.004f), T);
  const int steps = 6;  // the handle, to -y
  const auto handle = [&](int i) -> Eigen::Vector3f {
    const float angle = kPi * i / steps;
    return {0, -0.94f * radius_m - (b.width() - b.depth()) * std::sin(angle) * 0.85f,
            b.height() * (0.5f + 0.3f * std::cos(angle))};
  };
  for (int i = 0; i < steps; ++i) {
    b.Add("china", LimbMesh(handle(i), handle(i + 1), 0.006f, 0.006f, 8), T);
  }
  b.FitToSize();
}

void BuildBottle(FurnitureBuilder& b) {
  const float radius_m = 0.5f * b.width();
  b.Add("glass",
        VesselMesh(
            {{0.95f, 0}, {1, 0.02f}, {1, 0.55f}, {0.85f, 0.66f}, {0.4f, 0.78f}, {0.36f, 0.94f}},
            radius_m, b.height(), 0.003f));
  b.Add("label", CylinderMesh({0, 0, 0.16f * b.height()}, 1.01f * radius_m, 1.01f * radius_m,
                              0.28f * b.height(), 24));
  b.Add("label", CylinderMesh({0, 0, 0.92f * b.height()}, 0.4f * radius_m, 0.4f * radius_m,
                              0.08f * b.height(), 16));
  b.FitToSize();
}

void BuildBowl(FurnitureBuilder& b) {
  b.Add("china", VesselMesh({{0.42f, 0}, {0.45f, 0.06f}, {0.75f, 0.35f}, {0.93f, 0.7f}, {1, 1}},
                            0.5f * b.width(), b.height(), 0.006f));
  b.FitToSize();
}

// With twigs in it.
void BuildVase(FurnitureBuilder& b) {
  const float vessel_m = 0.55f * b.height();
  const float radius_m = 0.3f * b.width();
  b.Add("china",
        VesselMesh({{0.6f, 0}, {0.95f, 0.3f}, {1, 0.45f}, {0.7f, 0.75f}, {0.45f, 0.9f}, {0.55f, 1}},
                   radius_m, vessel_m, 0.006f));
  for (int i = 0; i < 7; ++i) {
    const float heading = 2.4f * i;
    const Eigen::Vector3f out(std::cos(heading), std::sin(heading), 0);
    const float reach_m = b.Random(0.15f, 0.45f) * b.width();
    const Eigen::Vector3f tip =
        reach_m * out + b.Random(0.8f, 0.97f) * b.height() * Eigen::Vector3f::UnitZ();
    b.Add("stems", LimbMesh({0, 0, 0.5f * vessel_m}, tip, 0.003f, 0.002f, 6));
    b.Add("flowers", EllipsoidMesh(tip, {0.026f, 0.026f, 0.018f}, 10));
    Rigid3d T = Rigid3d(Eigen::Translation3d((0.8f * tip).cast<double>()));
    T.rotate(Eigen::AngleAxisd(heading + 1, Eigen::Vector3d::UnitZ()));
    b.Add("stems", LeafMesh(0.09f, 0.03f, 0.03f), T);
  }
  b.FitToSize();
}

void BuildFruit(FurnitureBuilder& b) {
  const float radius_m = 0.038f;
  for (int i = 0; i < 5; ++i) {
    const float heading = 2 * kPi * i / 4 + 0.4f;
    const float out_m = i < 4 ? 1.42f * radius_m : 0.0f;
    const float z = i < 4 ? radius_m : 2.3f * radius_m;
    b.Add(i % 2 == 0 ? "apples" : "oranges",
          EllipsoidMesh({out_m * std::cos(heading), out_m * std::sin(heading), z},
                        Eigen::Vector3f(1, 1, i % 2 == 0 ? 0.92f : 1.0f) * radius_m, 14));
  }
  b.FitToSize();
}

void BuildPlate(FurnitureBuilder& b) {
  b.Add("china",
        VesselMesh({{0.6f, 0}, {0.7f, 0.25f}, {1, 1}}, 0.5f * b.width(), b.height(), 0.006f));
  b.FitToSize();
}

}  // namespace

std::vector<FurnitureKind> TablewareKinds() {
  const Material china = MakeMaterial("marble", {230, 226, 218}, 0.6f);
  const Material blue = MakeMaterial("plastic", {60, 92, 150}, 0.5f);
  return {
      {"cup", "cup", Mount::kFloor, {0.085f, 0.12f, 0.095f}, {{"china", blue}}, {}, BuildCup},
      {"bottle",
       "bottle",
       Mount::kFloor,
       {0.08f, 0.08f, 0.3f},
       {{"glass", MakeMaterial("glass", {44, 92, 60}, 0.8f)},
        {"label", MakeMaterial("paper", {226, 210, 150})}},
       {},
       BuildBottle},
      {"bowl", "bowl", Mount::kFloor, {0.28f, 0.28f, 0.1f}, {{"china", china}}, {}, BuildBowl},
      {"plate", "bowl", Mount::kFloor, {0.26f, 0.26f, 0.025f}, {{"china", china}}, {}, BuildPlate},
      {"vase",
       "vase",
       Mount::kFloor,
       {0.28f, 0.28f, 0.48f},
       {{"china", MakeMaterial("marble", {86, 120, 140}, 0.5f)},
        {"stems", MakeMaterial("foliage", {90, 120, 60})},
        {"flowers", MakeMaterial("foliage", {220, 160, 60})}},
       {},
       BuildVase},
      {"fruit",
       "food",
       Mount::kFloor,
       {0.18f, 0.18f, 0.12f},
       {{"apples", MakeMaterial("skin", {180, 44, 36}, 0.3f)},
        {"oranges", MakeMaterial("skin", {226, 140, 40}, 0.2f)}},
       {},
       BuildFruit}};
}

}  // namespace semantic_slam
