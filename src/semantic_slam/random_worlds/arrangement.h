#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/worlds/furniture.h"

namespace semantic_slam {

// A piece in an arrangement. Places are in the arrangement's frame, on the plan, or in that of the
// piece that it lies on.
struct Item {
  std::string kind;
  FurnitureRequest request;  // with a size
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  double z_m = 0.0;                // of its foot; not of what lies on another
  std::optional<std::size_t> on;   // index of the item that it lies on: on its highest surface
  std::optional<double> height_m;  // above the foot of that, instead: on a seat
  bool is_flat = false;            // a rug: furniture stands on it
  bool is_optional = false;        // left out, with what lies on it, where it does not fit

  float depth_m() const { return request.size_m->x(); }
  float width_m() const { return request.size_m->y(); }
  float top_m() const { return request.size_m->z(); }
};

// Where an arrangement's frame may be put.
enum class Anchor {
  kWall,  // at the foot of a wall, x into the room; its middle is y = 0
  kFree   // anywhere on the floor, turned anyhow
};

// Pieces that belong together, such as a table with its chairs.
struct Arrangement {
  Anchor anchor = Anchor::kFree;
  std::vector<Item> items;
  double access_m = 0.0;  // kept free in front (+x) of all of it

  // Returns the index of the item.
  std::size_t Add(Item item) {
    items.push_back(std::move(item));
    return items.size() - 1;
  }
};

}  // namespace semantic_slam
