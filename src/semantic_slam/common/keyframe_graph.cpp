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

bool ForgetsLostMaps(RevisionReason reason) {
  return reason == RevisionReason::kReset || reason == RevisionReason::kLoad;
}

}  // namespace semantic_slam
