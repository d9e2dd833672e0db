#include "semantic_slam/simulation/shader.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "semantic_slam/simulation/tone_curve.h"

namespace semantic_slam {
namespace {

constexpr float kNearlyThere = 0.999f;  // rays end before the lamp itself
constexpr float kSteepest = 0.15f;  // cosine at which a pixel is as long as it gets on a surface
constexpr float kLiftM = 0.002f;    // rays to lamps start that far above the surface
constexpr float kFaintest = 0.02f;  // highlights fainter than that are not looked into
constexpr float kHighlight = 0.6f;  // of a polished surface, in its middle
constexpr float kDullExponent = 12.0f;       // how wide a highlight is: on dull things,
constexpr float kPolishedExponent = 180.0f;  // on polished ones

std::vector<Texture> Paint(const std::vector<Material>& materials) {
  std::vector<std::optional<Texture>> painted(materials.size());
  cv::parallel_for_({0, static_cast<int>(materials.size())}, [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) painted[i].emplace(materials[i]);
  });
  std::vector<Texture> textures;
  for (std::optional<Texture>& texture : painted) textures.push_back(std::move(*texture));
  return textures;
}

Eigen::Vector3f MeanColour(const Texture& texture) {
  const cv::Scalar mean = cv::mean(texture.image());
  return ToneCurve::Linear(
      {static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2])});
}

Polish PolishOf(const Material& material) {
  Polish polish;
  polish.strength = kHighlight * material.gloss;
  polish.exponent =
      kDullExponent + material.gloss * material.gloss * (kPolishedExponent - kDullExponent);
  if (polish.strength > kFaintest) {
    polish.least_cosine = std::pow(kFaintest / polish.strength, 1.0f / polish.exponent);
  }
  return polish;
}

// The direction to the place of a lamp that is nearest to being mirrored.
Eigen::Vector3f TowardsLamp(const Lamp& lamp, const Eigen::Vector3f& position_m,
                            const Eigen::Vector3f& mirrored) {
  Eigen::Vector3f towards = lamp.centre_m() - position_m;
  if (mirrored.z() > 1e-3f && towards.z() > 0.0f) {
    const Eigen::Vector3f on_plane = mirrored * (towards.z() / mirrored.z());
    const float half_m = 0.5f * lamp.side_m();
    for (int axis = 0; axis < 2; ++axis) {
      towards[axis] = std::clamp(on_plane[axis], towards[axis] - half_m, towards[axis] + half_m);
    }
  }
  return towards;
}

// The lamps as a polished surface mirrors them (Phong 1975).
Eigen::Vector3f Highlights(const std::vector<Lamp>& lamps, const RayScene& scene,
                           const SurfacePoint& point, const Eigen::Vector3f& direction,
                           const Polish& polish) {
  const Eigen::Vector3f mirrored = direction - 2.0f * direction.dot(point.normal) * point.normal;
  const Eigen::Vector3f start_m = point.position_m + kLiftM * point.normal;
  Eigen::Vector3f light = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    if ((point.triangle->lamps & OnlyLamp(i)) == 0) continue;
    const Lamp& lamp = lamps[i];
    const Eigen::Vector3f towards = TowardsLamp(lamp, point.position_m, mirrored);
    if (towards.z() <= 0.0f || towards.dot(point.normal) <= 0.0f) continue;
    const float cosine = mirrored.dot(towards) / towards.norm();
    if (cosine < polish.least_cosine) continue;
    if (scene.IsOccluded(start_m, towards, kNearlyThere)) continue;
    light += polish.strength * std::pow(cosine, polish.exponent) * lamp.radiant();
  }
  return light;
}

}  // namespace

Shader::Shader(const World& world) : textures_(Paint(world.materials)) {
  for (std::size_t i = 0; i < textures_.size(); ++i) {
    reflectances_.push_back({MeanColour(textures_[i]), world.materials[i].brightness});
    polishes_.push_back(PolishOf(world.materials[i]));
  }
}

Eigen::Vector3f Shader::LightFrom(const SurfacePoint& point, const Eigen::Vector3f& ray,
                                  float pixel_m, const Eigen::Vector3f& irradiance,
                                  const std::vector<Lamp>& lamps, const RayScene& scene) const {
  const Eigen::Vector3f direction = ray.normalized();
  const float cosine = std::max(-direction.dot(point.normal), kSteepest);
  const int material = point.surface->material;
  const float brightness = reflectances_[material].brightness;
  const Eigen::Vector3f colour = ToneCurve::Linear(textures_[material].Sample(
      point.texture_m.x(), point.texture_m.y(), pixel_m / std::sqrt(cosine)));
  const Eigen::Vector3f lit =
      (1.0f - brightness) * irradiance + Eigen::Vector3f::Constant(brightness * kShiningLight);
  Eigen::Vector3f light = colour.cwiseProduct(lit);
  if (polishes_[material].least_cosine < 1.0f) {
    light += Highlights(lamps, scene, point, direction, polishes_[material]);
  }
  return light;
}

}  // namespace semantic_slam
