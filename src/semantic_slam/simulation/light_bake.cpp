#include "semantic_slam/simulation/light_bake.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "semantic_slam/common/random_stream.h"

namespace semantic_slam {
namespace {

constexpr float kLiftM = 0.002f;         // rays start that far above the surface
constexpr float kLeastReliance = 1e-3f;  // on light inside of solids, if there is none better

template <typename Function>
void ForEachInParallel(std::size_t count, const Function& function) {
  cv::parallel_for_({0, static_cast<int>(count)}, [&](const cv::Range& range) {
    for (int i = range.start; i < range.end; ++i) function(static_cast<std::size_t>(i));
  });
}

bool IsOnSurface(const LightSite& site) {
  return site.normal.squaredNorm() > 0.0f;
}

Eigen::Vector3f StartAbove(const LightSite& site) {
  return site.position_m + kLiftM * site.normal;
}

// Light inside of a solid is of no use to what is interpolated near it.
float Reliance(const GatheredLight& gathered) {
  return std::max(kLeastReliance, std::pow(gathered.in_the_open, 4.0f));
}

LightSample Weighted(const Eigen::Vector3f& irradiance, float reliance) {
  return reliance * irradiance.homogeneous();
}

std::vector<LampLight> DirectLight(const std::vector<Lamp>& lamps, const StillScene& scene) {
  const std::vector<LightSite>& sites = scene.sites();
  std::vector<LampLight> light(sites.size());
  ForEachInParallel(sites.size(), [&](std::size_t i) {
    if (!IsOnSurface(sites[i])) return;
    light[i] = LightOf(lamps, scene.rays(), StartAbove(sites[i]), sites[i].normal);
  });
  return light;
}

std::vector<LampSet> LampsOfParts(const std::vector<LampLight>& direct, const StillScene& scene) {
  std::vector<LampSet> lamps(scene.part_count(), 0);
  for (std::size_t i = 0; i < direct.size(); ++i) lamps[scene.site_parts()[i]] |= direct[i].lamps;
  return lamps;
}

std::vector<LightSample> IndirectLight(const LightGatherer& gatherer, const StillScene& scene) {
  const std::vector<LightSite>& sites = scene.sites();
  std::vector<LightSample> light(sites.size(), LightSample::Zero());
  ForEachInParallel(sites.size(), [&](std::size_t i) {
    if (!IsOnSurface(sites[i])) return;
    const GatheredLight gathered =
        gatherer.Gather(StartAbove(sites[i]), sites[i].normal, HashOf({i}));
    light[i] = Weighted(gathered.irradiance, Reliance(gathered));
  });
  return light;
}

void SmoothOnGrids(const StillScene& scene, std::vector<LightSample>& light) {
  const std::vector<std::size_t> ranges = scene.SiteRanges();
  ForEachInParallel(scene.grids().size(), [&](std::size_t i) {
    const LightGrid& grid = scene.grids()[i];
    Smooth(&light[ranges[i]], grid.columns(), grid.rows());
  });
}

}  // namespace

void BakeLight(const std::vector<Lamp>& lamps, const Eigen::Vector3f& ambient,
               const std::vector<Reflectance>& reflectances, StillScene& scene) {
  const std::vector<LampLight> direct = DirectLight(lamps, scene);
  scene.SetLamps(LampsOfParts(direct, scene));
  std::vector<LightSample> light(direct.size());
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = Weighted(direct[i].irradiance, 1.0f);
  scene.SetLight(light);
  light = IndirectLight(LightGatherer(scene, reflectances, ambient), scene);
  SmoothOnGrids(scene, light);
  for (std::size_t i = 0; i < light.size(); ++i) {
    light[i].head<3>() += light[i][3] * direct[i].irradiance;
  }
  scene.SetLight(light);
}

}  // namespace semantic_slam
