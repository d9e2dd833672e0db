#include "semantic_slam/octree/scan_layout.h"

#include <algorithm>

namespace semantic_slam {
namespace {

// A ray's last steps may stray by a voxel, by rounding.
constexpr int kMarginVoxels = 2;

}  // namespace

void ScanLayout::Reset(const octomap::OcTreeKey& lowest, const octomap::OcTreeKey& highest) {
  for (unsigned i = 0; i < 3; ++i) {
    first_[i] = std::max(lowest[i] - kMarginVoxels, 0) >> 3;
    count_[i] = (std::min(highest[i] + kMarginVoxels, 65535) >> 3) - first_[i] + 1;
  }
  const std::array<std::size_t, 3> stride{static_cast<std::size_t>(count_[1]) * count_[2],
                                          static_cast<std::size_t>(count_[2]), 1};
  bricks_ = stride[0] * count_[0];
  for (unsigned i = 0; i < 3; ++i) {
    numbers_[i].resize(static_cast<std::size_t>(count_[i]) * 8);
    for (std::size_t k = 0; k < numbers_[i].size(); ++k)
      numbers_[i][k] = (k >> 3) * stride[i] << kBrickBits | kSpread[k & 7] << i;
  }
}

octomap::OcTreeKey ScanLayout::CornerOf(std::size_t brick) const {
  const auto corner = [this](unsigned axis, std::size_t index) {
    return static_cast<octomap::key_type>((static_cast<std::size_t>(first_[axis]) + index) * 8);
  };
  return {corner(0, brick / count_[2] / count_[1]), corner(1, brick / count_[2] % count_[1]),
          corner(2, brick % count_[2])};
}

}  // namespace semantic_slam
