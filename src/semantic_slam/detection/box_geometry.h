#pragma once

#include <optional>

#include <opencv2/core.hpp>

#include "semantic_slam/dnn/image_fit.h"
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

// The part of a network's box (see NetworkBox) that lies in the image: in its pixels, (0, 0) the
// centre of the top left one, so that the image reaches from -0.5 to width - 0.5 and height - 0.5.
// nullopt if no part does.
std::optional<cv::Rect2f> PartInImage(const cv::Rect2f& box, const ImageFit& fit, cv::Size image);

// Share of the union of two boxes that both cover, 0..1; 0 for empty ones.
double IntersectionOverUnion(const cv::Rect2f& a, const cv::Rect2f& b);

}  // namespace semantic_slam
