#pragma once

#include <string>

#include "semantic_slam/common/check.h"

namespace semantic_slam {

// How options work here. Each component has one struct; its initialisers are the only place that
// states the defaults, and its static Visit() is the only place that states names and ranges:
//
//   struct CloudBuilderOptions {
//     double max_depth_m = 5.0;  // farther pixels are dropped
//     template <typename Self, typename Visitor>
//     static void Visit(Self& self, Visitor&& visit) {
//       visit("max_depth_m", self.max_depth_m, 0.1, 100.0);
//     }
//   };
//
// Validate(options), the YAML reader (yaml_options.h) and the ROS parameter reader are visitors.
// A component validates its options once, in its constructor, and keeps them const.

namespace internal {

struct RangeChecker {
  template <typename T>
  void operator()(const char* name, const T& value, T low, T high) const {
    CheckInRange<T>(name, value, low, high);
  }
  void operator()(const char*, bool) const {}
  void operator()(const char*, const std::string&) const {}
};

}  // namespace internal

// Throws ConfigError naming the first option that is out of its range, its value and the range.
template <typename Options>
void Validate(const Options& options) {
  Options::Visit(options, internal::RangeChecker());
}

// The same inside an initialiser list: returns `options` if they are valid.
template <typename Options>
const Options& Validated(const Options& options) {
  Validate(options);
  return options;
}

}  // namespace semantic_slam
