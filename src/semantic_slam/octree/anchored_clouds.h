#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "semantic_slam/common/scratch_file.h"
#include "semantic_slam/octree/packed_cloud.h"

namespace semantic_slam {

// A kept cloud, in memory or on disk. Immutable, so safe from any thread.
class AnchoredCloud {
 public:
  AnchoredCloud(const CloudAnchor& anchor, PackedCloud cloud);

  // On disk. Throws InputError if that is full.
  AnchoredCloud(const CloudAnchor& anchor, const PackedCloud& cloud,
                std::shared_ptr<ScratchFile> file);

  const CloudAnchor& anchor() const { return anchor_; }
  std::size_t bytes() const { return sizeof(AnchoredCloud) + size_ * sizeof(PackedObservation); }
  bool is_on_disk() const { return file_ != nullptr; }

  // Throws InputError if it cannot be read from disk.
  std::vector<VoxelObservation> Load() const { return Unpack(Packed()); }
  PackedCloud Packed() const;

 private:
  const CloudAnchor anchor_;
  const PackedCloud in_memory_;  // without observations if they are on disk
  const std::size_t size_;       // observations
  const std::shared_ptr<const ScratchFile> file_;
  std::uint64_t offset_ = 0;
};

// The clouds that a map was made of, so that it can be made again. They are on disk, or in memory
// where there is none. Bounded: when there is no more room every second cloud goes, and from then
// on only every second one is kept, and so on. So the clouds always cover the whole run, evenly,
// however long it is. Not thread-safe.
class AnchoredClouds {
 public:
  using Clouds = std::vector<std::shared_ptr<const AnchoredCloud>>;

  struct Limits {
    std::size_t disk_bytes = 0;    // 0: nothing goes to disk
    std::size_t memory_bytes = 0;  // of what does not
    std::string folder;            // for the file; empty: the system's
  };

  explicit AnchoredClouds(const Limits& limits) : limits_(limits) {}

  // If the disk fails it is no longer used, and disk_error() tells why.
  void Add(const CloudAnchor& anchor, const std::vector<VoxelObservation>& observations);

  // Removes the clouds for which `is_obsolete(cloud)`; returns how many.
  template <typename Predicate>
  std::size_t RemoveIf(Predicate&& is_obsolete);

  void Clear();

  // In the order in which they came.
  const Clouds& clouds() const { return clouds_; }
  std::size_t memory_bytes() const { return memory_bytes_; }
  std::size_t disk_bytes() const { return disk_bytes_; }
  const std::string& disk_error() const { return disk_error_; }

  // One of how many clouds is kept; a power of two.
  std::size_t keeps_one_of() const { return keeps_one_of_; }

 private:
  std::size_t& BytesOf(const AnchoredCloud& cloud) {
    return cloud.is_on_disk() ? disk_bytes_ : memory_bytes_;
  }
  // On disk, or if there is none, in memory.
  std::shared_ptr<const AnchoredCloud> Kept(const CloudAnchor& anchor, PackedCloud cloud);
  void Thin();

  // Writes the clouds on disk anew, so that it holds nothing else.
  void Compact();

  const Limits limits_;
  Clouds clouds_;
  std::shared_ptr<ScratchFile> file_;
  std::string disk_error_;
  std::size_t memory_bytes_ = 0;
  std::size_t disk_bytes_ = 0;
  std::size_t keeps_one_of_ = 1;
  std::size_t offered_ = 0;
};

template <typename Predicate>
std::size_t AnchoredClouds::RemoveIf(Predicate&& is_obsolete) {
  Clouds kept;
  for (std::shared_ptr<const AnchoredCloud>& cloud : clouds_) {
    if (is_obsolete(*cloud)) {
      BytesOf(*cloud) -= cloud->bytes();
    } else {
      kept.push_back(std::move(cloud));
    }
  }
  const std::size_t removed = clouds_.size() - kept.size();
  clouds_ = std::move(kept);
  return removed;
}

}  // namespace semantic_slam
