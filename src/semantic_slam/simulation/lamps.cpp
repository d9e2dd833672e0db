#include "semantic_slam/simulation/lamps.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr float kGoldenRatio = 0.61803399f;
constexpr float kNegligible = 0.002f;   // half of one step of a dark pixel
constexpr float kNearlyThere = 0.999f;  // rays end before the lamp itself
constexpr float kNearestM = 0.1f;       // nearer to a lamp it gets no brighter

// Whether its light may be seen there, were nothing between.
bool MayReach(const Lamp& lamp, const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal) {
  return (lamp.centre_m() - position_m).norm() < 2.0f * lamp.side_m() ||
         lamp.Strength(position_m, normal) * lamp.radiant().maxCoeff() > kNegligible;
}

}  // namespace

Lamp::Lamp(const Light& light)
    : centre_m_(light.centre_m.cast<float>()),
      side_m_(static_cast<float>(light.side_m)),
      radiant_(light.radiant_rgb[2], light.radiant_rgb[1], light.radiant_rgb[0]) {
  // Every row and every column of the square has one point, so that the shadows of edges along the
  // walls are as smooth as others.
  for (int i = 0; i < kRaysPerPacket; ++i) {
    const float x = (i + 0.5f) / kRaysPerPacket - 0.5f;
    const float y = std::fmod((i + 0.5f) * kGoldenRatio, 1.0f) - 0.5f;
    points_m_[i] = centre_m_ + side_m_ * Eigen::Vector3f(x, y, 0.0f);
  }
}

float Lamp::StrengthFrom(const Eigen::Vector3f& lamp_point_m, const Eigen::Vector3f& position_m,
                         const Eigen::Vector3f& normal) const {
  const Eigen::Vector3f towards = lamp_point_m - position_m;
  const float squared_m2 = std::max(towards.squaredNorm(), kNearestM * kNearestM);
  const float cosines = std::max(towards.z(), 0.0f) * std::max(towards.dot(normal), 0.0f);
  return 4.0f * cosines / (squared_m2 * squared_m2);  // 4 m^2: 1 at 2 m
}

float Lamp::Strength(const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal) const {
  return StrengthFrom(centre_m_, position_m, normal);
}

std::array<float, kRaysPerPacket> Lamp::Aim(const Eigen::Vector3f& position_m,
                                            const Eigen::Vector3f& normal,
                                            RayPacket& packet) const {
  std::array<float, kRaysPerPacket> strengths{};
  packet.Clear();
  for (int i = 0; i < kRaysPerPacket; ++i) {
    strengths[i] = StrengthFrom(points_m_[i], position_m, normal) / kRaysPerPacket;
    packet.Set(i, position_m, points_m_[i] - position_m, kNearlyThere, kOpaque);
  }
  return strengths;
}

LampLight LightOf(const std::vector<Lamp>& lamps, const RayScene& scene,
                  const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal) {
  RayPacket packet;
  LampLight light;
  for (std::size_t lamp_index = 0; lamp_index < lamps.size(); ++lamp_index) {
    const Lamp& lamp = lamps[lamp_index];
    if (!MayReach(lamp, position_m, normal)) continue;
    const std::array<float, kRaysPerPacket> strengths = lamp.Aim(position_m, normal, packet);
    scene.FindOccluded(packet);
    float strength = 0.0f;
    for (int i = 0; i < kRaysPerPacket; ++i) {
      if (!packet.IsOccluded(i)) strength += strengths[i];
    }
    if (strength <= 0.0f) continue;
    light.irradiance += strength * lamp.radiant();
    light.lamps |= OnlyLamp(lamp_index);
  }
  return light;
}

float VisibleShare(const Lamp& lamp, const RayScene& scene, const Eigen::Vector3f& position_m) {
  RayPacket packet;
  lamp.Aim(position_m, Eigen::Vector3f::UnitZ(), packet);
  scene.FindOccluded(packet);
  int visible = 0;
  for (int i = 0; i < kRaysPerPacket; ++i) visible += packet.IsOccluded(i) ? 0 : 1;
  return static_cast<float>(visible) / kRaysPerPacket;
}

}  // namespace semantic_slam
