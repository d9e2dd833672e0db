#include "semantic_slam/network_evaluation/model_classes.h"

#include <cctype>
#include <set>
#include <vector>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dnn/label_mapping.h"

namespace semantic_slam {
namespace {

std::string PlainName(std::string name) {
  const auto first = name.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  name = name.substr(first, name.find_last_not_of(" \t") - first + 1);
  for (char& c : name) {
    c = c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

}  // namespace

ClassList ClassesOfModel(const Model& model, const LabelVocabulary& vocabulary) {
  const std::vector<LabelId> mapped = MapClassesToLabels(model, vocabulary);
  std::set<LabelId> labels(mapped.begin(), mapped.end());
  labels.erase(kUnknownLabel);
  if (labels.empty()) {
    throw ConfigError(model.card.path + ": none of its classes has a label of the vocabulary");
  }
  ClassList classes;
  for (const LabelId label : labels) classes.Add(vocabulary[label].name, label);
  return classes;
}

LabelId LabelOfName(const std::string& name, const ModelCard& card,
                    const LabelVocabulary& vocabulary) {
  const auto mapped = card.label_map.find(name);
  if (mapped != card.label_map.end()) {
    return vocabulary.Find(mapped->second).value_or(kUnknownLabel);
  }
  if (const auto label = vocabulary.Find(name)) return *label;
  return vocabulary.Find(PlainName(name)).value_or(kUnknownLabel);
}

}  // namespace semantic_slam
