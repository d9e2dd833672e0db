#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/simulation/ray_scene.h"
#include "semantic_slam/simulation/scene_triangles.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// A lamp, as seen from surfaces.
class Lamp {
 public:
  explicit Lamp(const Light& light);

  const Eigen::Vector3f& centre_m() const { return centre_m_; }
  float side_m() const { return side_m_; }
  const Eigen::Vector3f& radiant() const { return radiant_; }  // blue, green, red

  // Irradiance at a place of a surface with that normal if nothing is between, as a multiple of
  // radiant(): 1 on the floor 2 m below. From the lamp's middle, as if it were all there.
  float Strength(const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal) const;

  // Sets rays from a place of a surface to all of the lamp; returns by lane how much of Strength()
  // each of them stands for.
  std::array<float, kRaysPerPacket> Aim(const Eigen::Vector3f& position_m,
                                        const Eigen::Vector3f& normal, RayPacket& packet) const;

 private:
  float StrengthFrom(const Eigen::Vector3f& lamp_point_m, const Eigen::Vector3f& position_m,
                     const Eigen::Vector3f& normal) const;

  Eigen::Vector3f centre_m_;
  float side_m_;
  Eigen::Vector3f radiant_;
  std::array<Eigen::Vector3f, kRaysPerPacket> points_m_;  // spread evenly over the square
};

struct LampLight {
  Eigen::Vector3f irradiance = Eigen::Vector3f::Zero();  // blue, green, red
  LampSet lamps = 0;                                     // that it comes from
};

// The light of all `lamps` at a place of a surface, where `scene` throws its shadows.
LampLight LightOf(const std::vector<Lamp>& lamps, const RayScene& scene,
                  const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal);

// What of a lamp is in sight from a place in the air, 0 to 1.
float VisibleShare(const Lamp& lamp, const RayScene& scene, const Eigen::Vector3f& position_m);

}  // namespace semantic_slam
