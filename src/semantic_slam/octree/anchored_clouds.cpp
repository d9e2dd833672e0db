#include "semantic_slam/octree/anchored_clouds.h"

#include "semantic_slam/common/error.h"

namespace semantic_slam {

AnchoredCloud::AnchoredCloud(const CloudAnchor& anchor, PackedCloud cloud)
    : anchor_(anchor), in_memory_(std::move(cloud)), size_(in_memory_.observations.size()) {}

AnchoredCloud::AnchoredCloud(const AnchoredCloud& from, std::shared_ptr<ScratchFile> file)
    : anchor_(from.anchor_),
      in_memory_{from.in_memory_.unit_m, {}},
      size_(from.size_),
      file_(file) {
  const PackedCloud packed = from.Packed();
  offset_ = file->Append(packed.observations.data(), size_ * sizeof(PackedObservation));
}

std::vector<VoxelObservation> AnchoredCloud::Load() const {
  return Unpack(is_on_disk() ? Packed() : in_memory_);
}

PackedCloud AnchoredCloud::Packed() const {
  if (!is_on_disk()) return in_memory_;
  PackedCloud cloud{in_memory_.unit_m, std::vector<PackedObservation>(size_)};
  file_->Read(offset_, cloud.observations.data(), size_ * sizeof(PackedObservation));
  return cloud;
}

void AnchoredClouds::Add(const CloudAnchor& anchor,
                         const std::vector<VoxelObservation>& observations) {
  if (offered_++ % keeps_one_of_ != 0) return;
  clouds_.push_back(OnDisk(std::make_shared<const AnchoredCloud>(anchor, Pack(observations))));
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

std::shared_ptr<const AnchoredCloud> AnchoredClouds::OnDisk(
    std::shared_ptr<const AnchoredCloud> cloud) {
  if (limits_.disk_bytes == 0 || !disk_error_.empty()) return cloud;
  try {
    if (!file_) file_ = std::make_shared<ScratchFile>(limits_.folder);
    return std::make_shared<const AnchoredCloud>(*cloud, file_);
  } catch (const InputError& e) {
    disk_error_ = e.what();
    return cloud;
  }
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
      if (cloud->is_on_disk()) cloud = std::make_shared<const AnchoredCloud>(*cloud, file);
    }
    file_ = file;
  } catch (const InputError& e) {
    disk_error_ = e.what();  // what is on disk can still be read there
  }
}

}  // namespace semantic_slam
