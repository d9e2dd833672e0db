#include "semantic_slam/common/label_vocabulary.h"

#include <algorithm>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"

namespace semantic_slam {
namespace {

// FNV-1a, 64 bits (Fowler, Noll, Vo).
class Fnv1a {
 public:
  void Add(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 1099511628211ull; }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ull;
};

void CheckClasses(const std::vector<LabelClass>& classes) {
  if (classes.empty() || classes[0].id != kUnknownLabel || classes[0].name != "unknown") {
    throw ConfigError("labels: id 0 is missing or is not called 'unknown'");
  }
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const LabelClass& label = classes[i];
    if (label.name.empty()) throw ConfigError("labels: id " + std::to_string(label.id) + " has no name");
    if (label.id == kReservedLabel) {
      throw ConfigError("labels: id 255 is reserved, but '" + label.name + "' has it");
    }
    CheckInRange("labels: cost of '" + label.name + "'", label.cost, 0, 254);
    for (std::size_t j = 0; j < i; ++j) {
      if (classes[j].id == label.id || classes[j].name == label.name) {
        throw ConfigError("labels: '" + classes[j].name + "' and '" + label.name +
                          "' have the same id or name");
      }
    }
  }
}

std::array<std::uint8_t, 3> ToRgb(const std::vector<int>& values, const std::string& who) {
  std::array<std::uint8_t, 3> rgb{};
  if (values.size() != rgb.size()) throw ConfigError(who + ": colour has " + std::to_string(values.size()) +
                                                     " numbers, expected 3: red, green, blue");
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    CheckInRange(who + ": colour", values[i], 0, 255);
    rgb[i] = static_cast<std::uint8_t>(values[i]);
  }
  return rgb;
}

LabelClass ReadClass(const YAML::Node& node, const std::string& path) {
  YamlReader reader(node, path, "labels");
  LabelClass label;
  const int id = reader.Require<int>("id");
  CheckInRange(path + ": labels/id", id, 0, 254);
  label.id = static_cast<LabelId>(id);
  label.name = reader.Require<std::string>("name");
  label.rgb = ToRgb(reader.Require<std::vector<int>>("colour"), path + ": label '" + label.name + "'");
  reader.Read("movable", label.movable);
  reader.Read("hollow", label.hollow);
  reader.Read("cost", label.cost);
  reader.Finish();
  return label;
}

}  // namespace

LabelVocabulary::LabelVocabulary(std::vector<LabelClass> classes) : classes_(std::move(classes)) {
  std::sort(classes_.begin(), classes_.end(),
            [](const LabelClass& a, const LabelClass& b) { return a.id < b.id; });
  CheckClasses(classes_);
  index_.fill(-1);
  Fnv1a hash;
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    index_[classes_[i].id] = static_cast<std::int16_t>(i);
    hash.Add(classes_[i].id);
    for (const char c : classes_[i].name) hash.Add(static_cast<std::uint8_t>(c));
    hash.Add(0);
  }
  hash_ = hash.value();
}

LabelVocabulary LabelVocabulary::Load(const std::string& path) {
  const YAML::Node file = LoadYamlMap(path);
  YamlReader reader(file, path);
  const auto list = reader.Require<YAML::Node>("labels");
  reader.Finish();
  if (!list.IsSequence()) throw ConfigError(path + ": labels is not a list");
  std::vector<LabelClass> classes;
  for (const YAML::Node& node : list) {
    if (!node.IsMap()) throw ConfigError(path + ": labels: an entry is not a mapping");
    classes.push_back(ReadClass(node, path));
  }
  try {
    return LabelVocabulary(std::move(classes));
  } catch (const ConfigError& e) {
    throw ConfigError(path + ": " + e.what());
  }
}

std::optional<LabelId> LabelVocabulary::Find(const std::string& name) const {
  for (const LabelClass& label : classes_) {
    if (label.name == name) return label.id;
  }
  return std::nullopt;
}

}  // namespace semantic_slam
