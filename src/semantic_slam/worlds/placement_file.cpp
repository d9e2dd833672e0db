#include "semantic_slam/worlds/placement_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "semantic_slam/worlds/located_error.h"

namespace semantic_slam {
namespace {

constexpr double kFarthestM = 1000.0;
constexpr double kGapToWallM = 0.02;  // skirting boards are 12 mm thick

Rigid3d Upright(const Eigen::Vector2d& at_m, double z_m, double yaw_deg) {
  Rigid3d T = Rigid3d(Eigen::Translation3d(at_m.x(), at_m.y(), z_m));
  T.rotate(Eigen::AngleAxisd(yaw_deg * M_PI / 180.0, Eigen::Vector3d::UnitZ()));
  return T;
}

// nullopt if the key is absent.
std::optional<double> ReadFinite(YamlReader& reader, const std::string& key) {
  double value = 0.0;
  reader.Read(key, value);
  if (!reader.Has(key)) return std::nullopt;
  if (!(std::abs(value) <= kFarthestM)) reader.Refuse(key, "a number within 1000");
  return value;
}

}  // namespace

// What an entry says of a place, whatever it is relative to.
struct PlacementReader::Place {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
  double yaw_deg = 0.0;
  std::optional<double> z_m;

  Rigid3d Pose() const { return Upright(at_m, z_m.value_or(0.0), yaw_deg); }
};

Eigen::Vector2d ReadPlace(YamlReader& reader, const std::string& key) {
  const auto numbers = reader.Require<std::vector<double>>(key);
  const bool usable = std::all_of(numbers.begin(), numbers.end(),
                                  [](double value) { return std::abs(value) <= kFarthestM; });
  if (numbers.size() != 2 || !usable) reader.Refuse(key, "[x, y] within 1 km");
  return {numbers[0], numbers[1]};
}

const WorldObject& PlacementReader::Named(YamlReader& reader, const std::string& key,
                                          const std::string& prefix) const {
  const auto name = reader.Require<std::string>(key);
  const WorldObject* object = assembly_.Find(prefix + name);
  if (object == nullptr) object = assembly_.Find(name);
  if (object == nullptr) reader.Refuse(key, "the name of a thing that the file has before");
  return *object;
}

Rigid3d PlacementReader::AtWall(YamlReader& reader, const Placeable& piece,
                                const Place& place) const {
  const auto wall = reader.Require<std::string>("wall");
  const std::size_t slash = wall.rfind('/');
  if (slash == std::string::npos) reader.Refuse("wall", "a room and a side: kitchen/north");
  const auto along_m = reader.Require<double>("along_m");
  const Rigid3d T_world_wall = Located(reader, [&] {
    return building_.WallPose(building_.FindRoom(wall.substr(0, slash)),
                              SideNamed(wall.substr(slash + 1)), along_m);
  });
  const double usual_gap_m = piece.mount == Mount::kWall ? 0.0 : kGapToWallM;
  const double gap_m = ReadFinite(reader, "gap_m").value_or(usual_gap_m);
  const double back_m = piece.mount == Mount::kWall ? 0.0 : 0.5 * piece.size_m.x();
  return T_world_wall * Eigen::Translation3d(gap_m + back_m, 0, 0) * place.Pose();
}

Rigid3d PlacementReader::OnTop(YamlReader& reader, const Place& place,
                               const std::string& prefix) const {
  const WorldObject& support = Named(reader, "on", prefix);
  Place raised = place;
  if (!raised.z_m) raised.z_m = TopAt(support, place.at_m);
  if (!raised.z_m) reader.Refuse("on", "something that has a surface at this place");
  return support.T_world_object * raised.Pose();
}

double PlacementReader::CeilingHeight(const YamlReader& reader, const Eigen::Vector2d& at_m) const {
  const Room* room = building_.RoomAt(at_m);
  if (room == nullptr) reader.Complain("hangs from a ceiling, so it must be in a room");
  return room->height_m;
}

Rigid3d PlacementReader::Read(YamlReader& reader, const Placeable& piece, const std::string& prefix,
                              const Rigid3d& T_world_frame) const {
  Place place;
  const bool stands_alone = !reader.Has("wall") && !reader.Has("on");
  if (stands_alone || reader.Has("at")) place.at_m = ReadPlace(reader, "at");
  place.yaw_deg = ReadFinite(reader, "yaw_deg").value_or(0.0);
  place.z_m = ReadFinite(reader, "z_m");
  if (reader.Has("wall")) return AtWall(reader, piece, place);
  if (reader.Has("on")) return OnTop(reader, place, prefix);
  Rigid3d T = T_world_frame * place.Pose();
  if (reader.Has("beside")) {
    T = Named(reader, "beside", prefix).T_world_object;
    T.translation().z() = 0.0;
    T = T * place.Pose();
  }
  if (piece.mount == Mount::kCeiling && !place.z_m) {
    T.translation().z() = CeilingHeight(reader, T.translation().head<2>()) - piece.size_m.z();
  }
  return T;
}

}  // namespace semantic_slam
