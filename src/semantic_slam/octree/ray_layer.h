#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "semantic_slam/octree/ray_walk.h"
#include "semantic_slam/octree/scan_layout.h"
#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Which voxels the rays of a scan pass, as far as a tree needs to know: bricks in which all is as
// free as it can be stay out. One byte a voxel while rays are walked, as a store needs no load
// before it; bits when they are read. Reusable; not thread-safe, but several layers of one layout
// may be filled at the same time.
class RayLayer {
 public:
  // Forgets everything. `layout` and `tree` must outlive the use, and stay as they are.
  void Reset(const ScanLayout& layout, const SemanticOcTree& tree);

  // Marks the voxels of the ray from the origin on, without the last one. Precondition: the layout
  // covers the ray.
  void Mark(RayWalk ray);

  // Calls visit(brick number, words) for every brick with a marked voxel, in no order; `words` are
  // 512 bits in Morton order, std::array<std::uint64_t, 8>.
  template <typename Visit>
  void ForEachBrick(Visit&& visit) const;

 private:
  using Number = ScanLayout::Number;

  // A place in bytes_, in bricks.
  static constexpr std::int32_t kUnknown = -1;
  static constexpr std::int32_t kNeedless = 0;  // of all bricks that need no marks

  // Marks the voxels of all but the last layers across axis kA, the one along which the ray is
  // fastest, and leaves `ray` where it stands then.
  template <int kA>
  void MarkFast(RayWalk& ray);

  std::int32_t PlaceOf(Number brick) {
    if (places_[brick] == kUnknown) LookUp(brick);
    return places_[brick];
  }
  void LookUp(Number brick);
  static std::size_t ByteOf(Number voxel, std::int32_t place) {
    return static_cast<std::size_t>(place) << ScanLayout::kBrickBits |
           (voxel & (ScanLayout::kBrickVoxels - 1));
  }

  // The lowest bits of eight bytes of 0 or 1, by one multiplication: the factor takes bit 8 k to
  // bit 56 + k, and no two others to the same place.
  static std::uint64_t Pack(std::uint64_t bytes) { return bytes * 0x0102040810204080u >> 56; }

  const ScanLayout* layout_ = nullptr;
  const SemanticOcTree* tree_ = nullptr;
  std::vector<std::int32_t> places_;   // by brick
  std::vector<std::uint32_t> bricks_;  // by place; the first one is none
  std::vector<std::uint8_t> bytes_;    // 0 or 1 a voxel
};

template <typename Visit>
void RayLayer::ForEachBrick(Visit&& visit) const {
  for (std::size_t place = 1; place < bricks_.size(); ++place) {
    const std::uint8_t* bytes = &bytes_[place * ScanLayout::kBrickVoxels];
    std::array<std::uint64_t, 8> words{};
    for (unsigned i = 0; i < 64; ++i, bytes += 8) {
      std::uint64_t eight = 0;
      for (unsigned k = 0; k < 8; ++k) eight |= static_cast<std::uint64_t>(bytes[k]) << (8 * k);
      words[i >> 3] |= Pack(eight) << (8 * (i & 7));
    }
    visit(bricks_[place], words);
  }
}

}  // namespace semantic_slam
