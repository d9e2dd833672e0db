#pragma once

#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/options.h"

namespace semantic_slam {

// Validates a struct of options structs, whose static VisitGroups() calls visit(name, group) for
// each, and returns it. The message of the ConfigError names the group too: "tracker/max_boxes = 0,
// ...".
template <typename Groups>
const Groups& ValidatedGroups(const Groups& groups) {
  Groups::VisitGroups(groups, [](const std::string& name, const auto& group) {
    try {
      Validate(group);
    } catch (const ConfigError& e) {
      throw ConfigError(name + "/" + e.what());
    }
  });
  return groups;
}

}  // namespace semantic_slam
