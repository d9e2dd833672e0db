#include "semantic_slam/network_evaluation/yolo_data_file.h"

#include <filesystem>
#include <fstream>
#include <map>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/network_evaluation/image_files.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> ReadNames(const YAML::Node& node, const std::string& path) {
  std::vector<std::string> names;
  try {
    if (node.IsMap()) {
      for (const auto& [number, name] : node.as<std::map<int, std::string>>()) {
        names.push_back(name);
      }
    } else {
      names = node.as<std::vector<std::string>>();
    }
  } catch (const YAML::Exception&) {
    names.clear();
  }
  if (names.empty()) throw ConfigError(path + ": names: expected the classes' names");
  return names;
}

fs::path FindSplit(const std::string& path, const fs::path& base, const std::string& split,
                   const std::string& name) {
  const fs::path beside = fs::path(path).parent_path();
  const bool goes_up = name.rfind("../", 0) == 0;
  for (const fs::path& candidate :
       {base / name, beside / name, beside / (goes_up ? name.substr(3) : name)}) {
    if (fs::exists(candidate)) return candidate;
  }
  throw ConfigError(path + ": " + split + ": " + (base / name).string() + " does not exist");
}

std::vector<std::string> ListImages(const fs::path& source) {
  if (fs::is_directory(source)) return ImagesIn(source.string());
  std::vector<std::string> images;
  std::ifstream file(source);
  for (std::string line; std::getline(file, line);) {
    const auto last = line.find_last_not_of(" \t\r");
    if (last == std::string::npos) continue;
    images.push_back((source.parent_path() / line.substr(0, last + 1)).string());
  }
  return images;
}

}  // namespace

YoloData ReadYoloData(const std::string& path, const std::string& split) {
  YamlReader reader(LoadYamlMap(path), path);
  YoloData data;
  data.names = ReadNames(reader.Require<YAML::Node>("names"), path);
  const auto name = reader.Require<std::string>(split);
  std::string base;
  reader.Read("path", base);
  const fs::path folder = fs::path(path).parent_path() / base;
  data.images = ListImages(FindSplit(path, folder, split, name));
  return data;
}

}  // namespace semantic_slam
