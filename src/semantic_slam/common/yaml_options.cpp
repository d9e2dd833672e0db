#include "semantic_slam/common/yaml_options.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

namespace semantic_slam {
namespace {

std::string At(const std::string& path, const YAML::Node& node) {
  return path + ":" + std::to_string(node.Mark().line + 1) + ": ";
}

std::string ValueText(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  std::string text = YAML::Dump(node);
  std::replace(text.begin(), text.end(), '\n', ' ');  // messages are one line
  return text;
}

std::string Joined(const std::set<std::string>& names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

}  // namespace

YAML::Node LoadYamlMap(const std::string& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw ConfigError("cannot open configuration file " + path);
  YAML::Node node;
  try {
    node = YAML::Load(file);
  } catch (const YAML::Exception& e) {
    throw ConfigError(path + ":" + std::to_string(e.mark.line + 1) + ": not valid YAML: " + e.msg);
  }
  if (!node.IsMap()) throw ConfigError(path + ": expected a mapping of key: value");
  return node;
}

YamlReader::YamlReader(const YAML::Node& map, std::string path, std::string group)
    : map_(map), path_(std::move(path)), group_(std::move(group)) {}

YamlReader YamlReader::Group(const std::string& key) {
  known_.insert(key);
  return YamlReader(Child(key), path_, FullName(key));
}

std::vector<YamlReader> YamlReader::Entries(const std::string& key) {
  known_.insert(key);
  const YAML::Node list = map_[key];
  std::vector<YamlReader> readers;
  if (!list || list.IsNull()) return readers;
  if (!list.IsSequence()) Refuse(key, "a list");
  for (const YAML::Node& entry : list) {
    const std::string name = FullName(key) + "/" + std::to_string(readers.size());
    if (!entry.IsMap()) throw ConfigError(At(path_, entry) + name + " must be a mapping");
    readers.emplace_back(entry, path_, name);
  }
  return readers;
}

void YamlReader::Complain(const std::string& problem) const {
  throw ConfigError(At(path_, map_) + (group_.empty() ? "" : group_ + ": ") + problem);
}

void YamlReader::Finish() const {
  std::set<std::string> seen;
  for (const auto& entry : map_) {
    const auto key = entry.first.as<std::string>();
    if (!seen.insert(key).second) {
      throw ConfigError(At(path_, entry.first) + "key " + FullName(key) + " appears twice");
    }
    if (known_.count(key) == 0) {
      throw ConfigError(At(path_, entry.first) + "unknown key " + FullName(key) +
                        ", expected one of: " + Joined(known_));
    }
  }
}

void YamlReader::Refuse(const std::string& key, const std::string& expected) const {
  const YAML::Node node = map_[key];
  throw ConfigError(At(path_, node) + FullName(key) + " = " + ValueText(node) + ", but must be " +
                    expected);
}

YAML::Node YamlReader::Child(const std::string& key) const {
  const YAML::Node node = map_[key];
  if (!node || node.IsNull()) return YAML::Node(YAML::NodeType::Map);
  if (!node.IsMap()) throw ConfigError(At(path_, node) + FullName(key) + " must be a mapping");
  return node;
}

std::string YamlReader::FullName(const std::string& key) const {
  return group_.empty() ? key : group_ + "/" + key;
}

void YamlReader::ThrowWrongType(const std::string& key, const YAML::Node& node) const {
  throw ConfigError(At(path_, node) + FullName(key) + " = " + ValueText(node) +
                    " has the wrong type");
}

void YamlReader::ThrowMissing(const std::string& key) const {
  throw ConfigError(path_ + ": missing key " + FullName(key));
}

}  // namespace semantic_slam
