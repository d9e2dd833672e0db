#include "semantic_slam/evaluation/trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr std::array<const char*, 8> kFields = {"stamp", "tx", "ty", "tz", "qx", "qy", "qz", "qw"};
constexpr char kFormat[] = "stamp tx ty tz qx qy qz qw";
constexpr double kMinQuaternionNorm = 1e-6;  // shorter says nothing about a direction
constexpr double kMaxNumber = 1e9;           // nobody means more; squares must not overflow
constexpr std::size_t kMaxQuoted = 60;       // enough of a bad value to recognise it

// Where we are, for messages: "path:line: ".
struct FilePosition {
  const std::string& path;
  int line = 0;

  [[noreturn]] void Throw(const std::string& what) const {
    throw InputError(path + ":" + std::to_string(line) + ": " + what);
  }
};

std::string Quoted(const std::string& text) {
  return text.size() > kMaxQuoted ? text.substr(0, kMaxQuoted) + "..." : text;
}

// A finite number; nullopt for anything else. A decimal point is '.' whatever the locale.
std::optional<double> ParseNumber(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  if (!(stream >> value) || !std::isfinite(value)) return std::nullopt;
  if (stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return value;
}

std::optional<Stamp> ParseStamp(const std::string& text) {
  if (const auto exact = Stamp::Parse(text)) return exact;
  const auto seconds = ParseNumber(text);
  if (!seconds) return std::nullopt;
  // Long double has the 61 bits that nanoseconds since the epoch need.
  const long double nanoseconds = static_cast<long double>(*seconds) * 1e9L;
  constexpr std::int64_t kLimit = std::numeric_limits<std::int64_t>::max() / 2;
  if (std::abs(nanoseconds) > static_cast<long double>(kLimit)) return std::nullopt;
  return Stamp{std::llround(nanoseconds)};
}

std::vector<std::string> Fields(std::string line) {
  line.erase(std::min(line.find('#'), line.size()));
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream stream(line);
  std::vector<std::string> fields;
  for (std::string field; stream >> field;) fields.push_back(field);
  return fields;
}

StampedPose ParsePose(const std::vector<std::string>& fields, const FilePosition& position) {
  if (fields.size() != kFields.size()) {
    position.Throw("found " + std::to_string(fields.size()) +
                   " values, expected 8: " + std::string(kFormat));
  }
  const auto stamp = ParseStamp(fields[0]);
  if (!stamp) position.Throw("stamp = " + Quoted(fields[0]) + ", expected seconds");
  std::array<double, kFields.size()> values{};
  for (std::size_t i = 1; i < kFields.size(); ++i) {
    const auto value = ParseNumber(fields[i]);
    if (!value || std::abs(*value) > kMaxNumber) {
      position.Throw(kFields[i] + (" = " + Quoted(fields[i])) +
                     ", expected a number in [-1e9, 1e9]");
    }
    values[i] = *value;
  }
  const Eigen::Quaterniond q(values[7], values[4], values[5], values[6]);
  if (q.norm() < kMinQuaternionNorm) position.Throw("quaternion of zero length, expected length 1");
  return {*stamp, Eigen::Translation3d(values[1], values[2], values[3]) * q.normalized()};
}

void WritePose(const StampedPose& stamped, std::ostream& out) {
  const Eigen::Vector3d t = stamped.pose.translation();
  Eigen::Quaterniond q(stamped.pose.linear());
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  std::array<char, 1100> text{};  // room for three of the largest doubles
  std::snprintf(text.data(), text.size(), " %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n", t.x(), t.y(),
                t.z(), q.x(), q.y(), q.z(), q.w());
  out << ToString(stamped.stamp) << text.data();
}

}  // namespace

Trajectory ReadTumTrajectory(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot open trajectory " + path);
  Trajectory trajectory;
  FilePosition position{path};
  for (std::string line; std::getline(file, line);) {
    ++position.line;
    const std::vector<std::string> fields = Fields(line);
    if (!fields.empty()) trajectory.push_back(ParsePose(fields, position));
  }
  if (file.bad()) throw InputError("cannot read trajectory " + path);
  if (trajectory.empty()) {
    throw InputError(path + ": no pose in it, expected lines of " + std::string(kFormat));
  }
  std::stable_sort(trajectory.begin(), trajectory.end(),
                   [](const StampedPose& a, const StampedPose& b) { return a.stamp < b.stamp; });
  return trajectory;
}

void WriteTumTrajectory(const Trajectory& trajectory, const std::string& path) {
  WriteFileAtomically(path, [&](std::ostream& out) {
    out << "# " << kFormat << "\n";
    for (const StampedPose& stamped : trajectory) WritePose(stamped, out);
  });
}

}  // namespace semantic_slam
