#pragma once

#include <string>
#include <vector>

#include "semantic_slam/dnn/model_card.h"

namespace semantic_slam {

// A model card with its files found and verified.
struct Model {
  ModelCard card;
  std::string network_path;          // .onnx or .cfg
  std::string weights_path;          // .weights; empty for ONNX
  std::vector<std::string> classes;  // names in the order of the network's scores; empty for kReid
};

// Reads the card at `card_path` and finds its files, first in `models_folder` if that is not empty,
// then where ModelFolders() says. Throws ConfigError if the card is wrong, a file is not to be
// found or the weights are not those of the card's sha256.
Model LoadModel(const std::string& card_path, const std::string& models_folder = "");

}  // namespace semantic_slam
