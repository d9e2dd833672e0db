#include "semantic_slam/dnn/label_mapping.h"

#include <algorithm>
#include <string>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

void CheckMap(const Model& model, const LabelVocabulary& vocabulary) {
  for (const auto& [class_name, label_name] : model.card.label_map) {
    std::string entry = model.card.path + ": labels/map: '";
    entry.append(class_name).append(": ").append(label_name).append("': ");
    if (std::find(model.classes.begin(), model.classes.end(), class_name) == model.classes.end()) {
      throw ConfigError(entry + "no class of that name is in " + model.card.labels_file);
    }
    if (!vocabulary.Find(label_name)) {
      throw ConfigError(entry + "no label of that name is in the vocabulary");
    }
  }
}

}  // namespace

std::vector<LabelId> MapClassesToLabels(const Model& model, const LabelVocabulary& vocabulary) {
  CheckMap(model, vocabulary);
  std::vector<LabelId> labels;
  for (const std::string& name : model.classes) {
    const auto mapped = model.card.label_map.find(name);
    const auto label =
        vocabulary.Find(mapped == model.card.label_map.end() ? name : mapped->second);
    labels.push_back(label.value_or(kUnknownLabel));
  }
  return labels;
}

}  // namespace semantic_slam
