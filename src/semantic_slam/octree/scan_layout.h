#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <octomap/octomap_types.h>

#include <octomap/OcTreeKey.h>  // needs what the one above includes

namespace semantic_slam {

// Numbers the voxels around the sensor, so that what one scan touches can be kept in arrays. A
// number has two parts: which brick of 8 x 8 x 8 voxels, and above its lowest nine bits nothing
// else; and in those bits where in the brick, in Morton order, the order in which an octree lies in
// memory. It is the sum of three numbers, one for each axis, so a step along an axis is an
// addition.
class ScanLayout {
 public:
  using Number = std::uint64_t;

  static constexpr int kBrickBits = 9;
  static constexpr int kBrickVoxels = 1 << kBrickBits;

  // Covers the voxels from `lowest` to `highest`, and some around them.
  void Reset(const octomap::OcTreeKey& lowest, const octomap::OcTreeKey& highest);

  bool Covers(const octomap::OcTreeKey& key) const {
    for (unsigned i = 0; i < 3; ++i) {
      const auto brick = static_cast<unsigned>((key[i] >> 3) - first_[i]);
      if (brick >= static_cast<unsigned>(count_[i])) return false;
    }
    return true;
  }

  std::size_t bricks() const { return bricks_; }

  // Precondition: Covers(key).
  Number NumberOf(const octomap::OcTreeKey& key) const {
    return On(0, key[0]) + On(1, key[1]) + On(2, key[2]);
  }
  Number On(int axis, int key) const { return numbers_[axis][key - 8 * first_[axis]]; }

  // On(axis, key) is numbers(axis)[key - lowest(axis)].
  const Number* numbers(int axis) const { return numbers_[axis].data(); }
  int lowest(int axis) const { return 8 * first_[axis]; }

  // The lowest key in the brick of that number.
  octomap::OcTreeKey CornerOf(std::size_t brick) const;

  // Where in its brick a voxel is, 0..511.
  static unsigned PlaceOf(const octomap::OcTreeKey& key) {
    return kSpread[key[0] & 7] | kSpread[key[1] & 7] << 1 | kSpread[key[2] & 7] << 2;
  }

  // The key of a voxel by its place in a brick, 0..511.
  static octomap::OcTreeKey KeyOf(const octomap::OcTreeKey& corner, unsigned place) {
    return {static_cast<octomap::key_type>(corner[0] + Gather(place)),
            static_cast<octomap::key_type>(corner[1] + Gather(place >> 1)),
            static_cast<octomap::key_type>(corner[2] + Gather(place >> 2))};
  }

 private:
  // The bits of 0..7, three apart.
  static constexpr std::array<unsigned, 8> kSpread{0, 1, 8, 9, 64, 65, 72, 73};

  // Every third bit of nine, closed up.
  static int Gather(unsigned bits) { return (bits & 1) | (bits >> 2 & 2) | (bits >> 4 & 4); }

  std::array<int, 3> first_{};  // brick coordinates of the lowest corner
  std::array<int, 3> count_{};  // bricks along each axis
  std::size_t bricks_ = 0;
  std::array<std::vector<Number>, 3> numbers_;
};

}  // namespace semantic_slam
