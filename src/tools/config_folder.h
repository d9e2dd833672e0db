#pragma once

#include <string>

namespace semantic_slam {

// The package's folder config, by where the running program lies: in an install space or a build
// tree. Throws ConfigError if it is not found.
std::string ConfigFolder();

// `given` if it is no empty path, else the file of that name in ConfigFolder().
std::string ConfigFile(const std::string& given, const std::string& name);

// A world or tour by its path, or by its name in a sub-folder of ConfigFolder(): "home" of "worlds"
// is worlds/home.yaml. Throws ConfigError if there is neither.
std::string FindInConfig(const std::string& path_or_name, const std::string& subfolder);

}  // namespace semantic_slam
