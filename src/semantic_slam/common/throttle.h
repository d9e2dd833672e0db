#pragma once

#include <optional>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// Lets something happen at most once per period of stamps, so that it happens at the same images
// however fast they come. Not thread-safe.
class Throttle {
 public:
  explicit Throttle(double period_s) : period_s_(period_s) {}

  // True for the first stamp, once per period from then on, and when stamps have jumped back.
  bool IsDue(Stamp stamp);

 private:
  const double period_s_;
  std::optional<Stamp> last_;
};

}  // namespace semantic_slam
