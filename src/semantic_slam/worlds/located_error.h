#pragma once

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"

namespace semantic_slam {

// Runs something that knows no files; its ConfigErrors get the place of `reader` in its file.
template <typename Run>
auto Located(const YamlReader& reader, Run&& run) {
  try {
    return run();
  } catch (const ConfigError& e) {
    reader.Complain(e.what());
  }
}

}  // namespace semantic_slam
