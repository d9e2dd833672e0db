#pragma once

#include <functional>
#include <vector>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/random_worlds/groups.h"

namespace semantic_slam {

// What a room is for, which decides what stands in it.
enum class RoomType {
  kLiving,
  kDining,
  kKitchen,
  kBedroom,
  kStudy,
  kOffice,
  kMeeting,
  kCorridor,
  kWaiting
};

// Something that a room may have.
struct Wish {
  std::function<Arrangement(PieceMaker&)> make;
  double chance = 1.0;  // of each
  int most = 1;
};

// By their importance: what comes first finds more space.
const std::vector<Wish>& WishesOf(RoomType type);

// What may be anywhere, even where it makes no sense.
const std::vector<Wish>& OddWishes();

// Types of the rooms of one building, which is a home, an office or something between; `narrow`
// says which rooms can only be corridors.
std::vector<RoomType> ChooseTypes(const std::vector<bool>& narrow, RandomStream& random);

}  // namespace semantic_slam
