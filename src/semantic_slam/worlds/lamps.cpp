#include <cmath>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/lamp_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// A foot, a stem and a shade with a bulb in it.
void AddStandingLamp(FurnitureBuilder& b, float stem_m, float shade_m) {
  const float radius_m = 0.5f * b.width();
  const float shade_low = b.height() - shade_m;
  b.Add("stand", CylinderMesh({0, 0, 0}, 0.68f * radius_m, 0.62f * radius_m, 0.025f, 28));
  b.Add("stand", CylinderMesh({0, 0, 0.025f}, stem_m, stem_m, b.height() - 0.4f * shade_m, 10));
  b.Add("shade", ShadeMesh({0, 0, shade_low}, radius_m, 0.7f * radius_m, shade_m));
  b.Add("shade", EllipsoidMesh({0, 0, shade_low + 0.55f * shade_m},
                               Eigen::Vector3f::Constant(0.18f * radius_m), 10));
  b.FitToSize();
}

void BuildFloorLamp(FurnitureBuilder& b) {
  AddStandingLamp(b, 0.014f, 0.2f * b.height());
}

void BuildTableLamp(FurnitureBuilder& b) {
  const float radius_m = 0.5f * b.width();
  const float shade_m = 0.5f * b.height();
  b.Add("stand", LatheMesh({0, 0, 0},
                           {{0, 0},
                            {0.5f * radius_m, 0},
                            {0.52f * radius_m, 0.02f},
                            {0.2f * radius_m, 0.12f * b.height()},
                            {0.5f * radius_m, 0.3f * b.height()},
                            {0.42f * radius_m, 0.42f * b.height()},
                            {0.08f * radius_m, 0.52f * b.height()},
                            {0.08f * radius_m, 0.75f * b.height()},
                            {0, 0.75f * b.height()}},
                           20));
  b.Add("shade", ShadeMesh({0, 0, b.height() - shade_m}, radius_m, 0.62f * radius_m, shade_m));
  b.FitToSize();
}

// Two arms with a joint, and a reflector that looks at the desk.
void BuildDeskLamp(FurnitureBuilder& b) {
  b.Add("stand", CylinderMesh({-0.14f, 0, 0}, 0.09f, 0.085f, 0.02f, 20));
  b.Add("stand", LimbMesh({-0.14f, 0, 0.02f}, {-0.2f, 0, 0.24f}, 0.009f, 0.009f, 8));
  b.Add("stand", LimbMesh({-0.2f, 0, 0.24f}, {0.08f, 0, 0.4f}, 0.009f, 0.009f, 8));
  b.Add("stand", LatheMesh({0.1f, 0, 0.32f},
                           {{0.075f, 0},
                            {0.08f, 0},
                            {0.03f, 0.09f},
                            {0, 0.1f},
                            {0, 0.09f},
                            {0.028f, 0.085f},
                            {0.075f, 0}},
                           20));
  b.Add("shade", EllipsoidMesh({0.1f, 0, 0.35f}, {0.03f, 0.03f, 0.03f}, 10));
  b.FitToSize();
}

// Hangs on a cord from the ceiling.
void BuildPendantLamp(FurnitureBuilder& b) {
  const float radius_m = 0.5f * b.width();
  const float shade_m = 0.45f * b.height();
  b.Add("shade", ShadeMesh({0, 0, 0}, radius_m, 0.45f * radius_m, shade_m));
  b.Add("shade",
        EllipsoidMesh({0, 0, 0.45f * shade_m}, Eigen::Vector3f::Constant(0.2f * radius_m), 12));
  b.Add("stand", CylinderMesh({0, 0, 0.5f * shade_m}, 0.006f, 0.006f,
                              b.height() - 0.5f * shade_m - 0.02f, 8));
  b.Add("stand", CylinderMesh({0, 0, b.height() - 0.02f}, 0.05f, 0.05f, 0.02f, 16));
  b.FitToSize();
  AddLightBelow(b, 0.4f);
}

// A flat dome close to the ceiling.
void BuildCeilingLamp(FurnitureBuilder& b) {
  const float radius_m = 0.5f * b.width();
  std::vector<Eigen::Vector2f> dome{{0, 0}};
  for (int i = 1; i <= 8; ++i) {
    const float angle = 0.5f * static_cast<float>(M_PI) * i / 8;
    dome.emplace_back(0.92f * radius_m * std::sin(angle),
                      0.8f * b.height() * (1 - std::cos(angle)));
  }
  dome.emplace_back(0, 0.8f * b.height());
  b.Add("shade", LatheMesh({0, 0, 0}, dome, 28));
  b.Add("stand",
        CylinderMesh({0, 0, 0.8f * b.height()}, radius_m, radius_m, 0.2f * b.height(), 28));
  b.FitToSize();
  AddLightBelow(b, 0.5f);
}

// A lit panel as in offices.
void BuildCeilingPanel(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth();
  const float y = 0.5f * b.width();
  b.Box("stand", {-x, -y, 0.2f * b.height()}, {x, y, b.height()});
  b.Box("shade", {-x + 0.02f, -y + 0.02f, 0}, {x - 0.02f, y - 0.02f, 0.2f * b.height()});
  AddLightBelow(b, 0.6f);
}

FurnitureKind LampOf(const std::string& name, Mount mount, const Eigen::Vector3f& size_m,
                     const Material& stand, const Material& shade,
                     void (*build)(FurnitureBuilder&)) {
  FurnitureKind kind{name, "lamp", mount, size_m, {{"stand", stand}, {"shade", shade}}, {}, build};
  if (mount == Mount::kCeiling) kind.numbers.emplace("light", NumberRange{0.8, 0, 10});
  return kind;
}

}  // namespace

std::vector<FurnitureKind> LampKinds() {
  const Material brass = MakeMaterial("metal", {150, 120, 70}, 0.5f);
  const Material steel = MakeMaterial("metal", {70, 72, 75}, 0.5f);
  const Material linen = MakeMaterial("fabric", {245, 228, 195}, 0, 0.75f);
  const Material milk = MakeMaterial("plastic", {250, 246, 235}, 0, 0.95f);
  return {
      LampOf("floor_lamp", Mount::kFloor, {0.42f, 0.42f, 1.6f}, brass, linen, BuildFloorLamp),
      LampOf("table_lamp", Mount::kFloor, {0.28f, 0.28f, 0.46f}, brass, linen, BuildTableLamp),
      LampOf("desk_lamp", Mount::kFloor, {0.42f, 0.18f, 0.44f}, steel, milk, BuildDeskLamp),
      LampOf("pendant_lamp", Mount::kCeiling, {0.45f, 0.45f, 0.8f}, steel, linen, BuildPendantLamp),
      LampOf("ceiling_lamp", Mount::kCeiling, {0.42f, 0.42f, 0.12f}, steel, milk, BuildCeilingLamp),
      LampOf("ceiling_panel", Mount::kCeiling, {0.6f, 1.2f, 0.03f}, steel, milk,
             BuildCeilingPanel)};
}

}  // namespace semantic_slam
