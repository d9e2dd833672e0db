#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "semantic_slam/octree/ray_layer.h"
#include "semantic_slam/octree/scan_layout.h"

namespace semantic_slam {

// What one scan says of the voxels around the sensor: bits in bricks of 8 x 8 x 8 voxels. Bricks,
// and the voxels in them, are read in Morton order, the order in which an octree lies in memory, so
// that writing the scan into a tree is one walk over it. Reusable; not thread-safe.
class ScanGrid {
 public:
  using Words = std::array<std::uint64_t, 8>;  // a bit per voxel of a brick

  // A voxel by where its bits are: brick in the grid, and place in the brick.
  using BitId = std::uint32_t;

  // A voxel with a measurement in it: the how manieth such one it was.
  using EndId = std::uint32_t;

  struct Brick {
    octomap::OcTreeKey corner;
    Words free{};  // a ray passes
    Words hit{};   // something is there
    Words end{};   // a measurement lies there, whether it counts as a hit or not
    // Of each word with an end: where in end_ids_ the numbers of its ends are.
    std::array<std::uint32_t, 8> end_ids{};
  };

  // Forgets everything.
  void Reset(const octomap::OcTreeKey& lowest, const octomap::OcTreeKey& highest);

  const ScanLayout& layout() const { return layout_; }

  // Precondition: the layout covers the key.
  EndId AddEnd(const octomap::OcTreeKey& key) {
    const ScanLayout::Number number = layout_.NumberOf(key);
    const unsigned place = number & (ScanLayout::kBrickVoxels - 1);
    Brick& brick = bricks_[BrickAt(number >> ScanLayout::kBrickBits)];
    std::uint64_t& word = brick.end[place >> 6];
    const std::uint64_t bit = std::uint64_t{1} << (place & 63);
    if ((word & bit) != 0) return EndAt(brick, place);
    if (word == 0) {
      brick.end_ids[place >> 6] = static_cast<std::uint32_t>(end_ids_.size());
      end_ids_.emplace_back();
    }
    word |= bit;
    return end_ids_[brick.end_ids[place >> 6]][place & 63] = ends_++;
  }

  // How many ends there are.
  EndId ends() const { return ends_; }

  // Precondition: a measurement lies at that place in the brick.
  EndId EndAt(const Brick& brick, unsigned place) const {
    return end_ids_[brick.end_ids[place >> 6]][place & 63];
  }

  // Calls visit(end, key, bit) for every end, in Morton order.
  template <typename Visit>
  void ForEachEnd(Visit&& visit);
  void MarkHit(BitId bit) {
    const unsigned place = bit & (ScanLayout::kBrickVoxels - 1);
    bricks_[bit >> ScanLayout::kBrickBits].hit[place >> 6] |= std::uint64_t{1} << (place & 63);
  }

  // What rays have passed is free. Each bit counts once, however many layers have it.
  void AddFree(const RayLayer& rays);

  // Takes out whatever is free or hit at other heights.
  void LimitHeight(int lowest_key, int highest_key);

  // Calls visit(brick) for every brick in which something is free or hit, in Morton order. What is
  // both is only a hit.
  template <typename Visit>
  void ForEachBrick(Visit&& visit);

 private:
  struct Place {
    std::uint64_t morton;  // of the brick
    std::uint32_t index;   // into bricks_
    bool operator<(const Place& other) const { return morton < other.morton; }
  };

  std::uint32_t BrickAt(std::size_t number) {
    if (index_[number] < 0) AddBrick(number);
    return static_cast<std::uint32_t>(index_[number]);
  }
  void AddBrick(std::size_t number);
  void SortBricks();

  ScanLayout layout_;
  std::vector<std::int32_t> index_;  // by the layout's number of the brick: into bricks_, or -1
  std::vector<Brick> bricks_;
  std::vector<std::array<EndId, 64>> end_ids_;  // of the voxels of a word
  EndId ends_ = 0;
  std::vector<Place> order_;  // of bricks_
  bool is_sorted_ = true;
};

template <typename Visit>
void ScanGrid::ForEachEnd(Visit&& visit) {
  SortBricks();
  for (const Place& place : order_) {
    const Brick& brick = bricks_[place.index];
    for (unsigned word = 0; word < 8; ++word) {
      for (std::uint64_t left = brick.end[word]; left != 0; left &= left - 1) {
        const unsigned in_brick = word << 6 | static_cast<unsigned>(__builtin_ctzll(left));
        visit(EndAt(brick, in_brick), ScanLayout::KeyOf(brick.corner, in_brick),
              place.index << ScanLayout::kBrickBits | in_brick);
      }
    }
  }
}

template <typename Visit>
void ScanGrid::ForEachBrick(Visit&& visit) {
  SortBricks();
  for (const Place& place : order_) {
    Brick& brick = bricks_[place.index];
    std::uint64_t any = 0;
    for (unsigned word = 0; word < 8; ++word) {
      brick.free[word] &= ~brick.hit[word];
      any |= brick.free[word] | brick.hit[word];
    }
    if (any != 0) visit(static_cast<const Brick&>(brick));
  }
}

}  // namespace semantic_slam
