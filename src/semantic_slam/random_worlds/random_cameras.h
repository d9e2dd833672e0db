#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/worlds/clearance.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// Finds places for cameras in a world: free ones, 0.4 to 2 m above the floor, that look about
// anyhow or at an object, of furniture's classes more often than of others. It looks at a world
// that must outlive it. Not thread-safe.
class RandomCameras {
 public:
  RandomCameras(const World& world, const LabelVocabulary& vocabulary, std::uint64_t seed);

  // T_world_camera of the optical frame; at least 0.35 m from every surface. nullopt if no free
  // place was found.
  std::optional<Rigid3d> Next();

 private:
  struct Target {
    Eigen::Vector3d centre_m;
    double radius_m;
  };
  struct Targets {
    std::vector<Target> of_class;
    double weight;
  };

  std::optional<Rigid3d> LookAbout();
  std::optional<Rigid3d> LookAtObject();
  bool IsFree(const Eigen::Vector3d& position_m) const;
  Rigid3d Pose(const Eigen::Vector3d& position_m, double yaw_rad, double pitch_rad);

  const Clearance clearance_;
  RandomStream random_;
  std::vector<Eigen::AlignedBox3d> rooms_m_;
  std::vector<Targets> targets_;
};

}  // namespace semantic_slam
