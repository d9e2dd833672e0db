#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// What non-maximum suppression needs to know of a box.
struct ScoredBox {
  cv::Rect2f box;
  float score = 0.0f;
  int group = 0;  // boxes suppress those of their own group only
};

// Greedy non-maximum suppression: the indices of the boxes to keep, by descending score, of equal
// ones the first one first. A box goes if it overlaps a kept one of its group by more than
// `max_overlap` (intersection over union).
std::vector<int> SuppressNonMaxima(const std::vector<ScoredBox>& boxes, double max_overlap);

}  // namespace semantic_slam
