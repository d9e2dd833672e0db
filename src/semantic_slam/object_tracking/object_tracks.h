#pragma once

#include <cstdint>
#include <vector>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/detection/detections.h"

namespace semantic_slam {

using TrackId = std::int64_t;

enum class TrackState : std::uint8_t {
  kTentative = 0,  // seen too few times to be trusted
  kConfirmed = 1,  // seen in this image
  kLost = 2,       // not seen in this image; the box is predicted
};

// One object followed through the images of one camera. "Track" here is an object's path through the
// images, never the camera's.
struct ObjectTrack {
  TrackId id = 0;  // never used again
  TrackState state = TrackState::kTentative;
  DetectedBox detection;     // box as filtered at the image's stamp; label and confidence as last seen
  int hits = 0;              // images it was seen in so far
  double since_seen_s = 0.0; // from the last image it was seen in to this one
};

// The objects followed at one image, by ascending id.
struct ObjectTracks {
  Stamp stamp;  // the colour image's
  std::uint64_t vocabulary_hash = 0;
  cv::Size image_size;  // [px]
  std::vector<ObjectTrack> tracks;
};

}  // namespace semantic_slam
