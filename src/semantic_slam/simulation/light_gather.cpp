#include "semantic_slam/simulation/light_gather.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/common/random_stream.h"

namespace semantic_slam {
namespace {

constexpr int kPackets = 2;             // of rays per place
constexpr float kAmbientReachM = 1.5f;  // surfaces nearer than that take light from everywhere away
constexpr float kGoldenRatio = 0.61803399f;

// Directions about z, more of them near it, as the cosine.
Eigen::Vector3f CosineDirection(float u, float v) {
  const float radius = std::sqrt(u), angle = 2.0f * static_cast<float>(M_PI) * v;
  return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0f - u)};
}

Eigen::Matrix3f FrameAbout(const Eigen::Vector3f& normal) {
  Eigen::Matrix3f frame;
  frame.col(2) = normal;
  frame.col(0) = normal.unitOrthogonal();
  frame.col(1) = normal.cross(frame.col(0));
  return frame;
}

}  // namespace

GatheredLight LightGatherer::Gather(const Eigen::Vector3f& position_m,
                                    const Eigen::Vector3f& normal, std::uint64_t seed) const {
  constexpr int kRays = kPackets * kRaysPerPacket;
  const Eigen::Matrix3f frame = FrameAbout(normal);
  RandomStream random(seed);
  const auto shift_u = static_cast<float>(random.Uniform());
  const auto shift_v = static_cast<float>(random.Uniform());
  GatheredLight sum{Eigen::Vector3f::Zero(), 0.0f};
  for (int first = 0; first < kRays; first += kRaysPerPacket) {
    RayPacket packet;
    packet.Clear();
    std::array<Eigen::Vector3f, kRaysPerPacket> directions;
    for (int i = 0; i < kRaysPerPacket; ++i) {
      directions[i] =
          frame * CosineDirection((first + i + shift_u) / kRays,
                                  std::fmod((first + i) * kGoldenRatio + shift_v, 1.0f));
      packet.Set(i, position_m, directions[i]);
    }
    scene_.rays().FindHits(packet, false);
    for (int i = 0; i < kRaysPerPacket; ++i) {
      const Arriving arriving = AlongRay(packet, i, position_m, directions[i]);
      if (!arriving.in_the_open) continue;
      sum.irradiance += arriving.light;
      sum.in_the_open += 1.0f;
    }
  }
  sum.irradiance /= std::max(sum.in_the_open, 1.0f);
  sum.in_the_open /= kRays;
  return sum;
}

LightGatherer::Arriving LightGatherer::AlongRay(const RayPacket& packet, int lane,
                                                const Eigen::Vector3f& origin_m,
                                                const Eigen::Vector3f& direction) const {
  if (!packet.IsHit(lane)) return {ambient_, true};
  const float distance_m = packet.Distance(lane);
  const SurfacePoint there =
      scene_.PointAt(packet, lane, origin_m + distance_m * direction, direction);
  if (there.triangle->normal.cast<float>().dot(direction) > 0.0f) return {ambient_, false};
  const Reflectance& reflectance = reflectances_[there.surface->material];
  const Eigen::Vector3f irradiance =
      (1.0f - reflectance.brightness) * there.irradiance +
      Eigen::Vector3f::Constant(reflectance.brightness * kShiningLight);
  return {irradiance.cwiseProduct(reflectance.colour) +
              std::min(1.0f, distance_m / kAmbientReachM) * ambient_,
          true};
}

}  // namespace semantic_slam
