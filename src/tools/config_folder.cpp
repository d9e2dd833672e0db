#include "tools/config_folder.h"

#include <filesystem>

#include "semantic_slam/common/error.h"

namespace semantic_slam {

namespace fs = std::filesystem;

std::string ConfigFolder() {
  std::error_code error;
  for (fs::path folder = fs::read_symlink("/proc/self/exe", error); folder.has_relative_path();) {
    folder = folder.parent_path();
    for (const fs::path& config : {folder / "config", folder / "share/semantic_slam/config"}) {
      if (fs::exists(config / "labels.yaml")) return config.string();
    }
  }
  if (fs::exists(SEMANTIC_SLAM_SOURCE_CONFIG)) return SEMANTIC_SLAM_SOURCE_CONFIG;
  throw ConfigError(
      "this program does not lie in its package, so nobody knows where the "
      "configuration is: name files by their paths");
}

std::string ConfigFile(const std::string& given, const std::string& name) {
  return given.empty() ? (fs::path(ConfigFolder()) / name).string() : given;
}

std::string FindInConfig(const std::string& path_or_name, const std::string& subfolder) {
  if (fs::is_regular_file(path_or_name)) return path_or_name;
  const fs::path named = fs::path(ConfigFolder()) / subfolder / (path_or_name + ".yaml");
  if (fs::exists(named)) return named.string();
  throw ConfigError("no such file: " + path_or_name + ", nor " + named.string());
}

}  // namespace semantic_slam
