#include "semantic_slam/common/keyframe_graph.h"

namespace semantic_slam {

const char* ToString(TrackingStatus status) {
  switch (status) {
    case TrackingStatus::kInitializing: return "initializing";
    case TrackingStatus::kTracking: return "tracking";
    case TrackingStatus::kLost: return "lost";
  }
  return "unknown";
}

}  // namespace semantic_slam
