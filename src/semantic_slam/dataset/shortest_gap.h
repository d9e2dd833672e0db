#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// The shortest of the last hundred gaps between the stamps of one stream: what the stream has shown
// of how soon after an image the next can come. Not thread-safe.
class ShortestGap {
 public:
  // Precondition: later than the stamp before.
  void Add(Stamp stamp);

  // nullopt until ten gaps are known: fewer say too little about a stream that jitters.
  std::optional<std::int64_t> ns() const;

 private:
  std::optional<Stamp> newest_;
  std::deque<std::int64_t> gaps_ns_;  // the last ones
};

}  // namespace semantic_slam
