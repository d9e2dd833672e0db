#pragma once

#include <vector>

#include <Eigen/Core>

#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

// Light that falls on a place of a surface: irradiance (blue, green, red; 1 makes white paper
// white), times how far it can be relied on, which is the last element: little where nobody can
// look, as inside of a solid that stands there.
using LightSample = Eigen::Vector4f;

// Where light is to be found out, and which way the surface faces there.
struct LightSite {
  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;
};

// Light on a flat piece of surface: samples on a rectangular grid that covers it, in the world
// frame. Between them it is interpolated.
class LightGrid {
 public:
  // Preconditions: IsFlat(part); `spacing_m` is positive.
  LightGrid(const Mesh& part, float spacing_m);

  // One per sample; without a normal where the surface is not.
  std::vector<LightSite> Sites(const Mesh& part) const;

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::vector<LightSample>& samples() { return samples_; }
  const std::vector<LightSample>& samples() const { return samples_; }

  // Irradiance (blue, green, red) at a place on the surface.
  Eigen::Vector3f At(const Eigen::Vector3f& position_m) const;

 private:
  Eigen::Vector3f origin_m_;
  Eigen::Vector3f right_, up_;  // unit vectors in the plane
  Eigen::Vector3f normal_;
  Eigen::Vector2f extent_m_;  // along right and up
  Eigen::Vector2f samples_per_m_;
  int columns_ = 2;
  int rows_ = 2;
  std::vector<LightSample> samples_;  // row by row
};

// Softens what sampling leaves of noise: each sample becomes a mean of those around it, by how far
// they can be relied on.
void Smooth(LightSample* samples, int columns, int rows);

}  // namespace semantic_slam
