#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// Picks about `wanted` of the corners, spread evenly: the area is split into quarters until there
// are enough cells with a corner, and the strongest corner of each cell is kept. Deterministic; the
// result is in the order of the cells. Corners must lie in [0, size).
std::vector<cv::KeyPoint> SpreadByQuadtree(const std::vector<cv::KeyPoint>& corners, cv::Size size,
                                           int wanted);

}  // namespace semantic_slam
