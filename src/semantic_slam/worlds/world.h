#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/worlds/material.h"
#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

// To and fro about an axis, as a leg of somebody who walks: angle = amplitude * sin(2 pi t / period
// + phase).
struct Swing {
  Eigen::Vector3d pivot_m = Eigen::Vector3d::Zero();  // object frame
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  double amplitude_rad = 0.0;
  double period_s = 1.0;
  double phase_rad = 0.0;
};

// A piece of an object that is of one material.
struct Surface {
  Mesh mesh;         // object frame
  int material = 0;  // index into World::materials
  std::optional<Swing> swing;
};

// A closed walk over the floor: straight on between corners, turning on the spot, over and over.
// Immutable, so safe from any thread.
class Walk {
 public:
  // Throws ConfigError if there are fewer than two corners, two successive ones coincide, or a
  // speed is not positive.
  Walk(std::vector<Eigen::Vector2d> corners_m, double speed_mps, double turn_rate_radps = 1.5);

  // Pose at `time_s`: on the floor, x ahead. Any time is allowed.
  Rigid3d Pose(double time_s) const;

  // Path length [m] until `time_s`: the phase of legs.
  double Distance(double time_s) const;

  // Time [s] after which the walk begins anew.
  double RoundDuration() const { return round_s_; }

 private:
  struct Place {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
    double heading_rad = 0.0;
    double distance_m = 0.0;
  };

  Eigen::Vector2d Leg(std::size_t i) const;  // from corner i to the next
  double TurnAfter(std::size_t i) const;     // [rad], at the end of leg i
  Place PlaceAt(double time_s) const;

  std::vector<Eigen::Vector2d> corners_m_;
  double speed_mps_;
  double turn_rate_radps_;
  double round_s_ = 0.0;
  double round_m_ = 0.0;
};

using InstanceId = std::uint16_t;
constexpr InstanceId kNoInstance = 0;

// One thing in a world. Its frame: origin on its floor (for something on a wall: its lower edge's
// middle on the wall), x to its front, z up.
struct WorldObject {
  InstanceId instance = kNoInstance;  // 1, 2, 3... in the world file's order
  std::string name;  // as the world file calls it, or its kind and number: "chair_3"
  LabelId label = kUnknownLabel;
  bool is_structure = false;  // walls, floor, ceiling: part of the building, no object of its own
  Rigid3d T_world_object = Rigid3d::Identity();  // at time 0
  std::vector<Surface> surfaces;
  std::optional<Walk> walk;  // replaces T_world_object

  Rigid3d Pose(double time_s) const { return walk ? walk->Pose(time_s) : T_world_object; }
  bool IsMoving() const { return walk.has_value(); }
};

// A lamp that shines from a horizontal square.
struct Light {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  double side_m = 0.5;
  std::array<float, 3> radiant_rgb{1.0f, 1.0f, 1.0f};  // 1: a white floor 2 m below it looks white
};

// A furnished building with lamps. World frame: z up, the floor at z = 0.
struct World {
  std::string name;
  std::uint64_t vocabulary_hash = 0;  // whose ids the labels are
  std::vector<Material> materials;
  std::vector<WorldObject> objects;  // objects[i].instance == i + 1
  std::vector<Light> lights;
  std::array<float, 3> ambient_rgb{0.25f, 0.25f, 0.25f};  // light from everywhere
  Eigen::AlignedBox3d bounds_m;                           // of all that does not move
};

}  // namespace semantic_slam
