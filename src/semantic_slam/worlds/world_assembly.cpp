#include "semantic_slam/worlds/world_assembly.h"

#include <algorithm>
#include <limits>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr std::size_t kMostObjects = std::numeric_limits<InstanceId>::max() - 1;

// Height of a triangle at a place of the plan; nullopt beside it.
std::optional<double> HeightAt(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                               const Eigen::Vector3f& c, const Eigen::Vector2d& at_m) {
  Eigen::Matrix2d edges;
  edges.col(0) = (b - a).head<2>().cast<double>();
  edges.col(1) = (c - a).head<2>().cast<double>();
  if (std::abs(edges.determinant()) < 1e-12) return std::nullopt;  // upright
  const Eigen::Vector2d weights = edges.inverse() * (at_m - a.head<2>().cast<double>());
  if (weights.minCoeff() < 0.0 || weights.sum() > 1.0) return std::nullopt;
  return a.z() + weights.x() * (b.z() - a.z()) + weights.y() * (c.z() - a.z());
}

}  // namespace

std::optional<double> TopAt(const WorldObject& object, const Eigen::Vector2d& at_m) {
  std::optional<double> top;
  for (const Surface& surface : object.surfaces) {
    const std::vector<Eigen::Vector3f>& corners = surface.mesh.positions_m;
    for (const Eigen::Vector3i& t : surface.mesh.triangles) {
      const auto height = HeightAt(corners[t[0]], corners[t[1]], corners[t[2]], at_m);
      if (height && (!top || *height > *top)) top = height;
    }
  }
  return top;
}

WorldAssembly::WorldAssembly(const std::string& name, const LabelVocabulary& vocabulary)
    : vocabulary_(vocabulary) {
  world_.name = name;
  world_.vocabulary_hash = vocabulary.hash();
}

int WorldAssembly::MaterialIndex(const Material& material) {
  const auto found = std::find(world_.materials.begin(), world_.materials.end(), material);
  if (found == world_.materials.end()) {
    world_.materials.push_back(material);
    return static_cast<int>(world_.materials.size()) - 1;
  }
  return static_cast<int>(found - world_.materials.begin());
}

const WorldObject* WorldAssembly::Find(const std::string& name) const {
  const auto found = std::find_if(world_.objects.begin(), world_.objects.end(),
                                  [&](const WorldObject& object) { return object.name == name; });
  return found == world_.objects.end() ? nullptr : &*found;
}

std::string WorldAssembly::FreeName(const std::string& kind) const {
  for (int i = 1;; ++i) {
    std::string name = kind + "_" + std::to_string(i);
    if (Find(name) == nullptr) return name;
  }
}

WorldObject& WorldAssembly::AddObject(const std::string& name, const Furniture& piece) {
  const std::optional<LabelId> label = vocabulary_.Find(piece.label);
  if (!label) throw ConfigError("the vocabulary has no label " + piece.label);
  if (Find(name) != nullptr) throw ConfigError("two things are called " + name);
  if (world_.objects.size() >= kMostObjects) throw ConfigError("a world of too many objects");
  WorldObject object;
  object.instance = static_cast<InstanceId>(world_.objects.size() + 1);
  object.name = name;
  object.label = *label;
  for (const FurniturePart& part : piece.parts) {
    object.surfaces.push_back({part.mesh, MaterialIndex(part.material), part.swing});
  }
  world_.objects.push_back(std::move(object));
  return world_.objects.back();
}

void WorldAssembly::AddBuilding(const Building& building) {
  for (const Room& room : building.rooms()) {
    for (const Furniture& structure : building.BuildRoom(room)) {
      AddObject(room.name + "/" + structure.label, structure).is_structure = true;
    }
  }
}

const WorldObject& WorldAssembly::Add(const std::string& name, const Furniture& piece,
                                      const Rigid3d& T_world_object,
                                      const std::optional<Walk>& walk) {
  WorldObject& object = AddObject(name, piece);
  object.walk = walk;
  object.T_world_object = walk ? walk->Pose(0.0) : T_world_object;
  for (Light light : piece.lights) {
    light.centre_m = object.T_world_object * light.centre_m;
    world_.lights.push_back(light);
  }
  return object;
}

World WorldAssembly::Finish() {
  world_.bounds_m.setEmpty();
  for (const WorldObject& object : world_.objects) {
    if (object.IsMoving()) continue;
    for (const Surface& surface : object.surfaces) {
      for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
        world_.bounds_m.extend(object.T_world_object * p.cast<double>());
      }
    }
  }
  return world_;
}

}  // namespace semantic_slam
