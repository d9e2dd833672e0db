#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <octomap/octomap_types.h>

#include <octomap/OcTreeKey.h>  // needs what the one above includes

namespace semantic_slam {

// The voxels that a ray passes on its way to the one it ends in, by the digital differential
// analyser of Amanatides and Woo (Eurographics 1987). Rounds where OctoMap's computeRayKeys() does,
// so that both name the same voxels.
class RayWalk {
 public:
  // `tree` gives resolution and keys. Precondition: both points are inside of it.
  template <typename Tree>
  RayWalk(const Tree& tree, const octomap::point3d& origin, const octomap::OcTreeKey& origin_key,
          const octomap::point3d& end)
      : end_key_(tree.coordToKey(end)), key_{origin_key[0], origin_key[1], origin_key[2]} {
    octomap::point3d direction = end - origin;
    length_ = static_cast<float>(direction.norm());
    direction /= length_;
    const double resolution = tree.getResolution();
    for (unsigned i = 0; i < 3; ++i) {
      step_[i] = direction(i) > 0.0f ? 1 : direction(i) < 0.0f ? -1 : 0;
      if (step_[i] == 0) continue;
      const double border =
          tree.keyToCoord(origin_key[i]) + static_cast<float>(step_[i] * resolution * 0.5);
      next_[i] = (border - origin(i)) / direction(i);
      delta_[i] = resolution / std::fabs(direction(i));
    }
  }

  // Calls visit(x, y, z) with the keys from the voxel where it stands on, without the end's.
  template <typename Visit>
  void ForEachVoxel(Visit&& visit) {
    if (IsAtEnd()) return;
    do {
      visit(key_[0], key_[1], key_[2]);
      const int axis =
          next_[0] < next_[1] ? (next_[0] < next_[2] ? 0 : 2) : (next_[1] < next_[2] ? 1 : 2);
      key_[axis] += step_[axis];
      next_[axis] += delta_[axis];
      // By rounding a ray may pass its end by; its length stops it then.
    } while (!IsAtEnd() && !(std::min(std::min(next_[0], next_[1]), next_[2]) > length_));
  }

  bool IsAtEnd() const {
    return key_[0] == end_key_[0] && key_[1] == end_key_[1] && key_[2] == end_key_[2];
  }

  // Where it stands, for who walks it in another way.
  struct Axis {
    int key;
    int end_key;
    int step;      // -1, 0 or 1
    double next;   // where the ray leaves the voxel along this axis [m]
    double delta;  // from one border to the next [m]
  };
  Axis axis(int i) const { return {key_[i], end_key_[i], step_[i], next_[i], delta_[i]}; }
  void Set(int i, int key, double next) {
    key_[i] = key;
    next_[i] = next;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::max();

  const octomap::OcTreeKey end_key_;
  std::array<int, 3> key_;
  std::array<int, 3> step_{};
  std::array<double, 3> next_{kNever, kNever, kNever};
  std::array<double, 3> delta_{kNever, kNever, kNever};
  float length_ = 0.0f;
};

}  // namespace semantic_slam
