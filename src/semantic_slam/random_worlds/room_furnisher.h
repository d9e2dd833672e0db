#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/random_worlds/arrangement.h"
#include "semantic_slam/random_worlds/free_space.h"
#include "semantic_slam/worlds/building.h"
#include "semantic_slam/worlds/world_assembly.h"

namespace semantic_slam {

// Puts arrangements into a room where there is space. Not thread-safe; keeps references.
class RoomFurnisher {
 public:
  RoomFurnisher(const Building& building, const Room& room, RandomStream& random,
                WorldAssembly& assembly);

  // Tries places at random; false if the arrangement fits nowhere that it tried.
  bool Place(const Arrangement& arrangement);

  // At a place of choice, if it fits there.
  bool PlaceAt(const Arrangement& arrangement, const Rigid3d& T_world_arrangement);

  FreeSpace& space() { return space_; }
  const Room& room() const { return room_; }
  const Eigen::AlignedBox2d& inside_m() const { return inside_m_; }

 private:
  Rigid3d TryWall(double half_width_m);
  Rigid3d TryFloor();
  bool Fits(const Item& item, const Rigid3d& T_world_arrangement) const;
  bool FitsAt(const Arrangement& arrangement, const Rigid3d& T_world_arrangement) const;
  void Furnish(const Arrangement& arrangement, const Rigid3d& T_world_arrangement);
  std::vector<bool> WhatFits(const Arrangement& arrangement,
                             const Rigid3d& T_world_arrangement) const;
  std::optional<Rigid3d> PoseOnTop(const Item& item, const std::string& support) const;

  const Building& building_;
  const Room& room_;
  RandomStream& random_;
  WorldAssembly& assembly_;
  const Eigen::AlignedBox2d inside_m_;
  FreeSpace space_;
};

}  // namespace semantic_slam
