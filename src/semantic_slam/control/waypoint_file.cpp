#include "semantic_slam/control/waypoint_file.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <Eigen/Geometry>

#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/waypoint_follower.h"

namespace semantic_slam {
namespace {

constexpr double kMaxHoldS = 3600.0;
constexpr double kMinSpeedMps = 0.01;
constexpr double kMaxSpeedMps = 20.0;

// The number under `key`, in [low, high]; NaN is outside.
double ReadNumber(YamlReader& reader, const char* key, double low, double high) {
  const double value = reader.Require<double>(key);
  if (!(value >= low && value <= high)) {
    std::ostringstream range;
    range << "in [" << low << ", " << high << "]";
    reader.Refuse(key, range.str());
  }
  return value;
}

Eigen::Vector3d ReadPosition(YamlReader& reader) {
  const auto values = reader.Require<std::vector<double>>("position_m");
  const bool usable = std::all_of(values.begin(), values.end(), [](double value) {
    return std::abs(value) <= WaypointFollower::kMaxCoordinateM;
  });
  if (values.size() != 3 || !usable) {
    reader.Refuse("position_m", "three numbers within 10 km of the origin");
  }
  return {values[0], values[1], values[2]};
}

Waypoint ReadWaypoint(YamlReader reader) {
  Waypoint waypoint;
  waypoint.position_m = ReadPosition(reader);
  waypoint.yaw_rad = WrappedAngle(ReadNumber(reader, "yaw_deg", -360.0, 360.0) * M_PI / 180.0);
  if (reader.Has("hold_s")) waypoint.hold_s = ReadNumber(reader, "hold_s", 0.0, kMaxHoldS);
  reader.Finish();
  return waypoint;
}

}  // namespace

Tour LoadTour(const std::string& path) {
  YamlReader reader(LoadYamlMap(path), path);
  const auto list = reader.Require<YAML::Node>("waypoints");
  if (!list.IsSequence()) reader.Refuse("waypoints", "a list");
  Tour tour;
  for (const YAML::Node& entry : list) {
    const std::string name = "waypoints/" + std::to_string(tour.waypoints.size());
    if (!entry.IsMap()) {
      throw ConfigError(path + ":" + std::to_string(entry.Mark().line + 1) + ": " + name +
                        " must be a mapping");
    }
    tour.waypoints.push_back(ReadWaypoint(YamlReader(entry, path, name)));
  }
  if (reader.Has("max_speed_mps")) {
    tour.max_speed_mps = ReadNumber(reader, "max_speed_mps", kMinSpeedMps, kMaxSpeedMps);
  }
  reader.Finish();
  return tour;
}

std::vector<Waypoint> RelativeToFirst(const std::vector<Waypoint>& waypoints) {
  std::vector<Waypoint> relative = waypoints;
  for (Waypoint& waypoint : relative) {
    const Waypoint& first = waypoints.front();
    waypoint.position_m = Eigen::AngleAxisd(-first.yaw_rad, Eigen::Vector3d::UnitZ()) *
                          (waypoint.position_m - first.position_m);
    waypoint.yaw_rad = WrappedAngle(waypoint.yaw_rad - first.yaw_rad);
  }
  return relative;
}

}  // namespace semantic_slam
