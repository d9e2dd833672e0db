#pragma once

#include <vector>

#include <Eigen/Core>

#include "semantic_slam/simulation/lamps.h"
#include "semantic_slam/simulation/light_gather.h"
#include "semantic_slam/simulation/ray_scene.h"
#include "semantic_slam/simulation/scene_triangles.h"
#include "semantic_slam/worlds/texture.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// How a material mirrors lamps.
struct Polish {
  float strength = 0.0f;      // of a highlight in its middle
  float exponent = 1.0f;      // the greater, the smaller highlights are
  float least_cosine = 1.0f;  // between lamp and mirrored ray; with less a highlight is too faint
};

// The looks of all materials of a world. Immutable, so safe from any thread.
class Shader {
 public:
  // Paints the materials, on all cores.
  explicit Shader(const World& world);

  // By material.
  const std::vector<Reflectance>& reflectances() const { return reflectances_; }

  // Light (blue, green, red; 1 is white paper in full light) that comes from a point of a surface
  // in the direction against `ray`, whose length is the distance. `pixel_m` is how wide the pixel
  // is at that distance. `irradiance` is all light on the point; `lamps` are mirrored in what is
  // polished, if they are not hidden in `scene`.
  Eigen::Vector3f LightFrom(const SurfacePoint& point, const Eigen::Vector3f& ray, float pixel_m,
                            const Eigen::Vector3f& irradiance, const std::vector<Lamp>& lamps,
                            const RayScene& scene) const;

 private:
  std::vector<Texture> textures_;
  std::vector<Reflectance> reflectances_;
  std::vector<Polish> polishes_;
};

}  // namespace semantic_slam
