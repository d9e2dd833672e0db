#pragma once

#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// How many labels are kept per pixel, point and voxel.
constexpr int kTopLabels = 3;

// The most probable labels of every pixel of one colour image, at that image's size (raw pixels).
// Plane 0 is the most probable one. The pixels are shared and never changed after construction.
struct Segmentation {
  Stamp stamp;  // the colour image's
  std::uint64_t vocabulary_hash = 0;
  std::array<cv::Mat, kTopLabels> labels;       // H x W, CV_8UC1, label ids
  std::array<cv::Mat, kTopLabels> confidences;  // H x W, CV_8UC1, floor(255 p), see ToByte()

  cv::Size size() const { return labels[0].size(); }
};

// A probability as one byte, as the messages carry it: floor(255 p).
inline std::uint8_t ToByte(float probability) {
  return static_cast<std::uint8_t>(255.0f * probability);
}

// What a network that is sure would give: `labels` (H x W, CV_8UC1, label ids), which are shared, with
// confidence 1 and no second choice.
Segmentation SureSegmentation(const cv::Mat& labels, Stamp stamp, std::uint64_t vocabulary_hash);

// Throws InputError, naming what is wrong, if the planes are empty, differ in size or type, if the
// hash is not the vocabulary's or a label id is not in it.
void CheckSegmentation(const Segmentation& segmentation, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
