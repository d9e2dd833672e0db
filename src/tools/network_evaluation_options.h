#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model.h"
#include "semantic_slam/dnn/network.h"
#include "semantic_slam/network_evaluation/example_choice.h"
#include "tools/command_line.h"

// What evaluate_segmentation and evaluate_detection have in common.

namespace semantic_slam {

struct NetworkEvaluationOptions {
  std::vector<std::string> sets;
  std::string card;
  std::string models;
  std::string labels;
  std::optional<std::string> classes;
  std::optional<std::string> output;
  std::string split;
  int images = 0;
  NetworkOptions network;
  bool json = false;
};

// Declares them; `options` must outlive Parse(). What it holds of `split` is the default.
void DeclareNetworkEvaluation(CommandLine& command_line, const std::string& splits,
                              NetworkEvaluationOptions& options);

// Throws ConfigError if one is out of range or `split` is none of `splits`.
void CheckNetworkEvaluation(const NetworkEvaluationOptions& options,
                            const std::vector<std::string>& splits);

// The classes of the file, or without one those of the network.
ClassList FindClasses(const NetworkEvaluationOptions& options, const Model& model,
                      const LabelVocabulary& vocabulary);

// "median: 78.1 % of the pixels, rgb/12.png", say.
std::string ExampleTitle(const Example& example, const std::string& unit,
                         const std::string& image_path);

// Writes the file whole or not at all. Throws InputError if it cannot be written.
void WriteJson(const nlohmann::ordered_json& json, const std::string& path);

}  // namespace semantic_slam
