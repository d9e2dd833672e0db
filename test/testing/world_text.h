#pragma once

#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/worlds/world_file.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {

// Loads worlds from text, with the vocabulary of config/labels.yaml.
class WorldText {
 public:
  World Load(const std::string& yaml) const {
    const LabelVocabulary vocabulary =
        LabelVocabulary::Load(std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/labels.yaml");
    return LoadWorld(folder_.Write("w.yaml", yaml), vocabulary);
  }

  // Of its ConfigError, without the folder's name; "" if there is none.
  std::string ErrorOf(const std::string& yaml) const {
    std::string message = MessageOf<ConfigError>([&] { Load(yaml); });
    const std::size_t at = message.find(folder_.path());
    return at == std::string::npos ? message : message.erase(at, folder_.path().size() + 1);
  }

  // The object of that name. Precondition: there is one.
  static const WorldObject& Named(const World& world, const std::string& name) {
    for (const WorldObject& object : world.objects) {
      if (object.name == name) return object;
    }
    throw std::out_of_range("no object is called " + name);
  }

 private:
  TemporaryFolder folder_;
};

// A hall of 4 x 3 m and, to its east, a bath of 2 x 3 m; walls of 10 cm.
constexpr char kTwoRooms[] =
    "wall_thickness_m: 0.1\n"
    "rooms:\n"
    "  - {name: hall, from: [0, 0], to: [4, 3]}\n"
    "  - {name: bath, from: [4, 0], to: [6, 3]}\n";

}  // namespace semantic_slam
