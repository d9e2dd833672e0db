#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/dnn/dnn.hpp>

#include "semantic_slam/common/options.h"
#include "semantic_slam/dnn/image_fit.h"
#include "semantic_slam/dnn/input_blob.h"
#include "semantic_slam/dnn/model.h"

namespace semantic_slam {

struct NetworkOptions {
  std::string backend = "cpu";  // cpu, cuda or cuda_fp16
  int threads = 0;              // of OpenCV, and so of the whole process; 0 leaves them as they are

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("backend", self.backend);
    visit("threads", self.threads, 0, 256);
  }
};

using Shape = std::vector<int>;

// "1 x 32 x 120 x 160", and those of several outputs with commas between them.
std::string ToString(const Shape& shape);
std::string ToString(const std::vector<Shape>& shapes);

// A network that OpenCV runs. On the CPU its results do not depend on the number of threads. Not
// thread-safe: one thread at a time.
class Network {
 public:
  // Loads the network and runs it once on a grey image. Throws ConfigError naming the file if it
  // cannot be loaded or run, lacks an input or output of the card, or if this OpenCV has no such
  // backend.
  Network(const Model& model, const NetworkOptions& options);

  // What the network gives for one colour image, one CV_32F array per output of the card. They
  // belong to the network and are valid until the next call. Throws InputError if the image is
  // empty or not CV_8UC3, or the network fails on it.
  const std::vector<cv::Mat>& Forward(const cv::Mat& image, ColourOrder order);

  // Of the outputs at the first run; those of SSD change with the number of objects.
  const std::vector<Shape>& output_shapes() const { return output_shapes_; }

  // Where an image of that size lies in the network's input.
  ImageFit FitOf(cv::Size image) const { return ImageFit(image, input_.size(), input_.fit); }

 private:
  void Load(const Model& model, const NetworkOptions& options);

  const NetworkInput input_;
  std::vector<cv::String> output_names_;
  cv::dnn::Net net_;
  InputBlob blob_;
  std::vector<cv::Mat> outputs_;
  std::vector<Shape> output_shapes_;
};

}  // namespace semantic_slam
