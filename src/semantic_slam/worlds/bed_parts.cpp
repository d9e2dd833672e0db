#include "semantic_slam/worlds/bed_parts.h"

#include "semantic_slam/worlds/furniture_parts.h"

namespace semantic_slam {

void AddBedding(FurnitureBuilder& b, float head_m, float foot_m, float width_m, float low_m) {
  const float top_m = b.Number("mattress_top_m");
  const float half = 0.5f * width_m;
  AddPadding(b, "mattress", {head_m, -half, low_m}, {foot_m, half, top_m}, 0.05f);
  const float duvet = head_m + 0.3f * (foot_m - head_m);
  AddPadding(b, "duvet", {duvet, -half - 0.02f, low_m + 0.5f * (top_m - low_m)},
             {foot_m + 0.01f, half + 0.02f, top_m + 0.05f}, 0.05f);
  AddPadding(b, "mattress", {duvet - 0.02f, -half, top_m + 0.01f},
             {duvet + 0.2f, half, top_m + 0.062f}, 0.024f);
}

}  // namespace semantic_slam
