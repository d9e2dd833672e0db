#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/simulation/still_scene.h"

namespace semantic_slam {

// How a material throws light back, on average.
struct Reflectance {
  Eigen::Vector3f colour;  // blue, green, red; 0..1
  float brightness;        // as Material::brightness
};

// Light that a white surface of brightness 1 gives off, as irradiance on one of brightness 0.
constexpr float kShiningLight = 1.3f;

// Indirect light on a place.
struct GatheredLight {
  Eigen::Vector3f irradiance = Eigen::Vector3f::Zero();
  float in_the_open = 1.0f;  // share of directions that do not end at the inside of a solid
};

// Finds the light that reaches a place from surfaces that stand still, once reflected, and from
// everywhere. Safe from any thread.
class LightGatherer {
 public:
  // `ambient`: the light from everywhere (blue, green, red); `reflectances` are by material. Both
  // `scene` and they must live as long as this does.
  LightGatherer(const StillScene& scene, const std::vector<Reflectance>& reflectances,
                const Eigen::Vector3f& ambient)
      : scene_(scene), reflectances_(reflectances), ambient_(ambient) {}

  // What a surface with that normal gets there. Other seeds look in other directions.
  GatheredLight Gather(const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal,
                       std::uint64_t seed) const;

 private:
  // Light (blue, green, red) that comes along a ray, and whether it comes from a front.
  struct Arriving {
    Eigen::Vector3f light;
    bool in_the_open;
  };
  Arriving AlongRay(const RayPacket& packet, int lane, const Eigen::Vector3f& origin_m,
                    const Eigen::Vector3f& direction) const;

  const StillScene& scene_;
  const std::vector<Reflectance>& reflectances_;
  const Eigen::Vector3f ambient_;
};

}  // namespace semantic_slam
