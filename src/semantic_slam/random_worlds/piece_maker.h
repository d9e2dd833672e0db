#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/random_worlds/arrangement.h"
#include "semantic_slam/random_worlds/world_split.h"
#include "semantic_slam/worlds/furniture.h"

namespace semantic_slam {

// Thinks up pieces of furniture of one world: design, size, materials, details. Pieces of a world
// share a small stock of materials, as in homes. Not thread-safe.
class PieceMaker {
 public:
  PieceMaker(WorldSplit split, std::uint64_t seed) : split_(split), random_(seed) {}

  RandomStream& random() { return random_; }

  // A piece at the origin. Its request has a size.
  Item Make(const std::string& kind);

  // The same of a given size [m], where design 0 fits in best: what a window or a niche dictates.
  Item MakeOfSize(const std::string& kind, const Eigen::Vector3f& size_m);

  Material MaterialLike(const Material& usual);

 private:
  int ChooseDesign(const FurnitureKind& kind);
  void ChooseDetails(const FurnitureKind& kind, int design, FurnitureRequest& request);
  Eigen::Vector3f ChooseSize(const FurnitureKind& kind, int design);

  const WorldSplit split_;
  RandomStream random_;
  std::map<std::pair<std::string, bool>, std::vector<Material>> stock_;  // pattern, shines
};

}  // namespace semantic_slam
