#include "tools/network_evaluation_options.h"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/network_evaluation/model_classes.h"
#include "semantic_slam/network_evaluation/report_text.h"

namespace semantic_slam {

void DeclareNetworkEvaluation(CommandLine& command_line, const std::string& splits,
                              NetworkEvaluationOptions& options) {
  command_line.Arguments("SET", &options.sets, "folder with images and their truth");
  command_line.RequiredOption("card", "CARD.yaml", &options.card,
                              "the network's model card, docs/models.md");
  command_line.Option("classes", "CLASSES.yaml", &options.classes,
                      "classes, labels that count as another one, and by that those that do not "
                      "count, as training/classes has them; default: all labels that the card's "
                      "classes map to");
  command_line.Option("output", "FOLDER", &options.output,
                      "write the results as JSON and pictures there");
  command_line.Option("split", splits, &options.split, "of sets that say so themselves");
  command_line.Option("images", "N", &options.images,
                      "take at most N images, evenly spread; 0: all");
  command_line.Option("models", "FOLDER", &options.models,
                      "where the card's files are looked for first");
  command_line.Option("labels", "LABELS.yaml", &options.labels,
                      "the vocabulary; default: config/labels.yaml");
  command_line.Option("backend", "cpu|cuda|cuda_fp16", &options.network.backend,
                      "what runs the network");
  command_line.Option("threads", "N", &options.network.threads, "of OpenCV; 0: as it likes");
  command_line.Flag("json", &options.json, "print JSON instead of a table");
}

void CheckNetworkEvaluation(const NetworkEvaluationOptions& options,
                            const std::vector<std::string>& splits) {
  CheckInRange("--images", options.images, 0, 100000000);
  CheckInRange("--threads", options.network.threads, 0, 256);
  if (std::find(splits.begin(), splits.end(), options.split) != splits.end()) return;
  std::string expected;
  for (const std::string& split : splits) expected += (expected.empty() ? "" : " or ") + split;
  throw ConfigError("--split = " + options.split + ", expected " + expected);
}

ClassList FindClasses(const NetworkEvaluationOptions& options, const Model& model,
                      const LabelVocabulary& vocabulary) {
  return options.classes ? ReadClassList(*options.classes, vocabulary)
                         : ClassesOfModel(model, vocabulary);
}

std::string ExampleTitle(const Example& example, const std::string& unit,
                         const std::string& image_path) {
  return example.name + ": " + unit + " " + PercentText(example.score) + ", " +
         std::filesystem::path(image_path).filename().string();
}

void WriteJson(const nlohmann::ordered_json& json, const std::string& path) {
  WriteFileAtomically(path, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

}  // namespace semantic_slam
