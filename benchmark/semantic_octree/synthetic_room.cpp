#include "semantic_octree/synthetic_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/Geometry>

namespace semantic_slam::synthetic_room {
namespace {

enum Class : std::uint8_t {
  kWall = 1,
  kFloor,
  kCeiling,
  kTable,
  kChair,
  kCabinet,
  kBed,
  kDoor,
  kWindow,
  kSofa,
  kMonitor,
  kBox
};

using Rgb = std::array<std::uint8_t, 3>;

struct Box {
  std::array<float, 3> low;
  std::array<float, 3> high;
  std::uint8_t label;
  Rgb rgb;
};

constexpr std::array<float, 3> kRoomLow{-3.0f, -2.5f, 0.0f};
constexpr std::array<float, 3> kRoomHigh{3.0f, 2.5f, 2.6f};

// clang-format off
const std::array<Box, 30> kBoxes{{
    // A table in the middle, with a monitor and a box on it.
    {{-0.55f, -0.35f, 0.70f}, {0.55f, 0.35f, 0.74f}, kTable, {150, 100, 50}},
    {{-0.53f, -0.33f, 0.0f}, {-0.48f, -0.28f, 0.70f}, kTable, {150, 100, 50}},
    {{0.48f, -0.33f, 0.0f}, {0.53f, -0.28f, 0.70f}, kTable, {150, 100, 50}},
    {{-0.53f, 0.28f, 0.0f}, {-0.48f, 0.33f, 0.70f}, kTable, {150, 100, 50}},
    {{0.48f, 0.28f, 0.0f}, {0.53f, 0.33f, 0.70f}, kTable, {150, 100, 50}},
    {{-0.15f, 0.02f, 0.74f}, {0.25f, 0.10f, 1.05f}, kMonitor, {30, 30, 35}},
    {{-0.45f, -0.2f, 0.74f}, {-0.25f, 0.0f, 0.90f}, kBox, {200, 180, 140}},
    // A table at the wall.
    {{2.2f, -1.6f, 0.68f}, {2.95f, -0.3f, 0.72f}, kTable, {170, 120, 70}},
    {{2.22f, -1.58f, 0.0f}, {2.27f, -1.53f, 0.68f}, kTable, {170, 120, 70}},
    {{2.22f, -0.37f, 0.0f}, {2.27f, -0.32f, 0.68f}, kTable, {170, 120, 70}},
    {{2.7f, -1.2f, 0.72f}, {2.8f, -0.7f, 1.1f}, kMonitor, {25, 25, 30}},
    // Chairs on two posts each.
    {{1.55f, -1.2f, 0.42f}, {2.0f, -0.75f, 0.47f}, kChair, {40, 70, 150}},
    {{1.5f, -1.2f, 0.47f}, {1.55f, -0.75f, 0.95f}, kChair, {40, 70, 150}},
    {{1.57f, -1.18f, 0.0f}, {1.61f, -1.14f, 0.42f}, kChair, {40, 70, 150}},
    {{1.94f, -0.81f, 0.0f}, {1.98f, -0.77f, 0.42f}, kChair, {40, 70, 150}},
    {{-0.2f, -0.95f, 0.42f}, {0.25f, -0.5f, 0.47f}, kChair, {150, 60, 60}},
    {{-0.2f, -1.0f, 0.47f}, {0.25f, -0.95f, 0.95f}, kChair, {150, 60, 60}},
    {{-0.18f, -0.93f, 0.0f}, {-0.14f, -0.89f, 0.42f}, kChair, {150, 60, 60}},
    {{0.19f, -0.56f, 0.0f}, {0.23f, -0.52f, 0.42f}, kChair, {150, 60, 60}},
    // Cabinets, a bed, a sofa, boxes, a door and a window.
    {{-2.98f, 1.2f, 0.0f}, {-2.5f, 2.45f, 2.0f}, kCabinet, {110, 85, 60}},
    {{0.5f, 2.05f, 0.0f}, {1.8f, 2.48f, 0.9f}, kCabinet, {120, 95, 70}},
    {{-2.95f, -2.45f, 0.0f}, {-1.0f, -1.5f, 0.5f}, kBed, {220, 220, 230}},
    {{-2.95f, -2.45f, 0.5f}, {-2.6f, -1.5f, 0.62f}, kBed, {240, 240, 250}},
    {{2.2f, 0.6f, 0.0f}, {2.97f, 2.2f, 0.42f}, kSofa, {90, 110, 80}},
    {{2.75f, 0.6f, 0.42f}, {2.97f, 2.2f, 0.85f}, kSofa, {90, 110, 80}},
    {{0.9f, 2.1f, 0.9f}, {1.3f, 2.4f, 1.2f}, kBox, {190, 160, 110}},
    {{-2.9f, 0.2f, 0.0f}, {-2.4f, 0.7f, 0.45f}, kBox, {190, 160, 110}},
    {{-2.8f, 0.3f, 0.45f}, {-2.5f, 0.6f, 0.75f}, kBox, {180, 150, 100}},
    {{-0.9f, 2.44f, 0.0f}, {0.0f, 2.5f, 2.05f}, kDoor, {140, 90, 40}},
    {{-3.0f, -0.9f, 0.9f}, {-2.96f, 0.1f, 2.0f}, kWindow, {180, 210, 240}},
}};
// clang-format on

// What a ray of one pixel meets.
struct Surface {
  float depth_m;
  std::uint8_t label;
  Rgb rgb;
};

// A well-mixed function of its argument ("lowbias32").
std::uint32_t Hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}

std::uint32_t Hash(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return Hash(a + 0x9e3779b9U * Hash(b + 0x85ebca6bU * Hash(c + 0x27d4eb2fU)));
}

// 0..1, without 1.
float Unit(std::uint32_t hash) {
  return static_cast<float>(hash >> 8) * (1.0f / 16777216.0f);
}

void SetPose(int id, Frame& frame) {
  const auto pi = static_cast<float>(M_PI);
  const float t = 2.0f * pi * static_cast<float>(id) / static_cast<float>(kFrames);
  const float yaw = t + pi / 2.0f + 0.5f * std::sin(3.0f * t);
  const float pitch = -0.26f + 0.17f * std::sin(2.0f * t);
  const float cp = std::cos(pitch), sp = std::sin(pitch), cy = std::cos(yaw), sy = std::sin(yaw);
  const Eigen::Vector3f forward(cp * cy, cp * sy, sp), right(sy, -cy, 0.0f);
  const Eigen::Vector3f down(forward[1] * right[2] - forward[2] * right[1],
                             forward[2] * right[0] - forward[0] * right[2],
                             forward[0] * right[1] - forward[1] * right[0]);
  frame.id = id;
  frame.R_map_camera << right, down, forward;
  frame.position = {1.4f * std::cos(t), 1.25f * std::sin(t), 1.25f + 0.15f * std::sin(3.0f * t)};
}

Surface FindRoom(const Eigen::Vector3f& origin, const std::array<float, 3>& direction,
                 const std::array<float, 3>& inverse) {
  Surface surface{1e9f, kWall, {210, 205, 195}};
  int axis = 0;
  for (int k = 0; k < 3; ++k) {
    const float exit =
        ((direction[k] > 0.0f ? kRoomHigh[k] : kRoomLow[k]) - origin[k]) * inverse[k];
    if (exit < surface.depth_m) {
      surface.depth_m = exit;
      axis = k;
    }
  }
  if (axis == 2 && direction[2] > 0.0f) {
    surface.label = kCeiling;
    surface.rgb = {240, 240, 240};
  } else if (axis == 2) {
    surface.label = kFloor;
    surface.rgb = {120, 100, 85};
  }
  return surface;
}

Surface FindSurface(const Eigen::Vector3f& origin, const std::array<float, 3>& direction) {
  std::array<float, 3> inverse{};
  for (int k = 0; k < 3; ++k) inverse[k] = 1.0f / direction[k];
  Surface surface = FindRoom(origin, direction, inverse);
  for (const Box& box : kBoxes) {
    float enter = 0.02f, leave = surface.depth_m;
    for (int k = 0; k < 3; ++k) {
      float a = (box.low[k] - origin[k]) * inverse[k], b = (box.high[k] - origin[k]) * inverse[k];
      if (a > b) std::swap(a, b);
      enter = std::max(enter, a);
      leave = std::min(leave, b);
      if (enter > leave) break;
    }
    if (enter <= leave && enter < surface.depth_m) surface = {enter, box.label, box.rgb};
  }
  return surface;
}

// Calls visit(u, v, surface) for every pixel.
template <typename Visit>
void ForEachSurface(const Frame& frame, Visit&& visit) {
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const std::array<float, 3> ray{(static_cast<float>(u) - kCentreX) / kFocalLength,
                                     (static_cast<float>(v) - kCentreY) / kFocalLength, 1.0f};
      std::array<float, 3> direction{};
      for (int k = 0; k < 3; ++k) {
        direction[k] = frame.R_map_camera(k, 0) * ray[0] + frame.R_map_camera(k, 1) * ray[1] +
                       frame.R_map_camera(k, 2);
      }
      visit(u, v, FindSurface(frame.position, direction));
    }
  }
}

Rgb NoisyColour(int u, int v, int id, const Rgb& rgb) {
  const std::uint32_t hash = Hash(u, v, 7919u * id + 1);
  Rgb noisy{};
  for (int k = 0; k < 3; ++k) {
    const int value = rgb[k] + static_cast<int>((hash >> (8 * k)) & 15) - 8;
    noisy[k] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
  }
  return noisy;
}

// An Xtion's axial noise; NaN for one pixel of a hundred, and for what is too near.
float NoisyDepth(int u, int v, int id, float depth_m) {
  const std::uint32_t hash = Hash(u, v, 104729u * id + 2);
  const float sigma = 0.0012f + 0.0019f * (depth_m - 0.4f) * (depth_m - 0.4f);
  const float u1 = std::max(1e-7f, Unit(hash)), u2 = Unit(Hash(hash + 1));
  depth_m += sigma * std::sqrt(-2.0f * std::log(u1)) * std::cos(6.2831853f * u2);
  const bool is_dropped = Unit(Hash(hash + 2)) < 0.01f || depth_m < 0.4f;
  return is_dropped ? std::numeric_limits<float>::quiet_NaN() : depth_m;
}

int OtherClass(int label, std::uint32_t choice) {
  return 1 + (label + static_cast<int>(choice % (kClasses - 2))) % (kClasses - 1);
}

// The segmentation of the pixel's block of 8 x 8: some bleed from beside, some are wrong.
void Segment(int u, int v, const Frame& frame, SemanticPoint& point) {
  const std::uint32_t hash = Hash(u >> 3, v >> 3, 15485863u * frame.id + 3);
  const int from_u = std::clamp(u + static_cast<int>(hash % 9) - 4, 0, kWidth - 1);
  const int from_v = std::clamp(v + static_cast<int>((hash >> 8) % 9) - 4, 0, kHeight - 1);
  const int truth = frame.true_classes[from_v * kWidth + from_u];
  const int second = OtherClass(truth, hash >> 4);
  int third = OtherClass(truth, hash >> 14);
  for (const int taken : {second, truth, second}) {
    if (third == taken) third = 1 + third % (kClasses - 1);
  }
  const bool is_wrong = Unit(Hash(hash + 5)) < 0.15f;
  const float q = Unit(Hash(hash + 6));
  const float sure = is_wrong ? 0.40f + 0.25f * q : 0.55f + 0.35f * q;
  point.labels = {static_cast<LabelId>(is_wrong ? second : truth),
                  static_cast<LabelId>(is_wrong ? truth : second), static_cast<LabelId>(third)};
  point.confidences = {sure, (1.0f - sure) * 0.6f, (1.0f - sure) * 0.25f};
}

}  // namespace

Rigid3d Frame::T_map_camera() const {
  Rigid3d pose = Rigid3d::Identity();
  pose.linear() = R_map_camera.cast<double>();
  pose.translation() = position.cast<double>();
  return pose;
}

void RenderTruth(int id, Frame& frame) {
  SetPose(id, frame);
  frame.points.clear();
  frame.true_classes.resize(kWidth * kHeight);
  frame.true_depth_m.resize(kWidth * kHeight);
  ForEachSurface(frame, [&](int u, int v, const Surface& surface) {
    frame.true_classes[v * kWidth + u] = surface.label;
    frame.true_depth_m[v * kWidth + u] = surface.depth_m;
  });
}

void Render(int id, Frame& frame) {
  SetPose(id, frame);
  frame.true_classes.resize(kWidth * kHeight);
  frame.true_depth_m.resize(kWidth * kHeight);
  std::vector<Rgb> colours(kWidth * kHeight);
  ForEachSurface(frame, [&](int u, int v, const Surface& surface) {
    frame.true_classes[v * kWidth + u] = surface.label;
    frame.true_depth_m[v * kWidth + u] = surface.depth_m;
    colours[v * kWidth + u] = NoisyColour(u, v, id, surface.rgb);
  });
  frame.points.clear();
  frame.points.reserve(kWidth * kHeight);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const float z = NoisyDepth(u, v, id, frame.true_depth_m[v * kWidth + u]);
      if (std::isnan(z)) continue;
      SemanticPoint point;
      point.position = {(static_cast<float>(u) - kCentreX) / kFocalLength * z,
                        (static_cast<float>(v) - kCentreY) / kFocalLength * z, z};
      point.rgb = colours[v * kWidth + u];
      Segment(u, v, frame, point);
      frame.points.push_back(point);
    }
  }
}

LabelVocabulary Vocabulary() {
  const std::array<const char*, kClasses> names{"unknown", "wall",    "floor", "ceiling", "table",
                                                "chair",   "cabinet", "bed",   "door",    "window",
                                                "sofa",    "monitor", "box"};
  std::vector<LabelClass> classes(kClasses);
  for (int i = 0; i < kClasses; ++i) {
    classes[i].id = static_cast<LabelId>(i);
    classes[i].name = names[i];
    const std::uint32_t hash = Hash(static_cast<std::uint32_t>(i));
    classes[i].rgb = {static_cast<std::uint8_t>(hash), static_cast<std::uint8_t>(hash >> 8),
                      static_cast<std::uint8_t>(hash >> 16)};
  }
  return LabelVocabulary(std::move(classes));
}

}  // namespace semantic_slam::synthetic_room
