#include "semantic_slam/detection/non_maximum_suppression.h"

#include <algorithm>
#include <numeric>

#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {

std::vector<int> SuppressNonMaxima(const std::vector<ScoredBox>& boxes, double max_overlap) {
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return boxes[a].score > boxes[b].score; });
  std::vector<int> kept;
  for (const int i : order) {
    const bool suppressed = std::any_of(kept.begin(), kept.end(), [&](int j) {
      return boxes[j].group == boxes[i].group &&
             IntersectionOverUnion(boxes[j].box, boxes[i].box) > max_overlap;
    });
    if (!suppressed) kept.push_back(i);
  }
  return kept;
}

}  // namespace semantic_slam
