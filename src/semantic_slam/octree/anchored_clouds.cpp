#include "semantic_slam/octree/anchored_clouds.h"

#include "semantic_slam/common/error.h"

namespace semantic_slam {

AnchoredCloud::AnchoredCloud(const CloudAnchor& anchor, PackedCloud cloud)
    : anchor_(anchor), in_memory_(std::move(cloud)), size_(in_memory_.observations.size()) {}

AnchoredCloud::AnchoredCloud(const CloudAnchor& anchor, const PackedCloud& cloud,
                             std::shared_ptr<ScratchFile> file)
    : anchor_(anchor),
      in_memory_{cloud.unit_m, {}},
      size_(cloud.observations.size()),
      file_(file),
      offset_(file->Append(cloud.observations.data(), size_ * sizeof(PackedObservation))) {}

PackedCloud AnchoredCloud::Packed() const {
  if (!is_on_disk()) return in_memory_;
  PackedCloud cloud{in_memory_.unit_m, std::vector<PackedObservation>(size_)};
  file_->Read(offset_, cloud.observations.data(), size_ * sizeof(PackedObservation));
  return cloud;
}

void AnchoredClouds::Add(const CloudAnchor& anchor,
                         const std::vector<VoxelObservation>& observations) {
  if (offered_++ % keeps_one_of_ != 0) return;
  clouds_.push_back(Kept(anchor, Pack(observations)));
  BytesOf(*clouds_.back()) += clouds_.back()->bytes();
  while (memory_bytes_ > limits_.memory_bytes || disk_bytes_ > limits_.disk_bytes) Thin();
}

void AnchoredClouds::Clear() {
  clouds_.clear();
  file_.reset();
  memory_bytes_ = disk_bytes_ = 0;
  keeps_one_of_ = 1;
  offered_ = 0;
}

std::shared_ptr<const AnchoredCloud> AnchoredClouds::Kept(const CloudAnchor& anchor,
                                                          PackedCloud cloud) {
  if (limits_.disk_bytes > 0 && disk_error_.empty()) {
    try {
      if (!file_) file_ = std::make_shared<ScratchFile>(limits_.folder);
      return std::make_shared<const AnchoredCloud>(anchor, cloud, file_);
    } catch (const InputError& e) {
      disk_error_ = e.what();
    }
  }
  return std::make_shared<const AnchoredCloud>(anchor, std::move(cloud));
}

void AnchoredClouds::Thin() {
  keeps_one_of_ *= 2;
  // A single cloud that is too large goes too.
  std::size_t index = clouds_.size() == 1 ? 1 : 0;
  RemoveIf([&](const AnchoredCloud&) { return index++ % 2 == 1; });
  Compact();
}

void AnchoredClouds::Compact() {
  if (!file_ || !disk_error_.empty()) return;
  try {
    const auto file = std::make_shared<ScratchFile>(limits_.folder);
    for (std::shared_ptr<const AnchoredCloud>& cloud : clouds_) {
      if (!cloud->is_on_disk()) continue;
      cloud = std::make_shared<const AnchoredCloud>(cloud->anchor(), cloud->Packed(), file);
    }
    file_ = file;
  } catch (const InputError& e) {
    disk_error_ = e.what();  // what is on disk can still be read there
  }
}

}  // namespace semantic_slam
