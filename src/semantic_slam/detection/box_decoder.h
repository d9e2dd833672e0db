#pragma once

#include <memory>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/detection/network_box.h"
#include "semantic_slam/dnn/model.h"
#include "semantic_slam/dnn/network.h"

namespace semantic_slam {

// Reads boxes out of the outputs of one kind of detection network. Immutable, so safe from any
// thread.
class BoxDecoder {
 public:
  virtual ~BoxDecoder() = default;

  // The boxes with a confidence of at least `min_confidence`, in the order of the outputs' rows,
  // each with its best class. Rows whose score or box is not finite, or whose box is empty, are
  // left out.
  virtual std::vector<NetworkBox> Decode(const std::vector<cv::Mat>& outputs,
                                         float min_confidence) const = 0;
};

// The decoder for the model's head. Throws ConfigError if the card is not one of detection or the
// shapes are not what it says.
std::unique_ptr<BoxDecoder> MakeBoxDecoder(const Model& model, const std::vector<Shape>& shapes);

}  // namespace semantic_slam
