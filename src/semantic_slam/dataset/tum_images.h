#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/dataset/problem_log.h"

// The images of a folder in the format of the TUM RGB-D benchmark, one by one.

namespace semantic_slam {

struct ImageFile {
  Stamp stamp;
  std::string path;
};

// Reads a list, rgb.txt or depth.txt, with lines "stamp filename". Sorted; of images with one stamp
// the first, the others go to `problems`. Throws InputError naming file and line if the list is
// missing or not understood.
std::vector<ImageFile> ReadImageList(const std::string& folder, const std::string& list,
                                     ProblemLog& problems);

// An 8-bit PNG or JPEG, CV_8UC3 in BGR. Throws InputError naming the file if it is missing, damaged
// or not of the camera's size.
cv::Mat LoadColour(const std::string& path, const CameraConfig& camera);

// A 16-bit PNG as depth [m], CV_32FC1, NaN where the file has 0. Throws InputError as above, and if
// the file is not of that type.
cv::Mat LoadDepthMetres(const std::string& path, const CameraConfig& camera);

}  // namespace semantic_slam
