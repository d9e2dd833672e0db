#pragma once

#include <opencv2/core.hpp>

#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/segmentation/segmentation.h"

namespace semantic_slam {

// A copy of `colour` for people to look at: tinted with the colour of each pixel's most probable
// label, and in the lower left corner a legend of the labels that cover at least half a percent of
// it, the largest first, as far as there is room. Throws InputError if the segmentation is not of
// the image's size or not of the vocabulary.
cv::Mat DrawSegmentation(const cv::Mat& colour, ColourOrder order, const Segmentation& segmentation,
                         const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
