#pragma once

#include <string>
#include <vector>

#include "semantic_slam/random_worlds/arrangement.h"
#include "semantic_slam/random_worlds/piece_maker.h"

namespace semantic_slam {

// Furniture as it is found together. All take what they need at random.

// One piece; with small things on it where it has a top for them.
Arrangement SinglePiece(PieceMaker& maker, const std::string& kind, Anchor anchor);

// On a wall, its lower edge between two heights [m].
Arrangement OnWall(PieceMaker& maker, const std::string& kind, double low_m, double high_m);

// A sofa with a coffee table before it, and maybe a rug, armchairs, a side table, lamps.
Arrangement SofaGroup(PieceMaker& maker);
// Two or more sofas or armchairs face each other over a coffee table.
Arrangement LoungeGroup(PieceMaker& maker);
// Chairs or a bench in a row along a wall.
Arrangement ChairRow(PieceMaker& maker);
// A tv stand or sideboard with a tv.
Arrangement TvGroup(PieceMaker& maker);
// A table with chairs around it, laid or not.
Arrangement DiningGroup(PieceMaker& maker);
// The same, small and round.
Arrangement RoundTableGroup(PieceMaker& maker);

// A desk with what is on it, and somebody's chair.
Arrangement DeskAtWall(PieceMaker& maker);
Arrangement DeskInRoom(PieceMaker& maker);
// Two or four desks face to face.
Arrangement DeskBlock(PieceMaker& maker);
Arrangement ConferenceGroup(PieceMaker& maker);
// On a wall or on a stand.
Arrangement Whiteboard(PieceMaker& maker);

// A bed with night stands, pillows, a picture above.
Arrangement BedGroup(PieceMaker& maker);
// Counters with sink, stove and fridge, wall cabinets above them.
Arrangement KitchenRow(PieceMaker& maker);
// Two or three of one kind side by side at a wall.
Arrangement RowAtWall(PieceMaker& maker, const std::string& kind, int most);

// Puts up to `most` of `kinds` on the top of an item, apart from each other.
void AddClutter(PieceMaker& maker, const std::vector<std::string>& kinds, int most,
                std::size_t support, Arrangement& arrangement);

// Lays a rug on the floor, where others may stand on it.
void AddRug(PieceMaker& maker, const std::string& kind, const Eigen::Vector2d& middle_m,
            double yaw_rad, Arrangement& arrangement);

// Puts chairs of one sort around a table at the origin, some at its ends if `at_ends`.
void AddChairsAround(PieceMaker& maker, const Item& table, const std::string& chair_kind,
                     bool at_ends, Arrangement& arrangement);

}  // namespace semantic_slam
