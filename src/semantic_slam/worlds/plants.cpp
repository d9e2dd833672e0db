#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

// A leaf's frame: it grows from `at_m` in the direction of `heading_rad`, `pitch_rad` above level.
Rigid3d LeafPose(const Eigen::Vector3f& at_m, float heading_rad, float pitch_rad, float roll_rad) {
  Rigid3d T = Rigid3d(Eigen::Translation3d(at_m.cast<double>()));
  T.rotate(Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()));
  T.rotate(Eigen::AngleAxisd(-pitch_rad, Eigen::Vector3d::UnitY()));
  T.rotate(Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()));
  return T;
}

// Returns the height of the soil.
float AddPot(FurnitureBuilder& b, float radius_m, float height_m) {
  const float soil = 0.88f * height_m;
  b.Add("pot", LatheMesh({0, 0, 0},
                         {{0, 0},
                          {0.72f * radius_m, 0},
                          {0.95f * radius_m, 0.85f * height_m},
                          {radius_m, 0.86f * height_m},
                          {radius_m, height_m},
                          {0.88f * radius_m, height_m},
                          {0.86f * radius_m, soil - 0.01f},
                          {0, soil - 0.01f}},
                         24));
  b.Add("soil",
        CylinderMesh({0, 0, soil - 0.012f}, 0.86f * radius_m, 0.86f * radius_m, 0.012f, 20));
  return soil;
}

// Stems that branch out, with leaves all around their upper halves.
void BuildBush(FurnitureBuilder& b) {
  const float soil = AddPot(b, 0.3f * b.width(), 0.28f * b.height());
  const float rise_m = b.height() - soil;
  for (int stem = 0; stem < 5; ++stem) {
    const float heading = 2 * kPi * (stem + b.Random(0.0f, 0.6f)) / 5;
    const Eigen::Vector3f out(std::cos(heading), std::sin(heading), 0);
    const float lean_m = (stem == 0 ? 0.05f : b.Random(0.15f, 0.32f)) * b.width();
    const Eigen::Vector3f root = 0.03f * out + soil * Eigen::Vector3f::UnitZ();
    const Eigen::Vector3f tip =
        lean_m * out + (soil + b.Random(0.65f, 0.92f) * rise_m) * Eigen::Vector3f::UnitZ();
    b.Add("stems", LimbMesh(root, tip, 0.012f, 0.006f, 6));
    for (int leaf = 0; leaf < 14; ++leaf) {
      const Eigen::Vector3f at = root + (tip - root) * (0.3f + 0.7f * leaf / 13);
      const float length_m = b.Random(0.16f, 0.26f) * std::min(1.0f, 1.4f * b.height());
      b.Add("leaves", LeafMesh(length_m, 0.42f * length_m, 0.25f * length_m),
            LeafPose(at, leaf * 2.4f + b.Random(-0.3f, 0.3f), b.Random(-0.1f, 0.8f),
                     b.Random(-0.4f, 0.4f)));
    }
  }
  b.FitToSize();
}

// Stiff upright blades, as Sansevieria has.
void BuildBlades(FurnitureBuilder& b) {
  const float soil = AddPot(b, 0.38f * b.width(), 0.3f * b.height());
  for (int blade = 0; blade < 14; ++blade) {
    const float heading = blade * 2.4f;
    const float out_m = 0.02f + 0.16f * b.width() * std::sqrt(blade / 14.0f);
    const float length_m = b.Random(0.6f, 1.0f) * (b.height() - soil);
    const Eigen::Vector3f root(out_m * std::cos(heading), out_m * std::sin(heading), soil - 0.01f);
    b.Add("leaves", LeafMesh(length_m, 0.08f, 0.1f * length_m),
          LeafPose(root, heading, b.Random(1.25f, 1.5f), b.Random(-0.3f, 0.3f)));
  }
  b.FitToSize();
}

// Long leaves in an arch from one place.
void BuildPalm(FurnitureBuilder& b) {
  const float soil = AddPot(b, 0.24f * b.width(), 0.25f * b.height());
  const float crown = soil + 0.25f * (b.height() - soil);
  b.Add("stems", LimbMesh({0, 0, soil - 0.01f}, {0, 0, crown}, 0.03f, 0.022f, 10));
  for (int leaf = 0; leaf < 22; ++leaf) {
    const float length_m = b.Random(0.75f, 1.0f) * 0.75f * (b.height() - soil);
    b.Add("leaves", LeafMesh(length_m, 0.15f * length_m, 0.45f * length_m),
          LeafPose({0, 0, crown - 0.005f * leaf}, leaf * 2.4f, b.Random(0.45f, 1.35f), 0));
  }
  b.FitToSize();
}

// A trunk that carries a ball of leaves.
void BuildTree(FurnitureBuilder& b) {
  constexpr int kLeaves = 110;
  const float soil = AddPot(b, 0.3f * b.width(), 0.2f * b.height());
  const Eigen::Vector3f crown(0, 0, 0.74f * b.height());
  b.Add("stems", LimbMesh({0, 0, soil - 0.01f}, crown, 0.018f, 0.012f, 8));
  const float radius_m = 0.34f * b.width();
  for (int leaf = 0; leaf < kLeaves; ++leaf) {
    const float up = 1.0f - 2.0f * (leaf + 0.5f) / kLeaves;  // evenly on a sphere
    const float heading = 2.4f * leaf;
    const float out = std::sqrt(1.0f - up * up);
    const Eigen::Vector3f at =
        crown + radius_m * b.Random(0.55f, 0.9f) *
                    Eigen::Vector3f(out * std::cos(heading), out * std::sin(heading), up);
    const float length_m = 0.3f * b.width() * b.Random(0.7f, 1.0f);
    b.Add("leaves", LeafMesh(length_m, 0.5f * length_m, 0.2f * length_m),
          LeafPose(at, heading, 0.8f * up + b.Random(-0.4f, 0.4f), b.Random(-0.5f, 0.5f)));
  }
  b.FitToSize();
}

// A few broad leaves on long stalks, as Monstera has.
void BuildBroadLeaves(FurnitureBuilder& b) {
  constexpr int kStalks = 9;
  const float soil = AddPot(b, 0.26f * b.width(), 0.26f * b.height());
  for (int stalk = 0; stalk < kStalks; ++stalk) {
    const float heading = 2.4f * stalk;
    const Eigen::Vector3f out(std::cos(heading), std::sin(heading), 0);
    const float rise_m = (0.35f + 0.55f * stalk / kStalks) * (b.height() - soil);
    const Eigen::Vector3f tip =
        b.Random(0.12f, 0.22f) * b.width() * out + (soil + rise_m) * Eigen::Vector3f::UnitZ();
    b.Add("stems", LimbMesh(0.03f * out + soil * Eigen::Vector3f::UnitZ(), tip, 0.007f, 0.005f, 6));
    const float length_m = b.Random(0.36f, 0.48f) * b.width();
    b.Add("leaves", LeafMesh(length_m, 0.85f * length_m, 0.35f * length_m),
          LeafPose(tip, heading, b.Random(0.1f, 0.5f), b.Random(-0.2f, 0.2f)));
  }
  b.FitToSize();
}

// Columns of a cactus, one of them with arms.
void BuildCactus(FurnitureBuilder& b) {
  const float soil = AddPot(b, 0.4f * b.width(), 0.3f * b.height());
  const float thick_m = 0.11f * b.width();
  const auto limb = [&](const Eigen::Vector3f& from, const Eigen::Vector3f& to, float share) {
    b.Add("leaves", LimbMesh(from, to, share * thick_m, share * thick_m, 10));
  };
  limb({0, 0, soil}, {0, 0, 0.95f * b.height()}, 1.0f);
  limb({0.5f * thick_m, 2.4f * thick_m, soil}, {0.5f * thick_m, 2.4f * thick_m, 0.6f * b.height()},
       0.7f);
  for (const float side : {-1.0f, 1.0f}) {
    const float low = (side < 0 ? 0.5f : 0.68f) * b.height();
    const float out = side * 0.36f * b.width();
    limb({0, 0, low}, {0, out, low + 0.03f * b.height()}, 0.65f);
    limb({0, out, low + 0.03f * b.height()}, {0, out, low + 0.24f * b.height()}, 0.65f);
  }
  b.FitToSize();
}

FurnitureKind PlantOf(const std::string& name, const Eigen::Vector3f& size_m,
                      const std::array<std::uint8_t, 3>& leaf_rgb,
                      const std::array<std::uint8_t, 3>& pot_rgb,
                      void (*build)(FurnitureBuilder&)) {
  return {name,
          "plant",
          Mount::kFloor,
          size_m,
          {{"leaves", MakeMaterial("foliage", leaf_rgb, 0.1f)},
           {"pot", MakeMaterial("marble", pot_rgb, 0.2f)},
           {"soil", MakeMaterial("carpet", {62, 46, 34})}},
          {},
          build};
}

FurnitureKind WithStems(FurnitureKind kind) {
  kind.materials.emplace("stems", MakeMaterial("wood", {96, 84, 52}));
  return kind;
}

}  // namespace

std::vector<FurnitureKind> PlantKinds() {
  return {WithStems(PlantOf("plant", {0.6f, 0.6f, 1.0f}, {66, 122, 52}, {168, 104, 76}, BuildBush)),
          PlantOf("snake_plant", {0.34f, 0.34f, 0.8f}, {74, 118, 70}, {214, 210, 202}, BuildBlades),
          WithStems(PlantOf("palm", {1.0f, 1.0f, 1.5f}, {58, 128, 60}, {90, 92, 98}, BuildPalm)),
          WithStems(PlantOf("pot_plant", {0.26f, 0.26f, 0.32f}, {86, 142, 58}, {196, 120, 84},
                            BuildBush))};
}

DesignTable PlantDesigns() {
  return {{"plant",
           {{BuildBroadLeaves, {0.8f, 0.8f, 1.0f}},
            {BuildTree, {0.7f, 0.7f, 1.5f}},
            {BuildCactus, {0.45f, 0.45f, 0.9f}}}},
          {"pot_plant",
           {{BuildBroadLeaves, {0.32f, 0.32f, 0.36f}},
            {BuildCactus, {0.16f, 0.16f, 0.28f}},
            {BuildTree, {0.3f, 0.3f, 0.5f}}}}};
}

}  // namespace semantic_slam
