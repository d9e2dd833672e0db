#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// The surface of one class near a point.
struct NearbySurface {
  LabelId label = kUnknownLabel;
  double distance_m = 0.0;
};

// Which classes' surfaces of a world are where: its triangles in a hash of cubes. Holds all that
// does not move. Immutable, so safe from any thread.
class SurfaceLabels {
 public:
  explicit SurfaceLabels(const World& world);

  // The nearest surface of each class that is within `reach_m` of the point, the nearest first; of
  // equally near ones that of smaller id. Meant for reaches of some decimetres.
  std::vector<NearbySurface> Around(const Eigen::Vector3d& point, double reach_m) const;

  // Whether a surface lies between two points, at least 1 cm away from either; those of the object
  // `ignored` do not count.
  bool IsBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                 InstanceId ignored = kNoInstance) const;

 private:
  struct Triangle {
    Eigen::Vector3f a, b, c;
    LabelId label;
    InstanceId instance;
  };
  using Cube = Eigen::Vector3i;

  static Cube CubeOf(const Eigen::Vector3d& point);
  static std::uint64_t KeyOf(const Cube& cube);
  static double Distance(const Triangle& triangle, const Eigen::Vector3d& point);
  void Add(const Triangle& triangle);
  bool IsBlockedInCube(const Cube& cube, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                       InstanceId ignored) const;

  std::vector<Triangle> triangles_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;  // triangles in each
};

}  // namespace semantic_slam
