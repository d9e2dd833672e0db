#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace semantic_slam {

// What an image looks like if the camera takes in more or less of each colour's light, as by
// another exposure or white balance: `gains_bgr` are factors of the light. Precondition: `colour`
// is CV_8UC3 in BGR, from the renderer, without noise.
cv::Mat Expose(const cv::Mat& colour, const Eigen::Vector3f& gains_bgr);

// The factor of light that brings the mean pixel of an image near `mean_pixel`, 1..254.
float ExposureFor(const cv::Mat& colour, float mean_pixel);

}  // namespace semantic_slam
