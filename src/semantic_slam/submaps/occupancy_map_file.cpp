#include "semantic_slam/submaps/occupancy_map_file.h"

#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <ostream>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr char kImageName[] = "grid.pgm";
constexpr char kYamlName[] = "grid.yaml";
constexpr int kOccupiedPercent = 65;
constexpr int kFreePercent = 25;

// map_server takes (255 - grey) / 255 for the probability and compares it with the thresholds
// below.
char ToGrey(std::int8_t cell) {
  std::uint8_t grey = 205;
  if (cell >= kOccupiedPercent) {
    grey = 0;
  } else if (cell >= 0 && cell < kFreePercent) {
    grey = 254;
  }
  return static_cast<char>(grey);
}

// The first row of the picture is the one with the largest y.
void WriteImage(const OccupancyMap& map, std::ostream& out) {
  out << "P5\n" << map.width << ' ' << map.height << "\n255\n";
  for (int y = map.height - 1; y >= 0; --y) {
    for (int x = 0; x < map.width; ++x) {
      out.put(ToGrey(map.cells[static_cast<std::size_t>(y) * map.width + x]));
    }
  }
}

void WriteYaml(const OccupancyMap& map, std::ostream& out) {
  out << std::fixed << std::setprecision(6) << "image: " << kImageName << '\n'
      << "resolution: " << map.resolution_m << '\n'
      << "origin: [" << map.origin_m.x() << ", " << map.origin_m.y() << ", 0.000000]\n"
      << "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

}  // namespace

void WriteOccupancyMap(const std::string& folder, const OccupancyMap& map) {
  if (map.cells.empty()) throw InputError("the map is still empty, so there is nothing to write");
  const std::filesystem::path path(folder);
  WriteFileAtomically(path / kImageName, [&](std::ostream& out) { WriteImage(map, out); });
  WriteFileAtomically(path / kYamlName, [&](std::ostream& out) { WriteYaml(map, out); });
}

}  // namespace semantic_slam
