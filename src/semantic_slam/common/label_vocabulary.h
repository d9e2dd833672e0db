#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace semantic_slam {

using LabelId = std::uint8_t;
constexpr LabelId kUnknownLabel = 0;     // no class is known
constexpr LabelId kReservedLabel = 255;  // never a class

// One class of the vocabulary.
struct LabelClass {
  LabelId id = kUnknownLabel;
  std::string name;                             // as SUN RGB-D names it, where it does
  std::array<std::uint8_t, 3> rgb{0, 0, 0};     // in every picture and map
  bool movable = false;                         // may stand elsewhere tomorrow: chair, person
  bool hollow = false;                          // a robot may fit below or inside: table
  int cost = 254;                               // of a grid cell that it surely fills, 0..254
};

// The one list of classes that all messages, maps and files mean by their label ids:
// config/labels.yaml. Immutable, so safe from any thread.
class LabelVocabulary {
 public:
  // Throws ConfigError if ids or names are not unique, an id is 255, id 0 is missing or not called
  // "unknown", or a name is empty.
  explicit LabelVocabulary(std::vector<LabelClass> classes);

  // Reads the YAML file at `path`. Throws ConfigError naming file, line and key.
  static LabelVocabulary Load(const std::string& path);

  // By ascending id; the first is "unknown".
  const std::vector<LabelClass>& classes() const { return classes_; }

  bool Contains(LabelId id) const { return index_[id] >= 0; }

  // Precondition: Contains(id).
  const LabelClass& operator[](LabelId id) const { return classes_[index_[id]]; }

  // The id of the class with that name; nullopt if there is none.
  std::optional<LabelId> Find(const std::string& name) const;

  // FNV-1a over ids and names: equal for equal vocabularies. Messages and files carry it, and who has
  // another refuses them.
  std::uint64_t hash() const { return hash_; }

 private:
  std::vector<LabelClass> classes_;
  std::array<std::int16_t, 256> index_;  // by id: where it stands in classes_, or -1
  std::uint64_t hash_ = 0;
};

}  // namespace semantic_slam
