#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// A world's meshes and materials in Wavefront's text formats, for other programs' renderers. The
// same world gives the same bytes.

// What the file of each material's picture is called, without folder and extension: "wood_12". By
// index into World::materials.
std::vector<std::string> TextureNames(const World& world);

// An object's surfaces as an OBJ file, in the object's frame and at rest: nobody lifts a leg.
// Materials are called as their textures are. `texture_sizes_m` are width and height of the
// materials' pictures, by index into World::materials.
std::string ObjText(const WorldObject& object, const std::vector<std::string>& texture_names,
                    const std::vector<Eigen::Vector2f>& texture_sizes_m,
                    const std::string& mtl_file);

// The MTL file to it: those materials that the object has. `texture_folder` is where
// <texture name>.png lies, as seen from the file.
std::string MtlText(const WorldObject& object, const World& world,
                    const std::vector<std::string>& texture_names,
                    const std::string& texture_folder);

}  // namespace semantic_slam
