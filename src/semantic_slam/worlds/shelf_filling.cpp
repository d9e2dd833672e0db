#include "semantic_slam/worlds/shelf_filling.h"

#include <algorithm>

namespace semantic_slam {

void FillWithBooks(FurnitureBuilder& b, const ShelfSpace& space) {
  const float rise_m = space.high_m - space.low_m;
  float y = space.left_m - 0.01f;  // from left to right as seen from the front
  while (y - space.right_m > 0.1f) {
    const float width_m = std::min(b.Random(0.12f, 0.38f), y - space.right_m - 0.01f);
    const float height_m = std::min(b.Random(0.19f, 0.3f), rise_m - 0.02f);
    const float depth_m = std::min(b.Random(0.14f, 0.24f), space.front_m - space.rear_m - 0.01f);
    const float front = space.front_m - b.Random(0.01f, 0.05f);
    const float kind = b.Random(0, 1);
    const Eigen::Vector3f low(std::max(front - depth_m, space.rear_m), y - width_m, space.low_m);
    if (kind < 0.72f) {
      b.BoxWithPicture("paper", "books", low, {front, y, space.low_m + height_m});
    } else if (kind < 0.86f) {  // lying
      b.BoxWithPicture("paper", "books", low, {front, y, space.low_m + 0.35f * height_m});
    }
    y -= width_m + (kind > 0.6f ? b.Random(0.02f, 0.1f) : 0.004f);
  }
}

}  // namespace semantic_slam
