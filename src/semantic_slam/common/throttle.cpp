#include "semantic_slam/common/throttle.h"

namespace semantic_slam {

bool Throttle::IsDue(Stamp stamp) {
  if (last_ && stamp >= *last_ && SecondsBetween(*last_, stamp) < period_s_) return false;
  last_ = stamp;
  return true;
}

}  // namespace semantic_slam
