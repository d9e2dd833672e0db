#pragma once

#include <vector>

#include <Eigen/Core>

#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// What in a world is nearest to a place, and how near.
struct NearestSurface {
  double distance_m = 0.0;
  InstanceId instance = kNoInstance;
};

// Tells how much room there is around a place in a world. It looks at a world that must outlive it,
// and is otherwise immutable, so safe from any thread.
class Clearance {
 public:
  explicit Clearance(const World& world);

  // At `time_s` of the world: people walk, but their limbs do not swing. Without any surface the
  // distance is infinite.
  NearestSurface At(const Eigen::Vector3d& position_m, double time_s) const;

 private:
  const World& world_;
  std::vector<Eigen::AlignedBox3d> bounds_m_;  // one per object, in its frame
};

}  // namespace semantic_slam
