#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// What a piece of furniture is fixed to.
enum class Mount { kFloor, kWall, kCeiling };

// A property of a kind that is a number, and what it may be.
struct NumberRange {
  double usual = 0.0;
  double low = 0.0;
  double high = 1.0;
};

class FurnitureBuilder;

// Another shape of a kind, and its usual size: depth, width, height.
struct FurnitureDesign {
  void (*build)(FurnitureBuilder&) = nullptr;
  Eigen::Vector3f size_m;
};

// A kind of furniture: what it is called, what can be chosen, and how it is built.
struct FurnitureKind {
  std::string name;
  std::string label;  // of config/labels.yaml
  Mount mount = Mount::kFloor;
  Eigen::Vector3f size_m;                           // the usual: depth (x), width (y), height (z)
  std::map<std::string, Material> materials;        // the usual, by the part of it that they cover
  std::map<std::string, NumberRange> numbers;       // other properties
  void (*build)(FurnitureBuilder&) = nullptr;       // design 0
  std::vector<FurnitureDesign> other_designs = {};  // 1, 2...; chosen by the number "design"
};

// How many designs there are to choose from: 1 or more.
int DesignCount(const FurnitureKind& kind);

// The usual size of a design, 0 <= design < DesignCount(kind).
const Eigen::Vector3f& UsualSize(const FurnitureKind& kind, int design);

// All kinds by ascending name.
const std::vector<FurnitureKind>& FurnitureKinds();

// Throws ConfigError naming a kind that does not exist, and those that do.
const FurnitureKind& FindFurnitureKind(const std::string& name);

// What may be asked of a piece; what is not asked for is as usual for its kind.
struct FurnitureRequest {
  std::optional<Eigen::Vector3f> size_m;      // 0.2 to 5 times the usual of its design
  std::map<std::string, Material> materials;  // by part
  std::map<std::string, double> numbers;
  std::uint64_t seed = 1;  // other seeds give other pieces of the same kind
};

// A part of a piece that is of one material.
struct FurniturePart {
  Mesh mesh;
  Material material;
  std::optional<Swing> swing;
};

// A piece of furniture that stands nowhere yet. Its frame is that of a WorldObject, its bounding
// box (at rest) exactly of the size asked for: about the z axis and from z = 0 up; from x = 0 to
// the front for what hangs on a wall.
struct Furniture {
  std::string kind;
  std::string label;
  Mount mount = Mount::kFloor;
  Eigen::Vector3f size_m;
  std::vector<FurniturePart> parts;
  std::vector<Light> lights;  // that it carries, in its frame
};

// Builds a piece. The same request gives the same piece. Throws ConfigError naming what is unknown
// or out of range: kind, material's part, number, size.
Furniture MakeFurniture(const std::string& kind, const FurnitureRequest& request = {});

}  // namespace semantic_slam
