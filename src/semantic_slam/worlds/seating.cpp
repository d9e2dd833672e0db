#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/furniture_parts.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

// The back of a chair: two posts that lean back, with slats or a padded panel between them.
void AddChairBack(FurnitureBuilder& b, float seat_m, float post_m) {
  const float rear = -0.5f * b.depth();
  const float lean_m = 0.1f * b.depth();
  const Eigen::Vector2f section(post_m, post_m);
  for (const float y : {-1.0f, 1.0f}) {
    const float side = y * 0.5f * (b.width() - post_m);
    b.Add("frame", BeamMesh({rear + lean_m + 0.5f * post_m, side, seat_m},
                            {rear + 0.5f * post_m, side, b.height()}, section, section));
  }
  const float inner_m = b.width() - 2 * post_m;
  const float rise_m = b.height() - seat_m;
  const bool padded = b.Number("padded_back") > 0.5f;
  const int slats = padded ? 1 : 3;
  const float slat_m = padded ? 0.72f * rise_m : 0.14f * rise_m;
  for (int i = 0; i < slats; ++i) {
    const float top_m = b.height() - 0.04f * rise_m - i * 0.3f * rise_m;
    const auto rear_at = [&](float z) { return rear + lean_m * (b.height() - z) / rise_m; };
    const Eigen::Vector2f board(0.6f * post_m, inner_m);
    b.Add(padded ? "seat" : "frame",
          BeamMesh({rear_at(top_m - slat_m) + 0.5f * post_m, 0, top_m - slat_m},
                   {rear_at(top_m) + 0.5f * post_m, 0, top_m}, board, board));
  }
}

void BuildChair(FurnitureBuilder& b) {
  constexpr float kPostM = 0.038f;
  const float seat_m = 0.5f * b.height();
  const float board_m = 0.025f;
  AddLegs(b, "frame", b.depth() - 0.02f, b.width(), seat_m - board_m, kPostM);
  const float front = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  b.Box("frame", {-front + 0.01f, -side, seat_m - 2 * board_m}, {front, side, seat_m - board_m});
  AddPadding(b, "seat", {-front + 0.06f, -side + 0.005f, seat_m - board_m},
             {front, side - 0.005f, seat_m + 0.02f}, 0.015f);
  AddChairBack(b, seat_m - board_m, kPostM);
}

void BuildOfficeChair(FurnitureBuilder& b) {
  const float seat_m = 0.48f;  // of a chair 1 m high; stretched to the size at the end
  AddCastorFoot(b, "base", 0.32f, seat_m - 0.05f);
  AddPadding(b, "seat", {-0.22f, -0.24f, seat_m - 0.05f}, {0.27f, 0.24f, seat_m + 0.04f}, 0.035f);
  Mesh back;
  Append(back, RoundedBoxMesh({0, 0, 0.25f}, {0.07f, 0.44f, 0.5f}, 0.03f));
  Rigid3d T = Rigid3d(Eigen::Translation3d(-0.24, 0.0, seat_m + 0.04));
  T.rotate(Eigen::AngleAxisd(-0.14, Eigen::Vector3d::UnitY()));
  b.Add("seat", back, T);
  b.Add("base", BeamMesh({-0.18f, 0, seat_m - 0.045f}, {-0.29f, 0, seat_m + 0.3f}, {0.03f, 0.08f},
                         {0.02f, 0.08f}));
  for (const float y : {-1.0f, 1.0f}) {
    b.Add("base", BeamMesh({-0.02f, y * 0.24f, seat_m - 0.03f}, {-0.02f, y * 0.29f, seat_m + 0.2f},
                           {0.05f, 0.02f}, {0.04f, 0.02f}));
    AddPadding(b, "base", {-0.14f, y * 0.29f - 0.035f, seat_m + 0.2f},
               {0.12f, y * 0.29f + 0.035f, seat_m + 0.23f}, 0.012f);
  }
  b.FitToSize();
}

void BuildStool(FurnitureBuilder& b) {
  const float board_m = 0.035f;
  const float inset_m = 0.06f * b.width();
  AddLegs(b, "frame", b.depth() - inset_m, b.width() - inset_m, b.height() - board_m, 0.035f);
  b.Box("seat", {-0.5f * b.depth(), -0.5f * b.width(), b.height() - board_m},
        {0.5f * b.depth(), 0.5f * b.width(), b.height()});
}

// One or more padded seats between two arms, on low legs.
void BuildSofa(FurnitureBuilder& b) {
  const float legs_m = b.Number("legs_m");
  const float arm_m = std::min(0.2f, 0.2f * b.width());
  const float arm_top_m = 0.72f * b.height();
  const float seat_m = 0.5f * b.height();
  const float front = 0.5f * b.depth();
  const float side = 0.5f * b.width();
  AddLegs(b, "legs", b.depth() - 0.08f, b.width() - 0.08f, legs_m, 0.05f);
  AddPadding(b, "cover", {-front + 0.03f, -side + 0.03f, legs_m},
             {front - 0.02f, side - 0.03f, seat_m - 0.12f}, 0.02f);
  for (const float y : {-1.0f, 1.0f}) {
    const float outer = y * side;
    const float inner = y * (side - arm_m);
    AddPadding(b, "cover", {-front + 0.02f, std::min(inner, outer), legs_m + 0.01f},
               {front - 0.01f, std::max(inner, outer), arm_top_m}, 0.05f);
  }
  AddPadding(b, "cover", {-front, -side + 0.02f, legs_m + 0.01f},
             {-front + 0.22f, side - 0.02f, b.height() - 0.03f}, 0.06f);
  const int seats = std::max(1, static_cast<int>(std::lround((b.width() - 2 * arm_m) / 0.65f)));
  const float each_m = (b.width() - 2 * arm_m) / seats;
  for (int i = 0; i < seats; ++i) {
    const float left = -side + arm_m + i * each_m;
    AddPadding(b, "cushions", {-front + 0.2f, left + 0.004f, seat_m - 0.13f},
               {front, left + each_m - 0.004f, seat_m + 0.02f}, 0.05f);
    AddPadding(b, "cushions", {-front + 0.14f, left + 0.01f, seat_m},
               {-front + 0.32f, left + each_m - 0.01f, b.height()}, 0.07f);
  }
}

FurnitureKind SofaOf(const std::string& name, const std::string& label,
                     const Eigen::Vector3f& size_m, const std::array<std::uint8_t, 3>& rgb) {
  return {name,
          label,
          Mount::kFloor,
          size_m,
          {{"cover", MakeMaterial("fabric", rgb)},
           {"cushions", MakeMaterial("fabric", rgb)},
           {"legs", MakeMaterial("wood", {70, 48, 32}, 0.2f)}},
          {{"legs_m", {0.1, 0.04, 0.25}}},
          BuildSofa};
}

}  // namespace

std::vector<FurnitureKind> SeatingKinds() {
  const Material wood = MakeMaterial("wood", {150, 104, 62}, 0.2f);
  const Material steel = MakeMaterial("metal", {90, 92, 96}, 0.5f);
  return {{"chair",
           "chair",
           Mount::kFloor,
           {0.5f, 0.45f, 0.92f},
           {{"frame", wood}, {"seat", MakeMaterial("fabric", {150, 60, 50})}},
           {{"padded_back", {0, 0, 1}}},
           BuildChair},
          {"office_chair",
           "chair",
           Mount::kFloor,
           {0.66f, 0.64f, 1.02f},
           {{"base", MakeMaterial("plastic", {45, 46, 50}, 0.3f)},
            {"seat", MakeMaterial("fabric", {60, 70, 90})}},
           {},
           BuildOfficeChair},
          {"stool",
           "chair",
           Mount::kFloor,
           {0.36f, 0.36f, 0.46f},
           {{"frame", steel}, {"seat", wood}},
           {},
           BuildStool},
          {"bench",
           "bench",
           Mount::kFloor,
           {0.36f, 1.2f, 0.45f},
           {{"frame", wood}, {"seat", wood}},
           {},
           BuildStool},
          SofaOf("sofa", "sofa", {0.92f, 2.1f, 0.84f}, {110, 120, 130}),
          SofaOf("armchair", "chair", {0.86f, 0.88f, 0.86f}, {170, 120, 60})};
}

}  // namespace semantic_slam
