#pragma once

#include "semantic_slam/worlds/furniture_builder.h"

namespace semantic_slam {

// A free space on a board: from `right_m` to `left_m` (y), from the board up, as deep as from
// `rear_m` to `front_m` (x).
struct ShelfSpace {
  float rear_m;
  float front_m;
  float right_m;
  float left_m;
  float low_m;
  float high_m;
};

// Groups of books, each of one height and depth, with gaps and what lies about between them. Of
// materials "books" and "paper".
void FillWithBooks(FurnitureBuilder& b, const ShelfSpace& space);

}  // namespace semantic_slam
