#pragma once

#include <vector>

#include "semantic_slam/detection/box_decoder.h"

namespace semantic_slam {

// Decodes the rows [image, class, score, x min, y min, x max, y max] of Caffe's DetectionOutput
// layer (Liu et al., SSD, ECCV 2016), in which background is a class of its own, the first one.
class SsdDecoder : public BoxDecoder {
 public:
  // Throws ConfigError if the shapes are not one 1 x 1 x N x 7.
  SsdDecoder(const Model& model, const std::vector<Shape>& shapes);

  std::vector<NetworkBox> Decode(const std::vector<cv::Mat>& outputs,
                                 float min_confidence) const override;

 private:
  const int classes_;
  const cv::Size2f unit_;  // [px] of the network's input
};

}  // namespace semantic_slam
