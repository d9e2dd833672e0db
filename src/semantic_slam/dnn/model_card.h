#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/dnn/image_fit.h"

namespace semantic_slam {

// What a network wants to see: a blob of 1 x 3 x height_px x width_px in which every value is
// (grey level * scale - mean) / std, channels in the order of `colour`.
struct NetworkInput {
  std::string name;  // of the blob; empty: the network's only one
  int width_px = 0;
  int height_px = 0;
  ColourOrder colour = ColourOrder::kRgb;
  double scale = 1.0;
  std::array<double, 3> mean{0.0, 0.0, 0.0};
  std::array<double, 3> std{1.0, 1.0, 1.0};
  FitMode fit = FitMode::kLetterbox;
  int pad = 0;  // grey level around the image under kLetterbox

  cv::Size size() const { return {width_px, height_px}; }
};

enum class HeadType {
  kSegmentation,  // 1 x K x h x w scores
  kYolo,          // rows of box and class scores
  kSsd,           // 1 x 1 x N x 7 rows, as Caffe's DetectionOutput layer gives them
  kReid,          // one vector per crop
};

enum class BoxFormat { kCxcywh, kXyxy };
enum class BoxUnits { kPixels, kNormalised };  // of the network's input; or a share of its size
enum class Activation { kNone, kSoftmax, kSigmoid };  // still to be applied to the scores

enum class Objectness {
  kNone,      // a row is box and class scores
  kSeparate,  // column 4 is a score of its own, to be multiplied with the class scores
  kIncluded,  // column 4 is one, and the class scores contain it already
};

// What the network gives.
struct NetworkHead {
  HeadType type = HeadType::kSegmentation;
  BoxFormat box = BoxFormat::kCxcywh;
  BoxUnits units = BoxUnits::kPixels;
  Objectness objectness = Objectness::kNone;
  bool transposed = false;  // 1 x columns x N instead of 1 x N x columns
  Activation activation = Activation::kNone;
  // Of raw grids, one entry per output: pixels per cell, and width and height [px] of each anchor.
  // Empty: boxes are decoded already.
  std::vector<float> strides;
  std::vector<std::vector<cv::Size2f>> anchors;
};

// A model card: everything that must be known of a network to run it, docs/models.md.
struct ModelCard {
  std::string path;  // of the card itself
  std::string file;  // ONNX; or Darknet .cfg, with the .weights of the same name beside it
  NetworkInput input;
  std::vector<std::string> outputs;  // names; empty: all, in the network's order
  NetworkHead head;
  std::string labels_file;                       // a class name per line; empty for kReid
  std::map<std::string, std::string> label_map;  // the network's class name -> vocabulary's name
  std::string licence;                           // of the weights
  std::string sha256;                            // of the weights' file; empty: not checked
};

// Reads and checks the card alone; the files that it names are not looked at. Throws ConfigError
// naming file, line and key.
ModelCard ReadModelCard(const std::string& path);

}  // namespace semantic_slam
