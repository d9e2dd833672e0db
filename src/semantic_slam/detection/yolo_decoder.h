#pragma once

#include <vector>

#include "semantic_slam/detection/anchor_grid.h"
#include "semantic_slam/detection/box_decoder.h"

namespace semantic_slam {

// Decodes rows of four box coordinates, an objectness if the card has one, and a score per class:
// YOLO from version 3 on, and whatever else was exported so. The rows may come in several outputs
// one after the other (Darknet), in two side by side, boxes and scores, or as raw grids.
class YoloDecoder : public BoxDecoder {
 public:
  // Throws ConfigError if the shapes are not those that the card and its classes make.
  YoloDecoder(const Model& model, const std::vector<Shape>& shapes);

  std::vector<NetworkBox> Decode(const std::vector<cv::Mat>& outputs,
                                 float min_confidence) const override;

 private:
  void CheckShapes(const Model& model, const std::vector<Shape>& shapes);
  // N x columns_, CV_32F.
  cv::Mat Rows(const cv::Mat& output) const;
  void DecodeRows(const cv::Mat& rows, float min_confidence, std::vector<NetworkBox>& boxes) const;

  const NetworkHead head_;
  const int classes_;
  const int columns_;
  const cv::Size2f unit_;  // [px] of the network's input
  std::vector<AnchorGrid> grids_;
  bool side_by_side_ = false;  // boxes in the first output, scores in the second
};

}  // namespace semantic_slam
