#include "semantic_slam/worlds/furniture_file.h"

#include <map>
#include <vector>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/worlds/located_error.h"
#include "semantic_slam/worlds/placement_file.h"

namespace semantic_slam {
namespace {

constexpr double kTwoStepsM = 1.27;  // that a person of usual size makes in one swing of the legs

// The same name always gives the same piece, whatever else the file says.
std::uint64_t SeedOf(const std::string& name) {
  std::uint64_t seed = 0;
  for (const char letter : name) seed = HashOf({seed, static_cast<std::uint64_t>(letter)});
  return seed;
}

void ReadNumbers(YamlReader& reader, const FurnitureKind& kind, FurnitureRequest& request) {
  YamlReader numbers = reader.Group("numbers");
  for (const auto& [name, range] : kind.numbers) {
    double value = range.usual;
    numbers.Read(name, value);
    request.numbers[name] = value;
  }
  numbers.Finish();
}

void ReadSize(YamlReader& reader, FurnitureRequest& request) {
  if (!reader.Has("size_m")) return;
  const auto numbers = reader.Require<std::vector<float>>("size_m");
  if (numbers.size() != 3) reader.Refuse("size_m", "[depth, width, height]");
  request.size_m = Eigen::Vector3f(numbers[0], numbers[1], numbers[2]);
}

// The way that `walk` describes; legs swing as fast as it takes.
std::optional<Walk> ReadWalk(YamlReader& reader, FurnitureRequest& request) {
  if (!reader.Has("walk")) return std::nullopt;
  YamlReader walk = reader.Group("walk");
  const auto places = walk.Require<std::vector<std::vector<double>>>("corners");
  std::vector<Eigen::Vector2d> corners_m;
  for (const std::vector<double>& place : places) {
    if (place.size() != 2) walk.Refuse("corners", "a list of [x, y]");
    corners_m.emplace_back(place[0], place[1]);
  }
  const double speed_mps = walk.Require<double>("speed_mps");
  walk.Finish();
  const Walk result = Located(reader, [&] { return Walk(corners_m, speed_mps); });
  if (request.numbers.count("walking") > 0) {
    request.numbers["walking"] = 1.0;
    request.numbers["step_period_s"] = kTwoStepsM / speed_mps;
  }
  return result;
}

// Puts entries of a world file into a world, one by one.
class FurnitureReader {
 public:
  FurnitureReader(YamlReader& file, const MaterialPalette& palette, const Building& building,
                  WorldAssembly& assembly)
      : palette_(palette), placement_(building, assembly), assembly_(assembly) {
    YamlReader groups = file.Group("groups");
    if (file.Has("groups")) {
      for (const auto& entry : file.Require<YAML::Node>("groups")) {
        const auto name = entry.first.as<std::string>();
        groups_.emplace(name, groups.Entries(name));
      }
    }
    groups.Finish();
  }

  void Add(YamlReader reader) {
    if (reader.Has("group")) {
      AddGroup(reader);
    } else {
      AddOne(reader, "", Rigid3d::Identity());
    }
  }

 private:
  void AddGroup(YamlReader& reader) {
    const auto group = groups_.find(reader.Require<std::string>("group"));
    if (group == groups_.end()) reader.Refuse("group", "one of those under groups");
    const std::string prefix = reader.Require<std::string>("name") + "/";
    const Rigid3d T_world_group = placement_.Read(reader, {}, "", Rigid3d::Identity());
    reader.Finish();
    for (YamlReader member : group->second) AddOne(member, prefix, T_world_group);
  }

  // Places that refer to nothing else are in the frame.
  void AddOne(YamlReader& reader, const std::string& prefix, const Rigid3d& T_world_frame) {
    const auto name = reader.Require<std::string>("kind");
    const FurnitureKind& kind = *Located(reader, [&] { return &FindFurnitureKind(name); });
    FurnitureRequest request;
    ReadSize(reader, request);
    ReadNumbers(reader, kind, request);
    PiecePlace place;
    place.prefix = prefix;
    place.walk = ReadWalk(reader, request);
    if (!place.walk) {
      const Placeable piece{kind.mount, request.size_m.value_or(kind.size_m)};
      place.T_world_object = placement_.Read(reader, piece, prefix, T_world_frame);
    }
    AddPiece(reader, name, request, palette_, place, assembly_);
  }

  const MaterialPalette& palette_;
  const PlacementReader placement_;
  WorldAssembly& assembly_;
  std::map<std::string, std::vector<YamlReader>> groups_;
};

}  // namespace

void AddPiece(YamlReader& reader, const std::string& kind, FurnitureRequest request,
              const MaterialPalette& palette, const PiecePlace& place, WorldAssembly& assembly) {
  std::string name = assembly.FreeName(place.prefix + kind);
  if (reader.Has("name")) name = place.prefix + reader.Require<std::string>("name");
  request.seed = SeedOf(name);
  reader.Read("seed", request.seed);
  YamlReader materials = reader.Group("materials");
  for (const auto& [part, usual] : FindFurnitureKind(kind).materials) {
    request.materials[part] = palette.Read(materials, part, usual);
  }
  materials.Finish();
  reader.Finish();
  Located(reader, [&] {
    assembly.Add(name, MakeFurniture(kind, request), place.T_world_object, place.walk);
  });
}

void ReadFurniture(YamlReader& file, const MaterialPalette& palette, const Building& building,
                   WorldAssembly& assembly) {
  FurnitureReader furniture(file, palette, building, assembly);
  for (const YamlReader& entry : file.Entries("furniture")) furniture.Add(entry);
}

}  // namespace semantic_slam
