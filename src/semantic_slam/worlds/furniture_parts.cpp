#include "semantic_slam/worlds/furniture_parts.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/shapes.h"

namespace semantic_slam {
namespace {

constexpr float kPi = 3.14159265f;

// A place on a line through points, 0 <= share <= 1, each stretch taking an equal part of it.
Eigen::Vector2f PlaceOn(const std::vector<Eigen::Vector2f>& line_m, float share) {
  const float along = share * static_cast<float>(line_m.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(along), line_m.size() - 2);
  return line_m[first] + (along - static_cast<float>(first)) * (line_m[first + 1] - line_m[first]);
}

}  // namespace

Rigid3d Turned(float angle_rad) {
  return Rigid3d(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()));
}

Rigid3d Leaning(const Eigen::Vector3f& at_m, float angle_rad) {
  Rigid3d T = Rigid3d(Eigen::Translation3d(at_m.cast<double>()));
  T.rotate(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()));
  return T;
}

void AddPadding(FurnitureBuilder& b, const std::string& part, const Eigen::Vector3f& low_m,
                const Eigen::Vector3f& high_m, float radius_m) {
  const Eigen::Vector3f size_m = high_m - low_m;
  b.Add(part, RoundedBoxMesh(0.5f * (low_m + high_m), size_m,
                             std::min(radius_m, 0.49f * size_m.minCoeff())));
}

void AddLegs(FurnitureBuilder& b, const std::string& part, float depth_m, float width_m,
             float height_m, float leg_m) {
  for (const float x : {-1.0f, 1.0f}) {
    for (const float y : {-1.0f, 1.0f}) {
      const Eigen::Vector3f head(x * 0.5f * (depth_m - leg_m), y * 0.5f * (width_m - leg_m),
                                 height_m);
      const Eigen::Vector3f foot(head.x(), head.y(), 0);
      b.Add(part, BeamMesh(foot, head, Eigen::Vector2f::Constant(0.75f * leg_m),
                           Eigen::Vector2f::Constant(leg_m)));
    }
  }
}

void AddSplayedLegs(FurnitureBuilder& b, const std::string& part, const Eigen::Vector2f& floor_m,
                    const Eigen::Vector2f& head_m, float height_m, float radius_m) {
  for (const float x : {-0.5f, 0.5f}) {
    AddTubePair(b, part,
                {{x * floor_m.x(), 0.5f * floor_m.y(), 0.7f * radius_m},
                 {x * head_m.x(), 0.5f * head_m.y(), height_m}},
                radius_m);
  }
}

void AddTube(FurnitureBuilder& b, const std::string& part,
             const std::vector<Eigen::Vector3f>& points_m, float radius_m) {
  constexpr int kSides = 8;
  Mesh tube;
  for (std::size_t i = 0; i + 1 < points_m.size(); ++i) {
    Append(tube, LimbMesh(points_m[i], points_m[i + 1], radius_m, radius_m, kSides));
  }
  b.Add(part, tube);
}

void AddTubePair(FurnitureBuilder& b, const std::string& part,
                 const std::vector<Eigen::Vector3f>& points_m, float radius_m) {
  std::vector<Eigen::Vector3f> mirrored_m = points_m;
  for (Eigen::Vector3f& point_m : mirrored_m) point_m.y() *= -1.0f;
  AddTube(b, part, points_m, radius_m);
  AddTube(b, part, mirrored_m, radius_m);
}

void AddStarFoot(FurnitureBuilder& b, const std::string& part, int arms, float radius_m,
                 float top_m) {
  constexpr float kArmM = 0.03f;
  for (int i = 0; i < arms; ++i) {
    const Mesh arm = BeamMesh({0.5f * radius_m, 0, 0}, {0.47f * radius_m, 0, kArmM},
                              {radius_m, 0.045f}, {0.9f * radius_m, 0.035f});
    b.Add(part, arm, Turned(2 * kPi * (static_cast<float>(i) + 0.5f) / arms));
  }
  b.Add(part, CylinderMesh({0, 0, 0.5f * kArmM}, 0.03f, 0.025f, top_m - 0.5f * kArmM, 12));
}

void AddCastorFoot(FurnitureBuilder& b, const std::string& part, float radius_m, float top_m) {
  for (int i = 0; i < 5; ++i) {
    Mesh arm = BoxMesh({0.5f * radius_m, 0, 0.09f}, {radius_m - 0.04f, 0.05f, 0.03f});
    b.Add(part, arm, Turned(2 * kPi * i / 5));
    Mesh castor = EllipsoidMesh({radius_m - 0.03f, 0, 0.035f}, {0.03f, 0.025f, 0.035f}, 12);
    Append(castor, CylinderMesh({radius_m - 0.03f, 0, 0.05f}, 0.012f, 0.012f, 0.045f, 8));
    b.Add(part, castor, Turned(2 * kPi * i / 5));
  }
  b.Add(part, CylinderMesh({0, 0, 0.075f}, 0.035f, 0.028f, top_m - 0.075f, 12));
}

void AddTableTop(FurnitureBuilder& b, float thickness_m) {
  b.Box("top", {-0.5f * b.depth(), -0.5f * b.width(), b.height() - thickness_m},
        {0.5f * b.depth(), 0.5f * b.width(), b.height()});
}

void AddShell(FurnitureBuilder& b, const std::string& part,
              const std::vector<Eigen::Vector2f>& profile_m, float width_m, float wrap_m) {
  constexpr float kHalfM = 0.007f;
  const Eigen::Vector3f forward = Eigen::Vector3f(1, 0, 1).normalized();
  const auto middle_m = [&](float u, float v) -> Eigen::Vector3f {
    const Eigen::Vector2f place_m = PlaceOn(profile_m, 1.0f - v);
    const float across = 2.0f * u - 1.0f;
    const float ends = 1.0f - 0.28f * std::pow(std::abs(2.0f * v - 1.0f), 3.0f);  // narrower
    const float wrapped_m = wrap_m * across * across * ends;
    return Eigen::Vector3f(place_m.x(), 0.5f * width_m * ends * across, place_m.y()) +
           wrapped_m * forward;
  };
  b.Add(part, SheetMesh(
                  middle_m, [](float, float) { return kHalfM; }, forward, 10,
                  3 * static_cast<int>(profile_m.size() - 1)));
}

}  // namespace semantic_slam
