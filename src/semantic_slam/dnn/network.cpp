#include "semantic_slam/dnn/network.h"

#include <algorithm>

#include <opencv2/core/utility.hpp>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

struct Backend {
  const char* name;
  cv::dnn::Backend backend;
  cv::dnn::Target target;
};

constexpr Backend kBackends[] = {
    {"cpu", cv::dnn::DNN_BACKEND_OPENCV, cv::dnn::DNN_TARGET_CPU},
    {"cuda", cv::dnn::DNN_BACKEND_CUDA, cv::dnn::DNN_TARGET_CUDA},
    {"cuda_fp16", cv::dnn::DNN_BACKEND_CUDA, cv::dnn::DNN_TARGET_CUDA_FP16},
};

bool IsAvailable(const Backend& backend) {
  const auto targets = cv::dnn::getAvailableTargets(backend.backend);
  return std::find(targets.begin(), targets.end(), backend.target) != targets.end();
}

// OpenCV itself would fall back to the CPU.
const Backend& FindBackend(const std::string& name) {
  std::string available;
  for (const Backend& backend : kBackends) {
    if (!IsAvailable(backend)) continue;
    if (name == backend.name) return backend;
    available += (available.empty() ? "" : " or ") + std::string(backend.name);
  }
  throw ConfigError("backend = " + name + ", but must be one that this OpenCV has: " + available);
}

// What OpenCV says, as one line.
std::string OneLine(const cv::Exception& e) {
  std::string text = e.err;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Shape ShapeOf(const cv::Mat& array) {
  return Shape(array.size.p, array.size.p + array.dims);
}

std::string Joined(const std::vector<cv::String>& names) {
  std::string joined;
  for (const cv::String& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

}  // namespace

std::string ToString(const Shape& shape) {
  std::string text;
  for (const int size : shape) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text;
}

std::string ToString(const std::vector<Shape>& shapes) {
  std::string text;
  for (const Shape& shape : shapes) text += (text.empty() ? "" : ", ") + ToString(shape);
  return text;
}

Network::Network(const Model& model, const NetworkOptions& options)
    : input_(model.card.input), blob_(input_) {
  Load(model, Validated(options));
  const cv::Mat grey(input_.size(), CV_8UC3, cv::Scalar::all(128));
  try {
    for (const cv::Mat& output : Forward(grey, input_.colour)) {
      output_shapes_.push_back(ShapeOf(output));
    }
  } catch (const InputError& e) {
    throw ConfigError(model.card.path + ": " + model.network_path + " does not run: " + e.what() +
                      "; its outputs are: " + Joined(net_.getUnconnectedOutLayersNames()));
  }
}

void Network::Load(const Model& model, const NetworkOptions& options) {
  const Backend& backend = FindBackend(options.backend);
  if (options.threads > 0) cv::setNumThreads(options.threads);
  try {
    net_ = model.weights_path.empty()
               ? cv::dnn::readNetFromONNX(model.network_path)
               : cv::dnn::readNetFromDarknet(model.network_path, model.weights_path);
    net_.setPreferableBackend(backend.backend);
    net_.setPreferableTarget(backend.target);
  } catch (const cv::Exception& e) {
    throw ConfigError(model.card.path + ": cannot load " + model.network_path + ": " + OneLine(e));
  }
  output_names_.assign(model.card.outputs.begin(), model.card.outputs.end());
  if (output_names_.empty()) output_names_ = net_.getUnconnectedOutLayersNames();
}

const std::vector<cv::Mat>& Network::Forward(const cv::Mat& image, ColourOrder order) {
  try {
    net_.setInput(blob_.Make(image, order), input_.name);
    net_.forward(outputs_, output_names_);
  } catch (const cv::Exception& e) {
    throw InputError(OneLine(e));
  }
  return outputs_;
}

}  // namespace semantic_slam
