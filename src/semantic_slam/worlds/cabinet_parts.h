#pragma once

#include "semantic_slam/worlds/furniture_builder.h"

namespace semantic_slam {

// Parts of cupboards and chests that stand on the floor: materials "body", "fronts", "handles" and
// "top".

constexpr float kFrontM = 0.018f;   // thickness of drawer fronts and doors
constexpr float kHandleM = 0.022f;  // how far handles stick out
constexpr float kGapM = 0.003f;     // around fronts

// The space that a row of fronts covers: heights and the left and right end.
struct FrontArea {
  float low_m;
  float high_m;
  float right_m;  // smallest y
  float left_m;
};

// x of the carcass's front, on which drawer fronts and doors lie.
float FaceOf(const FurnitureBuilder& b);

void AddFront(FurnitureBuilder& b, const FrontArea& area);

// About a place of the front; it reaches to the front of the piece.
void AddHandle(FurnitureBuilder& b, float y_m, float z_m, float width_m, float height_m);

// One above the other, each with a handle.
void AddDrawers(FurnitureBuilder& b, const FrontArea& area, int rows);

// Doors side by side; handles where two of them meet.
void AddDoors(FurnitureBuilder& b, const FrontArea& area, int doors);

FrontArea WholeFront(const FurnitureBuilder& b, float low_m, float high_m);

// The closed box behind the fronts.
void AddCarcass(FurnitureBuilder& b, float low_m, float high_m);

// Four short legs.
void AddFeet(FurnitureBuilder& b, float height_m);

// A board on top that sticks out a little.
void AddTopBoard(FurnitureBuilder& b, float thickness_m);

}  // namespace semantic_slam
