#include "semantic_slam/common/class_list.h"

#include <algorithm>
#include <optional>
#include <set>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"

namespace semantic_slam {
namespace {

LabelId FindLabel(const std::string& path, const std::string& name,
                  const LabelVocabulary& vocabulary) {
  const std::optional<LabelId> label = vocabulary.Find(name);
  if (!label) throw ConfigError(path + ": '" + name + "' is no label of the vocabulary");
  return *label;
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

void ReadOptional(const std::vector<std::string>& names, const std::string& path,
                  const LabelVocabulary& vocabulary, ClassList& classes) {
  for (const std::string& name : names) {
    const LabelId label = FindLabel(path, name, vocabulary);
    if (classes.of_label[label] != kIgnoredClass) {
      throw ConfigError(path + ": optional: '" + name +
                        "' is one of the classes or merged into one");
    }
    classes.is_optional[label] = true;
  }
}

}  // namespace

ClassList::ClassList() {
  of_label.fill(kIgnoredClass);
}

void ClassList::Add(const std::string& name, LabelId label) {
  of_label[label] = static_cast<int>(size());
  names.push_back(name);
  labels.push_back(label);
}

ClassList ReadClassList(const std::string& path, const LabelVocabulary& vocabulary) {
  YamlReader reader(LoadYamlMap(path), path);
  const auto names = reader.Require<std::vector<std::string>>("classes");
  YAML::Node merge;
  reader.Read("merge", merge);
  std::vector<std::string> optional;
  reader.Read("optional", optional);
  double least_visible_share = 0.0;
  reader.Read("least_visible_share", least_visible_share);
  reader.Finish();
  if (names.empty() || std::set<std::string>(names.begin(), names.end()).size() != names.size()) {
    throw ConfigError(path + ": classes: expected one or more names, each once");
  }
  CheckInRange(path + ": least_visible_share", least_visible_share, 0.0, 1.0);
  ClassList classes;
  classes.least_visible_share = least_visible_share;
  for (const std::string& name : names) classes.Add(name, FindLabel(path, name, vocabulary));
  ReadMerge(merge, path, vocabulary, classes);
  ReadOptional(optional, path, vocabulary, classes);
  return classes;
}

}  // namespace semantic_slam
