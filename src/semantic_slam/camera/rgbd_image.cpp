#include "semantic_slam/camera/rgbd_image.h"

#include <sstream>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {

void CheckRgbdImage(const RgbdImage& image) {
  std::ostringstream what;
  if (image.colour.empty() || image.depth_m.empty()) {
    what << (image.colour.empty() ? "colour" : "depth") << " image is empty";
  } else if (image.colour.type() != CV_8UC3) {
    what << "colour image is " << cv::typeToString(image.colour.type()) << ", expected CV_8UC3";
  } else if (image.depth_m.type() != CV_32FC1) {
    what << "depth image is " << cv::typeToString(image.depth_m.type())
         << ", expected CV_32FC1 [m]";
  } else if (image.colour.size() != image.depth_m.size()) {
    what << "depth image is " << image.depth_m.size() << " but colour image is "
         << image.colour.size() << "; is depth registered to colour?";
  } else {
    return;
  }
  throw InputError(what.str());
}

void CheckRgbdImage(const RgbdImage& image, const CameraModel& camera) {
  CheckRgbdImage(image);
  if (camera.Contains(image.colour)) return;
  std::ostringstream what;
  what << "image is " << image.colour.size() << " but the camera's calibration is for ["
       << camera.width_px() << " x " << camera.height_px() << "]";
  throw InputError(what.str());
}

}  // namespace semantic_slam
