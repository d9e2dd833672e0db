#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// A line of a text file in YOLO's format.
struct FileBox {
  int class_number = 0;
  cv::Rect2f box;  // [px]; (0, 0) is the centre of the top left pixel
  double visible_share = 1.0;
};

// Reads lines "class cx cy width height" in shares of the image's size, behind which the visible
// share of the object may stand, or "class x y x y x y..." of a polygon, of which the box around it
// counts. Boxes are cut at the image's edges and may be
// empty then. No boxes if there is no such file. Throws InputError naming file and line of anything
// else.
std::vector<FileBox> ReadBoxFile(const std::string& path, cv::Size image);

}  // namespace semantic_slam
