#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <octomap/octomap_types.h>

#include <octomap/OcTreeKey.h>  // needs what the one above includes

namespace semantic_slam {

// Which voxels one scan touches: bits on a grid of bricks (8 x 8 x 8 voxels) around the sensor.
// Bricks, and the voxels in them, are in Morton order, the order in which an octree lies in memory,
// so that writing the scan into a tree is one walk over it. Reusable; not thread-safe.
class ScanGrid {
 public:
  struct Brick {
    std::array<std::uint64_t, 8> free{};  // a ray passes
    std::array<std::uint64_t, 8> hit{};   // something is there
    std::array<std::uint64_t, 8>
        end{};  // a measurement lies there, whether it counts as a hit or not
    std::array<std::uint32_t, 8> first_slot{};  // of each word of `end`
  };

  // Forgets everything. The grid covers the voxels from `lowest` to `highest`, and some around
  // them.
  void Reset(const octomap::OcTreeKey& lowest, const octomap::OcTreeKey& highest);

  bool Covers(const octomap::OcTreeKey& key) const;

  // Preconditions of all below: Covers(key).
  void MarkEnd(const octomap::OcTreeKey& key) { Mark(key, &Brick::end); }
  void MarkHit(const octomap::OcTreeKey& key) { Mark(key, &Brick::hit); }
  Brick& BrickAt(int x, int y, int z);
  static void MarkFree(Brick& brick, int x, int y, int z) {
    const unsigned bit = BitOf(x, y, z);
    brick.free[bit >> 6] |= std::uint64_t{1} << (bit & 63);
  }

  // Numbers the voxels marked as ends, in Morton order; returns how many there are. Then SlotOf()
  // tells an end's number. No further end may be marked.
  std::uint32_t AssignSlots();
  std::uint32_t SlotOf(const octomap::OcTreeKey& key) {
    return Slot(BrickAt(key[0], key[1], key[2]), BitOf(key[0], key[1], key[2]));
  }

  // Calls visit(key, is_hit, slot) for every free or hit voxel in Morton order; a voxel that is
  // both is a hit. `slot` is only meaningful for hits.
  template <typename Visit>
  void ForEachUpdate(Visit&& visit);

 private:
  struct Place {
    std::uint64_t morton;  // of the brick
    std::array<int, 3> corner;
    std::uint32_t index;  // into bricks_
    bool operator<(const Place& other) const { return morton < other.morton; }
  };

  static constexpr std::array<std::uint16_t, 8> kSpread{0,  1,  8,  9,
                                                        64, 65, 72, 73};  // bits apart by three
  static unsigned BitOf(int x, int y, int z) {
    return kSpread[x & 7] | kSpread[y & 7] << 1 | kSpread[z & 7] << 2;
  }
  // Every third bit of nine, closed up.
  static int Gather(unsigned bits) { return (bits & 1) | (bits >> 2 & 2) | (bits >> 4 & 4); }
  static std::uint32_t Slot(const Brick& brick, unsigned bit) {
    const std::uint64_t before = (std::uint64_t{1} << (bit & 63)) - 1;
    return brick.first_slot[bit >> 6] +
           static_cast<std::uint32_t>(__builtin_popcountll(brick.end[bit >> 6] & before));
  }

  void Mark(const octomap::OcTreeKey& key, std::array<std::uint64_t, 8> Brick::*layer) {
    const unsigned bit = BitOf(key[0], key[1], key[2]);
    (BrickAt(key[0], key[1], key[2]).*layer)[bit >> 6] |= std::uint64_t{1} << (bit & 63);
  }
  void SortBricks();

  std::array<int, 3> first_{};       // brick coordinates of the lowest corner
  std::array<int, 3> count_{};       // bricks along each axis
  std::vector<std::int32_t> index_;  // by brick: into bricks_, or -1
  std::vector<Brick> bricks_;
  std::vector<Place> places_;  // of bricks_, sorted when updates are visited
};

template <typename Visit>
void ScanGrid::ForEachUpdate(Visit&& visit) {
  SortBricks();
  for (const Place& place : places_) {
    const Brick& brick = bricks_[place.index];
    for (unsigned word = 0; word < 8; ++word) {
      for (std::uint64_t left = brick.free[word] | brick.hit[word]; left != 0; left &= left - 1) {
        const unsigned bit = word << 6 | static_cast<unsigned>(__builtin_ctzll(left));
        const bool is_hit = brick.hit[word] >> (bit & 63) & 1;
        const octomap::OcTreeKey key(
            static_cast<octomap::key_type>(place.corner[0] + Gather(bit)),
            static_cast<octomap::key_type>(place.corner[1] + Gather(bit >> 1)),
            static_cast<octomap::key_type>(place.corner[2] + Gather(bit >> 2)));
        visit(key, is_hit, is_hit ? Slot(brick, bit) : 0u);
      }
    }
  }
}

}  // namespace semantic_slam
