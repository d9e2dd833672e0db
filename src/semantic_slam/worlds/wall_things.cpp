#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// Turns what lies with its upper side up to face the front, upright.
const Rigid3d& Upright() {
  static const Rigid3d upright(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()));
  return upright;
}

// Four bars around a rectangle as large as the piece, as deep as it is.
void AddFrame(FurnitureBuilder& b, float bar_m) {
  const float side = 0.5f * b.width();
  b.Box("frame", {0, -side, 0}, {b.depth(), side, bar_m});
  b.Box("frame", {0, -side, b.height() - bar_m}, {b.depth(), side, b.height()});
  b.Box("frame", {0, -side, bar_m}, {b.depth(), -side + bar_m, b.height() - bar_m});
  b.Box("frame", {0, side - bar_m, bar_m}, {b.depth(), side, b.height() - bar_m});
}

void BuildFramed(FurnitureBuilder& b) {
  const float bar_m = b.Number("frame_m");
  const float inner = 0.5f * b.width() - bar_m;
  AddFrame(b, bar_m);
  b.BoxWithPicture("frame", "picture", {0, -inner, bar_m},
                   {0.6f * b.depth(), inner, b.height() - bar_m});
}

void BuildPoster(FurnitureBuilder& b) {
  b.BoxWithPicture("paper", "picture", {0, -0.5f * b.width(), 0},
                   {b.depth(), 0.5f * b.width(), b.height()});
}

// With a tray for pens below.
void BuildWhiteboard(FurnitureBuilder& b) {
  constexpr float kTrayM = 0.03f;
  constexpr float kBarM = 0.025f;
  const float side = 0.5f * b.width();
  const float face = std::min(0.03f, 0.4f * b.depth());
  b.Box("frame", {0, -side, kTrayM}, {face, side, kTrayM + kBarM});
  b.Box("frame", {0, -side, b.height() - kBarM}, {face, side, b.height()});
  for (const float y : {-side, side - kBarM}) {
    b.Box("frame", {0, y, kTrayM + kBarM}, {face, y + kBarM, b.height() - kBarM});
  }
  b.BoxWithPicture("frame", "board", {0, -side + kBarM, kTrayM + kBarM},
                   {0.7f * face, side - kBarM, b.height() - kBarM});
  b.Box("frame", {0, -0.4f * side, 0}, {b.depth(), 0.4f * side, 0.012f});
  b.Box("frame", {0, -0.4f * side, 0.012f}, {face, 0.4f * side, kTrayM});
}

// A broad frame, and a tray along its whole width.
void BuildTrayWhiteboard(FurnitureBuilder& b) {
  constexpr float kBarM = 0.045f;
  const float side = 0.5f * b.width();
  const float face = std::min(0.035f, 0.4f * b.depth());
  b.Box("frame", {0, -side, 0}, {b.depth(), side, 0.015f});
  b.Box("frame", {b.depth() - 0.01f, -side, 0.015f}, {b.depth(), side, 0.03f});
  b.Box("frame", {0, -side, 0.015f}, {face, side, 0.015f + kBarM});
  b.Box("frame", {0, -side, b.height() - kBarM}, {face, side, b.height()});
  for (const float y : {-side, side - kBarM}) {
    b.Box("frame", {0, y, 0.015f + kBarM}, {face, y + kBarM, b.height() - kBarM});
  }
  b.BoxWithPicture("frame", "board", {0, -side + kBarM, 0.015f + kBarM},
                   {0.6f * face, side - kBarM, b.height() - kBarM});
}

// A pane of glass without a frame, on four studs that keep it from the wall.
void BuildGlassWhiteboard(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float front = b.depth() - 0.004f;
  b.BoxWithPicture("frame", "board", {front - 0.008f, -side, 0}, {front, side, b.height()});
  for (const float y : {-side + 0.06f, side - 0.06f}) {
    for (const float z : {0.06f, b.height() - 0.06f}) {
      b.Add("frame", CylinderMesh({0, 0, 0}, 0.016f, 0.016f, b.depth(), 12),
            Rigid3d(Eigen::Translation3d(0, y, z)) * Upright());
    }
  }
}

// On a frame with castors that can be pushed about.
void BuildRollingWhiteboard(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float low = 0.38f * b.height();
  for (const float y : {-side + 0.02f, side - 0.02f}) {
    b.Box("frame", {-0.02f, y - 0.02f, 0.06f}, {0.02f, y + 0.02f, b.height()});
    b.Box("frame", {-0.5f * b.depth(), y - 0.02f, 0.06f}, {0.5f * b.depth(), y + 0.02f, 0.09f});
    for (const float x : {-0.5f * b.depth() + 0.04f, 0.5f * b.depth() - 0.04f}) {
      b.Add("frame", EllipsoidMesh({x, y, 0.035f}, {0.035f, 0.018f, 0.035f}, 12));
    }
  }
  b.Box("frame", {-0.015f, -side + 0.04f, 0.2f}, {0.015f, side - 0.04f, 0.24f});
  b.Box("frame", {-0.015f, -side + 0.04f, low - 0.02f}, {0.015f, side - 0.04f, low});
  b.Box("frame", {-0.015f, -side + 0.04f, b.height() - 0.02f}, {0.015f, side - 0.04f, b.height()});
  b.BoxWithPicture("frame", "board", {-0.012f, -side + 0.04f, low},
                   {0.012f, side - 0.04f, b.height() - 0.02f});
  b.Box("frame", {0.012f, -0.5f * side, low - 0.02f}, {0.09f, 0.5f * side, low - 0.008f});
  b.FitToSize();
}

// A flip chart: a board on three legs, with a pad of paper.
void BuildEasel(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float low = 0.42f * b.height();
  const Rigid3d T = Rigid3d(Eigen::AngleAxisd(-0.12, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3f top(0, 0, 0.95f * b.height());
  for (const float y : {-0.85f * side, 0.85f * side}) {
    b.Add("frame", LimbMesh({0, y, 0.01f}, {0, 0.4f * y, top.z()}, 0.012f, 0.012f, 8), T);
  }
  b.Add("frame", LimbMesh({-0.4f, 0, 0.06f}, {-0.02f, 0, top.z()}, 0.012f, 0.012f, 8), T);
  b.BoxWithPicture("frame", "board", {0.014f, -side, low}, {0.035f, side, b.height()}, T);
  b.Add("frame", BoxMesh({0.05f, 0, low - 0.01f}, {0.08f, 1.6f * side, 0.015f}), T);
  b.FitToSize();
}

// A cork board with sheets of paper on it.
void BuildPinBoard(FurnitureBuilder& b) {
  constexpr float kBarM = 0.02f;
  const float inner = 0.5f * b.width() - kBarM;
  const float board = 0.6f * b.depth();
  AddFrame(b, kBarM);
  b.Box("cork", {0, -inner, kBarM}, {board, inner, b.height() - kBarM});
  const int columns = std::max(1, static_cast<int>(2 * inner / 0.3f));
  for (int i = 0; i < columns; ++i) {
    const float y = inner - (i + 0.5f) * 2 * inner / columns + b.Random(-0.02f, 0.02f);
    const float low = kBarM + b.Random(0.08f, 0.4f) * (b.height() - 0.4f);
    const float high = std::min(low + b.Random(0.22f, 0.32f), b.height() - kBarM - 0.01f);
    b.BoxWithPicture("frame", "sheets", {board, y - 0.1f, low}, {board + 0.002f, y + 0.1f, high});
  }
}

void BuildClock(FurnitureBuilder& b) {
  const float radius_m = 0.5f * std::min(b.width(), b.height());
  const float face = 0.6f * b.depth();
  Rigid3d T = Rigid3d(Eigen::Translation3d(0, 0, 0.5 * b.height()));
  T = T * Upright();
  b.Add("frame",
        LatheMesh(Eigen::Vector3f::Zero(),
                  {{0.9f * radius_m, 0},
                   {radius_m, 0},
                   {radius_m, b.depth()},
                   {0.92f * radius_m, b.depth()},
                   {0.9f * radius_m, 0}},
                  32),
        T);
  Mesh dial = CylinderMesh(Eigen::Vector3f::Zero(), 0.91f * radius_m, 0.91f * radius_m, face, 32);
  for (std::size_t i = 0; i < dial.positions_m.size(); ++i) {
    const Eigen::Vector3f& p = dial.positions_m[i];
    dial.texture_m[i] = Eigen::Vector2f(p.y() + 0.91f * radius_m, p.x() + 0.91f * radius_m);
  }
  b.AddPicture("face", dial, Eigen::Vector2f::Constant(2 * 0.91f * radius_m), T);
  b.FitToSize();
}

// Over a bar, front and back.
void BuildTowel(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float bar = b.height() - 0.02f;
  const float x = b.depth() - 0.025f;
  b.Add("bar", LimbMesh({x, -side + 0.01f, bar}, {x, side - 0.01f, bar}, 0.01f, 0.01f, 8));
  for (const float y : {-side + 0.03f, side - 0.03f}) {
    b.Box("bar", {0, y - 0.008f, bar - 0.008f}, {x, y + 0.008f, bar + 0.008f});
  }
  b.Add("cloth",
        RoundedBoxMesh({x, 0, 0.5f * b.height()}, {0.05f, 0.8f * b.width(), b.height()}, 0.02f));
}

// Jackets on hooks.
void BuildCoats(FurnitureBuilder& b) {
  const float side = 0.5f * b.width();
  const float rail = b.height() - 0.08f;
  b.Box("board", {0, -side, rail}, {0.02f, side, b.height()});
  const int coats = std::max(1, static_cast<int>(std::lround(b.width() / 0.4f)));
  for (int i = 0; i < coats; ++i) {
    const float y = side - (i + 0.5f) * b.width() / coats;
    const std::string part = i % 2 == 0 ? "coat" : "jacket";
    const float hem = i == 0 ? 0.0f : b.Random(0.05f, 0.25f) * b.height();
    const float half = 0.42f * b.width() / coats;
    b.Add(part, BeamMesh({0.5f * b.depth(), y, hem}, {0.1f, y, rail - 0.05f}, {b.depth(), 2 * half},
                         {0.12f, 1.5f * half}));
    b.Add(part, BeamMesh({0.1f, y, rail - 0.05f}, {0.06f, y, rail + 0.03f}, {0.12f, 1.5f * half},
                         {0.06f, 0.1f}));
  }
}

}  // namespace

std::vector<FurnitureKind> WallKinds() {
  const Material oak = MakeMaterial("wood", {150, 108, 66}, 0.2f);
  const Material black = MakeMaterial("plastic", {40, 40, 42}, 0.3f);
  const Material alu = MakeMaterial("metal", {190, 192, 195}, 0.4f);
  const Material paper = MakeMaterial("paper", {240, 238, 232});
  return {{"picture",
           "picture",
           Mount::kWall,
           {0.03f, 0.8f, 0.6f},
           {{"frame", oak}, {"picture", MakeMaterial("painting", {120, 140, 150})}},
           {{"frame_m", {0.035, 0.01, 0.1}}},
           BuildFramed},
          {"mirror",
           "mirror",
           Mount::kWall,
           {0.03f, 0.6f, 1.0f},
           {{"frame", oak}, {"picture", MakeMaterial("mirror", {190, 200, 205}, 0.8f)}},
           {{"frame_m", {0.04, 0.01, 0.1}}},
           BuildFramed},
          {"poster",
           "picture",
           Mount::kWall,
           {0.004f, 0.6f, 0.84f},
           {{"paper", paper}, {"picture", MakeMaterial("poster", {200, 90, 60})}},
           {},
           BuildPoster},
          {"whiteboard",
           "whiteboard",
           Mount::kWall,
           {0.08f, 1.8f, 1.2f},
           {{"frame", alu}, {"board", MakeMaterial("whiteboard", {240, 242, 244}, 0.3f)}},
           {},
           BuildWhiteboard},
          {"whiteboard_stand",
           "whiteboard",
           Mount::kFloor,
           {0.6f, 1.5f, 1.85f},
           {{"frame", alu}, {"board", MakeMaterial("whiteboard", {240, 242, 244}, 0.3f)}},
           {},
           BuildRollingWhiteboard},
          {"pin_board",
           "picture",
           Mount::kWall,
           {0.02f, 1.2f, 0.9f},
           {{"frame", oak},
            {"cork", MakeMaterial("cork", {190, 145, 95})},
            {"sheets", MakeMaterial("magazine", {235, 232, 225})}},
           {},
           BuildPinBoard},
          {"clock",
           "clock",
           Mount::kWall,
           {0.04f, 0.32f, 0.32f},
           {{"frame", black}, {"face", MakeMaterial("clock_face", {245, 243, 236})}},
           {},
           BuildClock},
          {"towel",
           "towel",
           Mount::kWall,
           {0.09f, 0.5f, 0.6f},
           {{"bar", alu}, {"cloth", MakeMaterial("cloth", {200, 110, 90})}},
           {},
           BuildTowel},
          {"coats",
           "clothes",
           Mount::kWall,
           {0.24f, 0.8f, 1.1f},
           {{"board", oak},
            {"coat", MakeMaterial("cloth", {60, 70, 95})},
            {"jacket", MakeMaterial("cloth", {140, 60, 50})}},
           {},
           BuildCoats}};
}

DesignTable WallDesigns() {
  return {
      {"whiteboard",
       {{BuildTrayWhiteboard, {0.1f, 2.4f, 1.2f}}, {BuildGlassWhiteboard, {0.04f, 1.6f, 1.0f}}}},
      {"whiteboard_stand", {{BuildEasel, {0.65f, 0.7f, 1.85f}}}}};
}

}  // namespace semantic_slam
