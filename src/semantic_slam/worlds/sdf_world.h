#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// A model that flies in the world and lies in a folder of its own.
struct SdfDrone {
  std::string uri;  // such as model://hummingbird_d455
  Rigid3d T_world_drone = Rigid3d::Identity();
};

// What each object's model is called: its name, with what SDF does not allow taken out, and its
// number where that is not unique. By index into World::objects.
std::vector<std::string> ModelNames(const World& world);

// Lays rotation and translation out as SDF does: "x y z roll pitch yaw" [m, rad], about fixed axes.
std::string SdfPose(const Rigid3d& T);

// A world as SDF 1.6, for Gazebo 11: a static model per object whose shape, also for collisions, is
// meshes/<model name>.obj; who walks is an actor, which Gazebo moves along its way and collides
// with nothing; lamps as points of light, and a sun that shines on the building from outside. The
// same world gives the same bytes.
std::string SdfText(const World& world, const std::vector<std::string>& model_names,
                    const std::optional<SdfDrone>& drone);

}  // namespace semantic_slam
