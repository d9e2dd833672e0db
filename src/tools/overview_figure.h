#pragma once

#include <array>
#include <string>

#include <opencv2/core.hpp>

namespace semantic_slam {

// A picture and what it shows.
struct FigurePanel {
  std::string title;
  cv::Mat picture;  // CV_8UC3, BGR; of any size, not empty
};

// Thesis Fig. 4.7: camera, segmentation, cloud and map in a two by two figure, each scaled as a whole
// into a panel of 640 x 480 px below its title. BGR.
cv::Mat ComposeOverview(const std::array<FigurePanel, 4>& panels);

}  // namespace semantic_slam
