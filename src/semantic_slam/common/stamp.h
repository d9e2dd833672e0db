#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace semantic_slam {

// A point in time: whole nanoseconds since the epoch, as ROS counts. Messages, frames and poses are
// joined by exact stamp, so a stamp never passes through a floating-point number on its way.
struct Stamp {
  std::int64_t ns = 0;

  static Stamp FromSeconds(double seconds);

  // Reads "1305031453.359684" exactly, up to nine decimals. nullopt if the text is anything else.
  static std::optional<Stamp> Parse(std::string_view text);

  double seconds() const { return static_cast<double>(ns) * 1e-9; }

  friend bool operator==(Stamp a, Stamp b) { return a.ns == b.ns; }
  friend bool operator!=(Stamp a, Stamp b) { return a.ns != b.ns; }
  friend bool operator<(Stamp a, Stamp b) { return a.ns < b.ns; }
  friend bool operator>(Stamp a, Stamp b) { return a.ns > b.ns; }
  friend bool operator<=(Stamp a, Stamp b) { return a.ns <= b.ns; }
  friend bool operator>=(Stamp a, Stamp b) { return a.ns >= b.ns; }
};

// Seconds from `start` to `end`; negative if `end` is earlier.
inline double SecondsBetween(Stamp start, Stamp end) {
  return static_cast<double>(end.ns - start.ns) * 1e-9;
}

// Seconds with six decimals, as TUM files have them, or nine where six would lose something.
std::string ToString(Stamp stamp);

}  // namespace semantic_slam
