#include <cmath>
#include <optional>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr double kPi = 3.14159265358979;

// To and fro about a hip or shoulder; left and right, arm and leg are half a period apart.
std::optional<Swing> SwingOf(FurnitureBuilder& b, const Eigen::Vector3f& pivot_m,
                             double amplitude_rad, double phase_rad) {
  if (b.Number("walking") < 0.5f) return std::nullopt;
  return Swing{pivot_m.cast<double>(), Eigen::Vector3d::UnitY(), amplitude_rad,
               b.Number("step_period_s"), phase_rad};
}

void AddLeg(FurnitureBuilder& b, float side, double phase_rad) {
  const Rigid3d still = Rigid3d::Identity();
  const Eigen::Vector3f hip(0, side * 0.09f, 0.9f);
  const Eigen::Vector3f knee(0.015f, side * 0.1f, 0.5f);
  const Eigen::Vector3f ankle(-0.02f, side * 0.105f, 0.1f);
  const std::optional<Swing> swing = SwingOf(b, hip, 0.36, phase_rad);
  b.Add("trousers", LimbMesh(hip, knee, 0.088f, 0.062f), still, swing);
  b.Add("trousers", LimbMesh(knee, ankle, 0.062f, 0.05f), still, swing);
  const Eigen::Vector3f foot(0.04f, side * 0.112f, 0.045f);
  b.Add("shoes", RoundedBoxMesh(foot, {0.28f, 0.1f, 0.09f}, 0.04f), still, swing);
}

void AddArm(FurnitureBuilder& b, float side, double phase_rad) {
  const Rigid3d still = Rigid3d::Identity();
  const Eigen::Vector3f shoulder(0, side * 0.19f, 1.39f);
  const Eigen::Vector3f elbow(-0.03f, side * 0.235f, 1.1f);
  const Eigen::Vector3f wrist(0.03f, side * 0.235f, 0.86f);
  const Eigen::Vector3f hand(0.045f, side * 0.235f, 0.79f);
  const std::optional<Swing> swing = SwingOf(b, shoulder, 0.42, phase_rad);
  b.Add("shirt", LimbMesh(shoulder, elbow, 0.06f, 0.045f), still, swing);
  b.Add("shirt", LimbMesh(elbow, wrist, 0.045f, 0.036f), still, swing);
  b.Add("skin", EllipsoidMesh(hand, {0.035f, 0.024f, 0.08f}, 12), still, swing);
}

// A lathe's solid, flattened from front to back as a trunk is.
void AddTrunk(FurnitureBuilder& b) {
  Mesh trunk = LatheMesh(Eigen::Vector3f::Zero(),
                         {{0, 0.84f},
                          {0.14f, 0.85f},
                          {0.175f, 0.92f},
                          {0.16f, 1.05f},
                          {0.175f, 1.2f},
                          {0.19f, 1.32f},
                          {0.175f, 1.41f},
                          {0.09f, 1.475f},
                          {0, 1.49f}},
                         24);
  constexpr float kFlat = 0.64f;
  for (Eigen::Vector3f& p : trunk.positions_m) p.x() *= kFlat;
  for (Eigen::Vector3f& n : trunk.normals) {
    n = Eigen::Vector3f(n.x() / kFlat, n.y(), n.z()).normalized();
  }
  b.Add("shirt", trunk);
  b.Add("trousers", EllipsoidMesh({0, 0, 0.9f}, {0.12f, 0.178f, 0.1f}));
}

void AddHead(FurnitureBuilder& b) {
  b.Add("skin", CylinderMesh({-0.008f, 0, 1.45f}, 0.064f, 0.056f, 0.1f));
  b.Add("skin", EllipsoidMesh({0.012f, 0, 1.63f}, {0.094f, 0.076f, 0.12f}, 20));
  b.Add("skin", EllipsoidMesh({0.105f, 0, 1.615f}, {0.018f, 0.014f, 0.025f}, 10));
  b.Add("hair", EllipsoidMesh({-0.018f, 0, 1.67f}, {0.106f, 0.09f, 0.112f}, 20));
  for (const float side : {-1.0f, 1.0f}) {
    b.Add("skin", EllipsoidMesh({0.0f, side * 0.078f, 1.62f}, {0.018f, 0.01f, 0.03f}, 10));
    b.Add("hair", EllipsoidMesh({0.097f, side * 0.033f, 1.64f}, {0.008f, 0.013f, 0.007f}, 8));
  }
  b.Add("mouth", EllipsoidMesh({0.092f, 0, 1.565f}, {0.008f, 0.024f, 0.006f}, 8));
}

void BuildPerson(FurnitureBuilder& b) {
  for (const float side : {-1.0f, 1.0f}) {
    const double phase_rad = side > 0 ? 0.0 : kPi;
    AddLeg(b, side, phase_rad);
    AddArm(b, side, phase_rad + kPi);
  }
  AddTrunk(b);
  AddHead(b);
  b.FitToSize();
}

}  // namespace

std::vector<FurnitureKind> PersonKinds() {
  return {{"person",
           "person",
           Mount::kFloor,
           {0.3f, 0.56f, 1.75f},
           {{"shirt", MakeMaterial("cloth", {64, 96, 150})},
            {"trousers", MakeMaterial("cloth", {58, 58, 66})},
            {"shoes", MakeMaterial("leather", {60, 42, 32}, 0.3f)},
            {"skin", MakeMaterial("skin", {214, 164, 134})},
            {"mouth", MakeMaterial("skin", {160, 84, 78})},
            {"hair", MakeMaterial("fabric", {52, 36, 26})}},
           {{"walking", {0, 0, 1}}, {"step_period_s", {1.15, 0.5, 3}}},
           BuildPerson}};
}

}  // namespace semantic_slam
