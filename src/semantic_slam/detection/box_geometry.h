#pragma once

#include <opencv2/core.hpp>

#include "semantic_slam/dnn/model_card.h"

namespace semantic_slam {

// What one unit of the card's box coordinates is in pixels of the network's input.
cv::Size2f UnitOf(const ModelCard& card);

// From four numbers of a network: x min, y min, x max, y max.
cv::Rect2f BoxOfCorners(const float* values, cv::Size2f unit);
// From centre x, centre y, width, height.
cv::Rect2f BoxOfCentre(const float* values, cv::Size2f unit);

// Whether the box is finite and has an area.
bool IsUsable(const cv::Rect2f& box);

// Share of the union of two boxes that both cover, 0..1; 0 for empty ones.
double IntersectionOverUnion(const cv::Rect2f& a, const cv::Rect2f& b);

}  // namespace semantic_slam
