#pragma once

#include <array>

#include <opencv2/core.hpp>

#include "semantic_slam/dnn/model_card.h"

namespace semantic_slam {

// Turns colour images into a network's input blob: resizes (bilinear), pads, orders the channels
// and scales the grey levels. Not thread-safe: it keeps its buffers.
class InputBlob {
 public:
  explicit InputBlob(const NetworkInput& input);

  // 1 x 3 x height x width, CV_32F; valid until the next call. Throws InputError if the image is
  // empty or not CV_8UC3.
  const cv::Mat& Make(const cv::Mat& image, ColourOrder order);

 private:
  using Table = std::array<float, 256>;

  // Fills `fitted_`, height x width, CV_8UC3.
  void Fit(const cv::Mat& image);
  void FillPlane(int channel, const Table& table, float* plane) const;

  const NetworkInput input_;
  std::array<Table, 3> tables_{};  // per channel of the blob: the value of every grey level
  cv::Mat fitted_;
  cv::Mat blob_;
};

}  // namespace semantic_slam
