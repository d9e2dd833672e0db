#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "semantic_slam/worlds/furniture.h"
#include "semantic_slam/worlds/wall_panel.h"

namespace semantic_slam {

// The four walls of a room, by where they are: -x, -y, +x, +y.
enum class Side { kWest, kSouth, kEast, kNorth };
constexpr std::array<Side, 4> kSides{Side::kWest, Side::kSouth, Side::kEast, Side::kNorth};

// Throws ConfigError unless `name` is west, south, east or north.
Side SideNamed(const std::string& name);

// A hole in all walls that share the place `at_m`, on their common middle.
struct WallOpening {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double width_m = 0.9;
  double bottom_m = 0.0;  // above the floor
  double top_m = 2.05;
};

// A rectangular room. Rooms that touch share a wall; its middle is where they touch.
struct Room {
  std::string name;
  Eigen::AlignedBox2d area_m;  // to the middle of its walls
  double height_m = 2.6;
  Material floor;
  Material ceiling;
  Material skirting;
  std::array<Material, 4> walls;  // by Side
};

// A wall of a room.
struct WallSite {
  const Room* room = nullptr;
  Side side = Side::kWest;
};

// Rooms with walls between and around them: inside, half of the wall belongs to each of two rooms.
// Not thread-safe.
class Building {
 public:
  // Throws ConfigError if the thickness is not between 2 cm and half a metre.
  explicit Building(double wall_thickness_m);

  // Throws ConfigError naming the room if it is too small or low, overlaps another or has its name.
  void AddRoom(const Room& room);

  // Cuts a hole, after all rooms are there. Throws ConfigError if it is in no wall, reaches beyond
  // it or overlaps another.
  void AddOpening(const WallOpening& opening);

  const std::vector<Room>& rooms() const { return rooms_; }

  // Throws ConfigError naming a room that does not exist.
  const Room& FindRoom(const std::string& name) const;

  // The room in which the place is, up to the middle of its walls; nullptr if in none.
  const Room* RoomAt(const Eigen::Vector2d& at_m) const;

  // Parts of the room in the world frame: "floor", "ceiling", "wall" (with its skirting boards).
  std::vector<Furniture> BuildRoom(const Room& room) const;

  // At a wall's foot, x into the room: where `along_m` is the world's y (west, east) or x. Throws
  // ConfigError if that is beyond the wall.
  Rigid3d WallPose(const Room& room, Side side, double along_m) const;

  // The walls that an opening is in: one, or two that lie back to back. Throws ConfigError if none.
  std::vector<WallSite> SitesOf(const WallOpening& opening) const;

  // In the middle of the wall, amid the opening's lower edge; x into the site's room.
  Rigid3d OpeningPose(const WallOpening& opening, const WallSite& site) const;

  // From the inner face of a wall to its middle or, where nothing is behind it, its outer face.
  double HalfThickness(const Room& room, Side side) const;
  double wall_thickness_m() const { return wall_thickness_m_; }

 private:
  // The openings in a wall, from the inner corner on its left.
  std::vector<WallRectangle> HolesIn(const Room& room, Side side) const;
  Furniture BuildWalls(const Room& room) const;
  Eigen::AlignedBox2d OuterArea(const Room& room) const;

  std::vector<Room> rooms_;
  std::vector<WallOpening> openings_;
  double wall_thickness_m_;
};

}  // namespace semantic_slam
