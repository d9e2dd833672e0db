#include "semantic_slam/dataset/carmen_log.h"

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr char kTag[] = "FLASER";
constexpr int kMaxReadings = 10000;  // per line; more is a broken line, not a scanner

// What follows the tag; nullopt if it is malformed.
std::optional<LaserReading> ParseReading(std::istringstream& line) {
  int count = 0;
  if (!(line >> count) || count < 1 || count > kMaxReadings) return std::nullopt;
  LaserReading reading;
  reading.ranges_m.resize(static_cast<std::size_t>(count));
  for (float& range_m : reading.ranges_m) line >> range_m;
  std::array<double, 6> poses{};  // of the laser, by whoever wrote the log; and by odometry
  for (double& value : poses) {
    line >> value;
    if (!std::isfinite(value)) return std::nullopt;
  }
  reading.T_odom_robot = MakeRigid2d({poses[3], poses[4]}, poses[5]);
  std::string stamp_text;
  if (!(line >> stamp_text)) return std::nullopt;
  const auto stamp = Stamp::Parse(stamp_text);
  if (!stamp) return std::nullopt;
  reading.stamp = *stamp;
  return reading;
}

}  // namespace

std::vector<LaserReading> ReadCarmenLog(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot open " + path);
  std::vector<LaserReading> readings;
  std::string text;
  for (int number = 1; std::getline(file, text); ++number) {
    std::istringstream line(text);
    std::string tag;
    if (!(line >> tag) || tag != kTag) continue;
    const auto reading = ParseReading(line);
    if (!reading) {
      throw InputError(path + ":" + std::to_string(number) +
                       ": expected 'FLASER count range... x y theta odom_x odom_y odom_theta "
                       "stamp'");
    }
    readings.push_back(*reading);
  }
  if (file.bad()) throw InputError("cannot read " + path + "; is it a file?");
  if (readings.empty()) throw InputError(path + " has no FLASER line; is it a CARMEN log?");
  return readings;
}

}  // namespace semantic_slam
