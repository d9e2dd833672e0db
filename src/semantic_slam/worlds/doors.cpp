#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"
#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kCoverM = 0.05f;  // how far a door's casing covers the wall around its opening
constexpr float kJambM = 0.03f;   // thickness of the lining inside
constexpr float kLeafM = 0.04f;
constexpr float kRaisedM = 0.012f;  // by which a field stands out of its leaf

// The lining and the boards around it on both sides of the wall.
void AddDoorFrame(FurnitureBuilder& b) {
  const float x = 0.5f * b.depth();
  const float outer = 0.5f * b.width();
  const float opening = outer - kCoverM;
  const float inner = opening - kJambM;
  const float lintel = b.height() - kCoverM - kJambM;
  for (const float side : {-1.0f, 1.0f}) {
    const auto upright = [&](float rear, float front, float edge, float top) {
      b.Box("frame", {rear, std::min(side * inner, side * edge), 0},
            {front, std::max(side * inner, side * edge), top});
    };
    upright(-x + 0.015f, x - 0.015f, opening, lintel + kJambM);
    upright(-x, -x + 0.015f, outer, b.height());
    upright(x - 0.015f, x, outer, b.height());
  }
  b.Box("frame", {-x + 0.015f, -inner, lintel}, {x - 0.015f, inner, lintel + kJambM});
  for (const float rear : {-x, x - 0.015f}) {
    b.Box("frame", {rear, -inner, lintel}, {rear + 0.015f, inner, b.height()});
  }
}

// Adds boxes in the frame of a leaf that is opened about its hinges, on the left or right as seen
// from the front, to which it opens: x to the front, y from the hinges.
class LeafBuilder {
 public:
  explicit LeafBuilder(FurnitureBuilder& b)
      : b_(b),
        wide_m_(b.width() - 2 * kCoverM - 2 * kJambM - 0.008f),
        high_m_(b.height() - kCoverM - kJambM - 0.004f),
        hinge_(b.Number("hinge_left") > 0.5f ? -1.0f : 1.0f),  // left as seen is -y
        handle_m_(std::min(0.05f, 0.5f * (b.depth() - kLeafM) - 0.005f)),
        T_object_leaf_(Eigen::Translation3d(0, hinge_ * 0.5f * wide_m_, 0)) {
    T_object_leaf_.rotate(
        Eigen::AngleAxisd(hinge_ * b.Number("open_deg") * kPi / 180, Eigen::Vector3d::UnitZ()));
  }

  float wide_m() const { return wide_m_; }
  float high_m() const { return high_m_; }

  void Add(const char* part, const Eigen::Vector3f& centre, const Eigen::Vector3f& size) {
    const Eigen::Vector3f mirrored(centre.x(), -hinge_ * centre.y(), centre.z());
    b_.Add(part, BoxMesh(mirrored, size), T_object_leaf_);
  }

  void AddBoard() {
    Add("leaf", {0, 0.5f * wide_m_, 0.5f * high_m_ + 0.004f}, {kLeafM, wide_m_, high_m_ - 0.008f});
  }

  // A raised field on one side (1: front), between shares of the width and of the height.
  void AddField(float side, const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
    const Eigen::Vector2f middle = 0.5f * (low + high);
    const Eigen::Vector2f size = high - low;
    Add("leaf", {side * 0.5f * kLeafM, middle.x() * wide_m_, middle.y() * high_m_},
        {2 * kRaisedM, size.x() * wide_m_, size.y() * high_m_});
  }

  void AddLever(float side) {
    const float lever = side * (0.5f * kLeafM + handle_m_ - 0.008f);
    Add("handle", {0.5f * (lever + side * 0.5f * kLeafM), wide_m_ - 0.06f, 1.03f},
        {std::abs(lever - side * 0.5f * kLeafM), 0.02f, 0.02f});
    Add("handle", {lever, wide_m_ - 0.11f, 1.03f}, {0.016f, 0.12f, 0.022f});
  }

  // An upright bar to pull.
  void AddBar(float side) {
    const float bar = side * (0.5f * kLeafM + handle_m_ - 0.008f);
    for (const float z : {0.85f, 1.35f}) {
      Add("handle", {0.5f * (bar + side * 0.5f * kLeafM), wide_m_ - 0.08f, z},
          {std::abs(bar - side * 0.5f * kLeafM), 0.02f, 0.02f});
    }
    Add("handle", {bar, wide_m_ - 0.08f, 1.1f}, {0.016f, 0.03f, 0.7f});
  }

 private:
  FurnitureBuilder& b_;
  const float wide_m_;
  const float high_m_;
  const float hinge_;
  const float handle_m_;
  Rigid3d T_object_leaf_;
};

// Two raised panels and a handle on each side.
void AddLeaf(FurnitureBuilder& b) {
  LeafBuilder leaf(b);
  const float wide = leaf.wide_m(), high = leaf.high_m();
  leaf.AddBoard();
  for (const float side : {-1.0f, 1.0f}) {
    const float face = side * (0.5f * kLeafM + 0.003f);
    leaf.Add("leaf", {face, 0.5f * wide, 0.26f * high}, {0.006f, wide - 0.24f, 0.32f * high});
    leaf.Add("leaf", {face, 0.5f * wide, 0.71f * high}, {0.006f, wide - 0.24f, 0.42f * high});
    leaf.AddLever(side);
  }
}

void BuildDoor(FurnitureBuilder& b) {
  AddDoorFrame(b);
  if (b.Number("leaf") > 0.5f) AddLeaf(b);
}

// Flush, with an upright bar.
void BuildFlushDoor(FurnitureBuilder& b) {
  AddDoorFrame(b);
  if (b.Number("leaf") < 0.5f) return;
  LeafBuilder leaf(b);
  leaf.AddBoard();
  for (const float side : {-1.0f, 1.0f}) leaf.AddBar(side);
}

// Six raised fields.
void BuildSixPanelDoor(FurnitureBuilder& b) {
  AddDoorFrame(b);
  if (b.Number("leaf") < 0.5f) return;
  LeafBuilder leaf(b);
  leaf.AddBoard();
  for (const float side : {-1.0f, 1.0f}) {
    for (const float left : {0.12f, 0.54f}) {
      leaf.AddField(side, {left, 0.08f}, {left + 0.34f, 0.36f});
      leaf.AddField(side, {left, 0.42f}, {left + 0.34f, 0.76f});
      leaf.AddField(side, {left, 0.82f}, {left + 0.34f, 0.94f});
    }
    leaf.AddLever(side);
  }
}

// Planks with gaps, held by two boards across.
void BuildPlankDoor(FurnitureBuilder& b) {
  AddDoorFrame(b);
  if (b.Number("leaf") < 0.5f) return;
  constexpr int kPlanks = 6;
  LeafBuilder leaf(b);
  leaf.AddBoard();
  for (const float side : {-1.0f, 1.0f}) {
    for (int i = 0; i < kPlanks; ++i) {
      const float left = static_cast<float>(i) / kPlanks;
      leaf.AddField(side, {left + 0.01f, 0.01f}, {left + 1.0f / kPlanks - 0.01f, 0.99f});
    }
    for (const float z : {0.2f, 0.8f}) {
      leaf.Add("frame", {side * (0.5f * kLeafM + 0.014f), 0.5f * leaf.wide_m(), z * leaf.high_m()},
               {0.02f, 0.96f * leaf.wide_m(), 0.12f});
    }
    leaf.AddLever(side);
  }
}

}  // namespace

std::vector<FurnitureKind> DoorKinds() {
  return {{"door",
           "door",
           Mount::kFloor,
           {0.15f, 1.1f, 2.1f},
           {{"frame", MakeMaterial("wood", {228, 226, 220}, 0.2f)},
            {"leaf", MakeMaterial("wood", {178, 134, 88}, 0.2f)},
            {"handle", MakeMaterial("metal", {150, 150, 150}, 0.5f)}},
           {{"leaf", {1, 0, 1}}, {"open_deg", {0, 0, 95}}, {"hinge_left", {1, 0, 1}}},
           BuildDoor}};
}

DesignTable DoorDesigns() {
  return {{"door",
           {{BuildSixPanelDoor, {0.15f, 1.1f, 2.1f}},
            {BuildFlushDoor, {0.15f, 1.1f, 2.1f}},
            {BuildPlankDoor, {0.15f, 1.1f, 2.1f}}}}};
}

}  // namespace semantic_slam
