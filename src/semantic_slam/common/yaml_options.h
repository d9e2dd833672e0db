#pragma once

#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/options.h"

namespace semantic_slam {

// The mapping in the YAML file at `path`. Throws ConfigError, naming the file, if it cannot be read,
// is not valid YAML or is not a mapping.
YAML::Node LoadYamlMap(const std::string& path);

// Reads values out of one YAML mapping and refuses what nobody asked for. Every ConfigError names
// the file, the line and the key.
class YamlReader {
 public:
  // `group` is only for messages: "tracking" makes them say "tracking/max_features".
  YamlReader(const YAML::Node& map, std::string path, std::string group = "");

  const std::string& path() const { return path_; }

  bool Has(const std::string& key) const { return static_cast<bool>(map_[key]); }

  // Leaves `value` alone if the key is absent. Throws ConfigError if it has another type.
  template <typename T>
  void Read(const std::string& key, T& value) {
    known_.insert(key);
    const YAML::Node node = map_[key];
    if (!node) return;
    try {
      value = node.as<T>();
    } catch (const YAML::Exception&) {
      ThrowWrongType(key, node);
    }
  }

  // Throws ConfigError if the key is absent or has another type.
  template <typename T>
  T Require(const std::string& key) {
    if (!Has(key)) ThrowMissing(key);
    T value{};
    Read(key, value);
    return value;
  }

  // Fills `options` from the sub-mapping `key` (its defaults stay where the file says nothing),
  // refuses unknown keys in it and validates the result.
  template <typename Options>
  void ReadOptions(const std::string& key, Options& options) {
    known_.insert(key);
    YamlReader group(Child(key), path_, FullName(key));
    Options::Visit(options, OptionReader{group});
    group.Finish();
    try {
      Validate(options);
    } catch (const ConfigError& e) {
      throw ConfigError(path_ + ": " + FullName(key) + "/" + e.what());
    }
  }

  // Throws ConfigError "FILE:LINE: KEY = VALUE, but must be EXPECTED". Precondition: Has(key).
  [[noreturn]] void Refuse(const std::string& key, const std::string& expected) const;

  // The sub-mapping `key`; an empty one if absent. Throws ConfigError if it is not a mapping.
  YamlReader Group(const std::string& key);

  // Readers of the mappings in the list `key`, for messages "key/0" and so on; none if it is absent.
  // Throws ConfigError if it is not a list of mappings.
  std::vector<YamlReader> Entries(const std::string& key);

  // Throws ConfigError "FILE:LINE: GROUP: PROBLEM" about the mapping as a whole.
  [[noreturn]] void Complain(const std::string& problem) const;

  // Throws ConfigError if the mapping has a key that no call asked for, or one twice.
  void Finish() const;

 private:
  struct OptionReader {
    YamlReader& reader;
    template <typename T, typename... Range>
    void operator()(const char* name, T& value, const Range&...) const {
      reader.Read(name, value);
    }
  };

  YAML::Node Child(const std::string& key) const;
  std::string FullName(const std::string& key) const;
  [[noreturn]] void ThrowWrongType(const std::string& key, const YAML::Node& node) const;
  [[noreturn]] void ThrowMissing(const std::string& key) const;

  const YAML::Node map_;
  const std::string path_;
  const std::string group_;
  std::set<std::string> known_;
};

// Fills every group of `options` that its VisitGroups() names from the sub-mapping of that name.
template <typename Options>
void ReadOptionGroups(YamlReader& reader, Options& options) {
  Options::VisitGroups(options,
                       [&reader](const char* name, auto& group) { reader.ReadOptions(name, group); });
}

// The same one level deeper: the groups are sub-mappings of the sub-mapping `key`, and it may hold
// nothing else.
template <typename Options>
void ReadOptionGroups(YamlReader& reader, const std::string& key, Options& options) {
  YamlReader group = reader.Group(key);
  ReadOptionGroups(group, options);
  group.Finish();
}

}  // namespace semantic_slam
