#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/place_recognition/place_index.h"
#include "semantic_slam/tracking/tracker_options.h"

namespace semantic_slam {

// What a camera does that is lost, and how careful it is when it was just found. The caller holds
// the map's mutex. Not thread-safe.
class LostCamera {
 public:
  // `index` tells which keyframes look like an image; it must outlive this. Precondition: the
  // options are valid.
  LostCamera(const TrackerOptions& options, const PlaceIndex& index)
      : options_(options), index_(index) {}

  // To be called with every image.
  void CountImage() { ++images_since_found_; }

  // The camera was found in the map again,
  void Found() { images_since_found_ = 0; }
  // or is where it is by definition, as a map begins there.
  void BeginMap() { images_since_found_ = kCautiousImages; }
  // Its place is known, or what it has seen so far does not count.
  void ForgetUnknown() { unknown_since_.reset(); }

  // Map points that must support the pose of an image to be believed.
  int MinInliers() const;
  // Whether the pose may still be rough.
  bool IsJustFound() const { return images_since_found_ < 2; }

  // Whether a map can begin with the image: it shows enough.
  bool CanBeginMap(const FrameFeatures& features) const;

  // Whether the camera has seen for long enough what it does not know. An image that shows hardly
  // anything, of a covered lens, begins the time anew.
  bool IsLostForLong(const FrameFeatures& features);

  // The keyframes to try. Half are those that look like the image, best first; the others take
  // turns, so that every keyframe of a large map is tried once in a while.
  std::vector<KeyframeId> Candidates(const FrameFeatures& features, const Map& map);

 private:
  // After the camera was lost a pose is believed only with more support, for this many images.
  static constexpr int kCautiousImages = 30;

  const TrackerOptions options_;
  const PlaceIndex& index_;
  int images_since_found_ = 0;
  std::optional<Stamp> unknown_since_;  // lost, and seeing enough all the time
  std::size_t next_old_keyframe_ = 0;   // whose turn it is among the older ones
};

}  // namespace semantic_slam
