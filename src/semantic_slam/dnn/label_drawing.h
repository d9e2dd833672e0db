#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/label_vocabulary.h"

// What the pictures for people have in common. Sizes are pixels.

namespace semantic_slam {

constexpr int kTagHeightPx = 18;

// The label's colour, in the channel order of the picture.
cv::Scalar ColourOf(const LabelClass& label, ColourOrder order);

// Width of the tag that DrawTag() makes of `text`.
int TagWidthPx(const std::string& text);

// A filled rectangle of `colour` with `text` (ASCII) in black or white, whichever can be read on
// it. `corner` is its top left one. What lies off the picture is cut.
void DrawTag(cv::Mat& picture, cv::Point corner, const std::string& text, const cv::Scalar& colour);

}  // namespace semantic_slam
