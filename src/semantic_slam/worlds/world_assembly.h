#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/worlds/building.h"
#include "semantic_slam/worlds/furniture.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// Height [m, object frame] of the highest surface of an object that still stands at a place of its
// plan; nullopt where there is none.
std::optional<double> TopAt(const WorldObject& object, const Eigen::Vector2d& at_m);

// Puts a world together piece by piece. Not thread-safe.
class WorldAssembly {
 public:
  WorldAssembly(const std::string& name, const LabelVocabulary& vocabulary);

  // Adds floors, ceilings and walls of all rooms; their objects are called "kitchen/wall".
  void AddBuilding(const Building& building);

  // Adds a piece with the lamps that it carries, and returns its object, until the next call.
  // Throws ConfigError if the name is taken or the vocabulary lacks the label.
  const WorldObject& Add(const std::string& name, const Furniture& piece,
                         const Rigid3d& T_world_object,
                         const std::optional<Walk>& walk = std::nullopt);

  void AddLight(const Light& light) { world_.lights.push_back(light); }
  void SetAmbient(const std::array<float, 3>& rgb) { world_.ambient_rgb = rgb; }

  // "chair_3", if there are chair_1 and chair_2.
  std::string FreeName(const std::string& kind) const;

  // nullptr if there is none.
  const WorldObject* Find(const std::string& name) const;

  // The world so far.
  World Finish();

 private:
  int MaterialIndex(const Material& material);
  WorldObject& AddObject(const std::string& name, const Furniture& piece);

  const LabelVocabulary vocabulary_;
  World world_;
};

}  // namespace semantic_slam
