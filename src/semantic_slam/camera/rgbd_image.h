#pragma once

#include <opencv2/core.hpp>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

class CameraModel;

enum class ColourOrder { kBgr, kRgb };

// One colour image and the depth image registered to it, as the sensor delivered them: raw pixels,
// not undistorted. The pixels are shared and never changed after construction.
struct RgbdImage {
  Stamp stamp;        // colour's; the pair's stamp everywhere downstream
  Stamp depth_stamp;  // depth's own
  cv::Mat colour;     // H x W, CV_8UC3
  ColourOrder order = ColourOrder::kBgr;
  cv::Mat depth_m;  // H x W, CV_32FC1, metres along the optical axis; NaN where there is no return
};

// Throws InputError, naming both sizes or the type, if the two images do not fit together or have
// another type than stated above.
void CheckRgbdImage(const RgbdImage& image);

// The same, and throws InputError too if the images have another size than the camera's.
void CheckRgbdImage(const RgbdImage& image, const CameraModel& camera);

}  // namespace semantic_slam
