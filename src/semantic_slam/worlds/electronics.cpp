#include <algorithm>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// A flat screen from `low_m` up, its front at x = `face_m`.
void AddPanel(FurnitureBuilder& b, float face_m, float low_m, float thick_m, float bezel_m) {
  const float side = 0.5f * b.width();
  b.Box("case", {face_m - thick_m, -side, low_m}, {face_m - 0.004f, side, b.height()});
  b.BoxWithPicture("case", "screen", {face_m - 0.004f, -side + bezel_m, low_m + bezel_m},
                   {face_m - 0.002f, side - bezel_m, b.height() - bezel_m});
  const float inner = side - bezel_m;
  b.Box("case", {face_m - 0.004f, -side, low_m}, {face_m, side, low_m + bezel_m});
  b.Box("case", {face_m - 0.004f, -side, b.height() - bezel_m}, {face_m, side, b.height()});
  for (const float y : {-side, inner}) {
    b.Box("case", {face_m - 0.004f, y, low_m + bezel_m},
          {face_m, y + bezel_m, b.height() - bezel_m});
  }
}

void BuildTv(FurnitureBuilder& b) {
  const float low = 0.07f;
  AddPanel(b, 0.025f, low, 0.04f, 0.012f);
  const float x = 0.5f * b.depth();
  for (const float side : {-1.0f, 1.0f}) {
    const float y = side * 0.33f * b.width();
    b.Add("case", BoxMesh({0, y, 0.008f}, {2 * x, 0.05f, 0.016f}));
    b.Add("case", BoxMesh({0, y, 0.5f * (low + 0.016f)}, {0.025f, 0.03f, low - 0.016f}));
  }
}

void BuildMonitor(FurnitureBuilder& b) {
  const float low = 0.24f * b.height();
  AddPanel(b, 0.02f, low, 0.03f, 0.01f);
  const float x = 0.5f * b.depth();
  b.Box("case", {-x, -0.22f * b.width(), 0}, {x, 0.22f * b.width(), 0.012f});
  b.Add("case", BeamMesh({-0.3f * x, 0, 0.012f}, {-0.025f, 0, low + 0.1f}, {0.03f, 0.06f},
                         {0.025f, 0.05f}));
}

// Opened by `open_deg`; the user sits at its front.
void BuildLaptop(FurnitureBuilder& b) {
  const float base_m = 0.018f;
  const float lid_m = 0.23f;
  const float side = 0.16f;
  const float hinge = -0.11f;
  b.BoxWithPictureOnTop("case", "keys", {hinge, -side, 0}, {hinge + 0.22f, side, base_m});
  Rigid3d T = Rigid3d(Eigen::Translation3d(hinge, 0, base_m));
  T.rotate(
      Eigen::AngleAxisd((90.0f - b.Number("open_deg")) * M_PI / 180, Eigen::Vector3d::UnitY()));
  b.BoxWithPicture("case", "screen", {-0.006f, -side, 0}, {0, side, lid_m}, T);
  b.FitToSize();
}

void BuildKeyboard(FurnitureBuilder& b) {
  b.BoxWithPictureOnTop("case", "keys", {-0.5f * b.depth(), -0.5f * b.width(), 0},
                        {0.5f * b.depth(), 0.5f * b.width(), b.height()});
}

void BuildMouse(FurnitureBuilder& b) {
  Mesh shell = EllipsoidMesh({0, 0, 0}, {0.06f, 0.034f, 0.036f}, 16);
  for (Eigen::Vector3f& p : shell.positions_m) p.z() = std::max(p.z(), -0.004f);
  for (std::size_t i = 0; i < shell.positions_m.size(); ++i) {
    if (shell.positions_m[i].z() <= -0.004f) shell.normals[i] = -Eigen::Vector3f::UnitZ();
  }
  b.Add("case", shell);
  b.FitToSize();
}

void BuildTelephone(FurnitureBuilder& b) {
  b.Add("case", BeamMesh({0, 0, 0}, {-0.01f, 0, 0.05f}, {0.2f, 0.18f}, {0.17f, 0.16f}));
  b.Add("keys", BoxMesh({0.01f, -0.035f, 0.052f}, {0.09f, 0.07f, 0.006f}));
  for (const float x : {-0.075f, 0.07f}) {
    b.Add("keys", RoundedBoxMesh({x - 0.005f, 0.05f, 0.068f}, {0.05f, 0.05f, 0.03f}, 0.012f));
  }
  b.Add("keys", BoxMesh({-0.005f, 0.05f, 0.08f}, {0.14f, 0.035f, 0.02f}));
  b.FitToSize();
}

void BuildRemote(FurnitureBuilder& b) {
  b.Add("case", RoundedBoxMesh({0, 0, 0.5f * b.height()}, {b.depth(), b.width(), b.height()},
                               0.3f * b.height()));
}

}  // namespace

std::vector<FurnitureKind> ElectronicsKinds() {
  const Material black = MakeMaterial("plastic", {32, 32, 35}, 0.5f);
  const Material silver = MakeMaterial("metal", {180, 182, 186}, 0.4f);
  const Material screen = MakeMaterial("screen", {60, 90, 140}, 0.3f, 0.85f);
  const Material keys = MakeMaterial("keyboard", {45, 45, 48});
  return {
      {"tv",
       "tv",
       Mount::kFloor,
       {0.26f, 1.2f, 0.76f},
       {{"case", black}, {"screen", screen}},
       {},
       BuildTv},
      {"monitor",
       "tv",
       Mount::kFloor,
       {0.2f, 0.55f, 0.46f},
       {{"case", black}, {"screen", screen}},
       {},
       BuildMonitor},
      {"laptop",
       "laptop",
       Mount::kFloor,
       {0.28f, 0.33f, 0.23f},
       {{"case", silver}, {"screen", screen}, {"keys", keys}},
       {{"open_deg", {108, 70, 150}}},
       BuildLaptop},
      {"keyboard",
       "keyboard",
       Mount::kFloor,
       {0.14f, 0.44f, 0.025f},
       {{"case", black}, {"keys", keys}},
       {},
       BuildKeyboard},
      {"mouse", "mouse", Mount::kFloor, {0.11f, 0.065f, 0.038f}, {{"case", black}}, {}, BuildMouse},
      {"telephone",
       "telephone",
       Mount::kFloor,
       {0.21f, 0.19f, 0.1f},
       {{"case", black}, {"keys", MakeMaterial("plastic", {70, 70, 74}, 0.3f)}},
       {},
       BuildTelephone},
      {"remote",
       "remote",
       Mount::kFloor,
       {0.18f, 0.05f, 0.02f},
       {{"case", black}},
       {},
       BuildRemote}};
}

}  // namespace semantic_slam
