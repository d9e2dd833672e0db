#include "semantic_slam/network_evaluation/class_list.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/dnn/label_mapping.h"

namespace semantic_slam {
namespace {

LabelId FindLabel(const std::string& path, const std::string& name,
                  const LabelVocabulary& vocabulary) {
  const std::optional<LabelId> label = vocabulary.Find(name);
  if (!label) throw ConfigError(path + ": '" + name + "' is no label of the vocabulary");
  return *label;
}

ClassList NoClasses() {
  ClassList classes;
  classes.of_label.fill(kIgnoredClass);
  return classes;
}

void AddClass(const std::string& name, LabelId label, ClassList& classes) {
  classes.of_label[label] = static_cast<int>(classes.size());
  classes.names.push_back(name);
  classes.labels.push_back(label);
}

// In the order of the file: of two entries for one label the later one holds.
void ReadMerge(const YAML::Node& merge, const std::string& path, const LabelVocabulary& vocabulary,
               ClassList& classes) {
  if (!merge || merge.IsNull()) return;
  if (!merge.IsMap()) throw ConfigError(path + ": merge must be a mapping of label: class");
  for (const auto& entry : merge) {
    const auto name = entry.first.as<std::string>("");
    const auto merged_into = entry.second.as<std::string>("");
    const auto found = std::find(classes.names.begin(), classes.names.end(), merged_into);
    if (found == classes.names.end()) {
      throw ConfigError(path + ": merge: '" + merged_into + "' is none of the classes");
    }
    classes.of_label[FindLabel(path, name, vocabulary)] =
        static_cast<int>(found - classes.names.begin());
  }
}

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

ClassList ReadClassList(const std::string& path, const LabelVocabulary& vocabulary) {
  YamlReader reader(LoadYamlMap(path), path);
  const auto names = reader.Require<std::vector<std::string>>("classes");
  YAML::Node merge;
  reader.Read("merge", merge);
  reader.Finish();
  if (names.empty() || std::set<std::string>(names.begin(), names.end()).size() != names.size()) {
    throw ConfigError(path + ": classes: expected one or more names, each once");
  }
  ClassList classes = NoClasses();
  for (const std::string& name : names) AddClass(name, FindLabel(path, name, vocabulary), classes);
  ReadMerge(merge, path, vocabulary, classes);
  return classes;
}

ClassList ClassesOfModel(const Model& model, const LabelVocabulary& vocabulary) {
  const std::vector<LabelId> mapped = MapClassesToLabels(model, vocabulary);
  std::set<LabelId> labels(mapped.begin(), mapped.end());
  labels.erase(kUnknownLabel);
  if (labels.empty()) {
    throw ConfigError(model.card.path + ": none of its classes has a label of the vocabulary");
  }
  ClassList classes = NoClasses();
  for (const LabelId label : labels) AddClass(vocabulary[label].name, label, classes);
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
