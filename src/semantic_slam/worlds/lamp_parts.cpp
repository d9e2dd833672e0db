#include "semantic_slam/worlds/lamp_parts.h"

namespace semantic_slam {

Mesh ShadeMesh(const Eigen::Vector3f& foot_m, float bottom_radius_m, float top_radius_m,
               float height_m) {
  constexpr float kPaperM = 0.004f;
  return LatheMesh(foot_m,
                   {{bottom_radius_m - kPaperM, 0},
                    {bottom_radius_m, 0},
                    {top_radius_m, height_m},
                    {top_radius_m - kPaperM, height_m},
                    {bottom_radius_m - kPaperM, 0}},
                   28);
}

void AddLightBelow(FurnitureBuilder& b, float side_m) {
  const float strength = b.Number("light");
  if (!(strength > 0.0f)) return;
  const Eigen::Vector3f rgb(1.0f, 0.95f, 0.86f);  // warm white
  b.AddLight({{0, 0, -0.03}, side_m, {strength * rgb.x(), strength * rgb.y(), strength * rgb.z()}});
}

}  // namespace semantic_slam
