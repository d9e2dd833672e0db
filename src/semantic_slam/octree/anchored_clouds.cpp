#include "semantic_slam/octree/anchored_clouds.h"

#include <utility>

namespace semantic_slam {

void AnchoredClouds::Add(AnchoredCloud cloud) {
  if (offered_++ % keeps_one_of_ != 0) return;
  cloud.observations.shrink_to_fit();
  bytes_ += SizeOf(cloud);
  clouds_.push_back(std::move(cloud));
  while (bytes_ > max_bytes_) Thin();
}

void AnchoredClouds::Clear() {
  clouds_.clear();
  bytes_ = 0;
  keeps_one_of_ = 1;
  offered_ = 0;
}

std::size_t AnchoredClouds::SizeOf(const AnchoredCloud& cloud) {
  return sizeof(AnchoredCloud) + cloud.observations.size() * sizeof(VoxelObservation);
}

void AnchoredClouds::Thin() {
  keeps_one_of_ *= 2;
  // A single cloud that is too large goes too.
  std::size_t index = clouds_.size() == 1 ? 1 : 0;
  RemoveIf([&](const AnchoredCloud&) { return index++ % 2 == 1; });
}

}  // namespace semantic_slam
