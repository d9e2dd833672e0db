#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// A picture and what it shows.
struct FigurePanel {
  std::string title;
  cv::Mat picture;  // CV_8UC3, BGR; of any size, not empty
};

// The pictures row by row in a figure of so many columns, each scaled as a whole into a panel of
// 640 x 480 px below its title. BGR. Thesis Fig. 4.7 is camera, segmentation, cloud and map in two
// columns.
cv::Mat ComposeFigure(const std::vector<FigurePanel>& panels, int columns);

}  // namespace semantic_slam
