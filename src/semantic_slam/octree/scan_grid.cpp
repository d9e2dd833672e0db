#include "semantic_slam/octree/scan_grid.h"

#include <algorithm>

namespace semantic_slam {
namespace {

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
  layout_.Reset(lowest, highest);
  index_.assign(layout_.bricks(), -1);
  bricks_.clear();
  end_ids_.clear();
  ends_ = 0;
  order_.clear();
  is_sorted_ = true;
}

void ScanGrid::AddBrick(std::size_t number) {
  const auto index = static_cast<std::uint32_t>(bricks_.size());
  index_[number] = static_cast<std::int32_t>(index);
  bricks_.emplace_back();
  const octomap::OcTreeKey corner = bricks_.back().corner = layout_.CornerOf(number);
  order_.push_back(
      {Spread(corner[0] >> 3) | Spread(corner[1] >> 3) << 1 | Spread(corner[2] >> 3) << 2, index});
  is_sorted_ = false;
}

void ScanGrid::AddFree(const RayLayer& rays) {
  rays.ForEachBrick([this](std::uint32_t number, const Words& words) {
    Brick& brick = bricks_[BrickAt(number)];
    for (unsigned word = 0; word < 8; ++word) brick.free[word] |= words[word];
  });
}

void ScanGrid::LimitHeight(int lowest_key, int highest_key) {
  for (Brick& brick : bricks_) {
    const int low = brick.corner[2];
    if (low >= lowest_key && low + 7 <= highest_key) continue;
    for (unsigned place = 0; place < ScanLayout::kBrickVoxels; ++place) {
      const int z = ScanLayout::KeyOf(brick.corner, place)[2];
      if (z >= lowest_key && z <= highest_key) continue;
      const std::uint64_t others = ~(std::uint64_t{1} << (place & 63));
      brick.free[place >> 6] &= others;
      brick.hit[place >> 6] &= others;
    }
  }
}

void ScanGrid::SortBricks() {
  if (is_sorted_) return;
  std::sort(order_.begin(), order_.end());
  is_sorted_ = true;
}

}  // namespace semantic_slam
