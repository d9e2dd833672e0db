#include "semantic_slam/octree/scan_grid.h"

#include <algorithm>
#include <cassert>

namespace semantic_slam {
namespace {

// A ray's last steps may stray by a voxel, by rounding.
constexpr int kMarginVoxels = 2;

// The lowest 16 bits of `value`, three apart.
std::uint64_t Spread(int value) {
  std::uint64_t bits = static_cast<std::uint64_t>(value) & 0xffff;
  bits = (bits | bits << 16) & 0x00ff0000ff0000ffull;
  bits = (bits | bits << 8) & 0xf00f00f00f00f00full;
  bits = (bits | bits << 4) & 0x30c30c30c30c30c3ull;
  return (bits | bits << 2) & 0x9249249249249249ull;
}

}  // namespace

void ScanGrid::Reset(const octomap::OcTreeKey& lowest, const octomap::OcTreeKey& highest) {
  std::size_t cells = 1;
  for (int i = 0; i < 3; ++i) {
    first_[i] = std::max(lowest[i] - kMarginVoxels, 0) >> 3;
    count_[i] = (std::min(highest[i] + kMarginVoxels, 65535) >> 3) - first_[i] + 1;
    cells *= static_cast<std::size_t>(count_[i]);
  }
  index_.assign(cells, -1);
  bricks_.clear();
  places_.clear();
}

bool ScanGrid::Covers(const octomap::OcTreeKey& key) const {
  for (int i = 0; i < 3; ++i) {
    const int brick = (key[i] >> 3) - first_[i];
    if (brick < 0 || brick >= count_[i]) return false;
  }
  return true;
}

ScanGrid::Brick& ScanGrid::BrickAt(int x, int y, int z) {
  const int bx = (x >> 3) - first_[0], by = (y >> 3) - first_[1], bz = (z >> 3) - first_[2];
  assert(bx >= 0 && bx < count_[0] && by >= 0 && by < count_[1] && bz >= 0 && bz < count_[2]);
  std::int32_t& index = index_[(static_cast<std::size_t>(bx) * count_[1] + by) * count_[2] + bz];
  if (index < 0) {
    index = static_cast<std::int32_t>(bricks_.size());
    bricks_.emplace_back();
    places_.push_back({Spread(x >> 3) | Spread(y >> 3) << 1 | Spread(z >> 3) << 2,
                       {x & ~7, y & ~7, z & ~7},
                       static_cast<std::uint32_t>(index)});
  }
  return bricks_[index];
}

std::uint32_t ScanGrid::AssignSlots() {
  SortBricks();
  std::uint32_t slots = 0;
  for (const Place& place : places_) {
    Brick& brick = bricks_[place.index];
    for (int word = 0; word < 8; ++word) {
      brick.first_slot[word] = slots;
      slots += static_cast<std::uint32_t>(__builtin_popcountll(brick.end[word]));
    }
  }
  return slots;
}

void ScanGrid::SortBricks() {
  std::sort(places_.begin(), places_.end());
}

}  // namespace semantic_slam
