#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/semantic_fusion/voxel_observation.h"

namespace semantic_slam {

// What one image showed, one observation per voxel, and where it was seen from: the pose relative
// to a keyframe stays true when the map is corrected.
struct AnchoredCloud {
  Stamp stamp;
  KeyframeId keyframe_id = kNoKeyframe;
  Rigid3d T_keyframe_camera = Rigid3d::Identity();
  std::vector<VoxelObservation> observations;  // in the camera's optical frame
};

// The clouds that a map was made of, so that it can be made again. Bounded: when they outgrow the
// budget every second one goes, and from then on only every second one is kept, and so on. So the
// clouds always cover the whole run, evenly, however long it is. Not thread-safe.
class AnchoredClouds {
 public:
  explicit AnchoredClouds(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  void Add(AnchoredCloud cloud);

  // Removes the clouds for which `is_obsolete(cloud)`; returns how many.
  template <typename Predicate>
  std::size_t RemoveIf(Predicate&& is_obsolete);

  void Clear();

  // In the order in which they came.
  const std::vector<AnchoredCloud>& clouds() const { return clouds_; }
  std::size_t bytes() const { return bytes_; }

  // One of how many clouds is kept; a power of two.
  std::size_t keeps_one_of() const { return keeps_one_of_; }

 private:
  static std::size_t SizeOf(const AnchoredCloud& cloud);
  void Thin();

  const std::size_t max_bytes_;
  std::vector<AnchoredCloud> clouds_;
  std::size_t bytes_ = 0;
  std::size_t keeps_one_of_ = 1;
  std::size_t offered_ = 0;
};

template <typename Predicate>
std::size_t AnchoredClouds::RemoveIf(Predicate&& is_obsolete) {
  std::vector<AnchoredCloud> kept;
  for (AnchoredCloud& cloud : clouds_) {
    if (is_obsolete(cloud)) {
      bytes_ -= SizeOf(cloud);
    } else {
      kept.push_back(std::move(cloud));
    }
  }
  const std::size_t removed = clouds_.size() - kept.size();
  clouds_ = std::move(kept);
  return removed;
}

}  // namespace semantic_slam
