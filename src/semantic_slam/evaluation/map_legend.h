#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/evaluation/plot_canvas.h"

// What stands beside and below pictures of maps.

namespace semantic_slam {

struct LegendEntry {
  std::string name;
  cv::Scalar colour;  // BGR
};

// Entries below each other from `top_left` on, as many as fit into `height` [px].
void DrawLegend(const std::vector<LegendEntry>& entries, cv::Point2d top_left, double height,
                PlotCanvas& canvas);

// A bar of 1, 2 or 5 times a power of ten metres from `left_end` on, no longer than `room_px`.
void DrawScaleBar(double pixels_per_metre, double room_px, cv::Point2d left_end,
                  PlotCanvas& canvas);

}  // namespace semantic_slam
