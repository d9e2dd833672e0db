#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace semantic_slam {

// Path of `name` below the folder with recorded data: $SEMANTIC_SLAM_SHARED, or "shared" beside the
// source tree. nullopt if it is not there; tests then skip with SEMANTIC_SLAM_SKIP_WITHOUT().
inline std::optional<std::string> SharedData(const std::string& name) {
  const char* given = std::getenv("SEMANTIC_SLAM_SHARED");
  const std::filesystem::path shared =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(SEMANTIC_SLAM_SOURCE_DIR) / ".." / "shared";
  const std::filesystem::path path = (shared / name).lexically_normal();
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path.string();
}

constexpr char kFreiburg1Desk[] = "data/tum/rgbd_dataset_freiburg1_desk";

}  // namespace semantic_slam

// Ends the test, with one line, unless `data` (a std::optional) holds a value.
#define SEMANTIC_SLAM_SKIP_WITHOUT(data, name) \
  if (!(data)) GTEST_SKIP() << name << " is not there; set SEMANTIC_SLAM_SHARED to test it"
