#include "semantic_slam/submaps/occupancy_map_file.h"

#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <ostream>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/check.h"
#include "semantic_slam/common/yaml_options.h"

namespace semantic_slam {
namespace {

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

void WriteYaml(const OccupancyMap& map, const std::string& image, std::ostream& out) {
  out << std::fixed << std::setprecision(6) << "image: " << image << '\n'
      << "resolution: " << map.resolution_m << '\n'
      << "origin: [" << map.origin_m.x() << ", " << map.origin_m.y() << ", 0.000000]\n"
      << "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

// What a map_server's file says besides where its picture is.
struct MapFile {
  std::string image;
  double resolution_m = 0.0;
  std::vector<double> origin;  // x, y, yaw
  std::string mode = "trinary";
  int negate = 0;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
};

MapFile ReadYaml(const std::string& path) {
  YamlReader reader(LoadYamlMap(path), path);
  MapFile file;
  file.image = reader.Require<std::string>("image");
  file.resolution_m = reader.Require<double>("resolution");
  file.origin = reader.Require<std::vector<double>>("origin");
  reader.Read("mode", file.mode);
  reader.Read("negate", file.negate);
  reader.Read("occupied_thresh", file.occupied_threshold);
  reader.Read("free_thresh", file.free_threshold);
  CheckInRange(path + ": resolution", file.resolution_m, 1e-3, 100.0);
  if (file.origin.size() < 2) reader.Refuse("origin", "[x, y, yaw]");
  if (file.mode != "trinary" && file.mode != "raw") reader.Refuse("mode", "trinary or raw");
  return file;
}

std::int8_t FromGrey(std::uint8_t grey, const MapFile& file) {
  if (file.mode == "raw")
    return grey <= 100 ? static_cast<std::int8_t>(grey) : OccupancyMap::kUnknown;
  const double occupied = (file.negate != 0 ? grey : 255 - grey) / 255.0;
  if (occupied > file.occupied_threshold) return 100;
  return occupied < file.free_threshold ? 0 : OccupancyMap::kUnknown;
}

}  // namespace

void WriteOccupancyMap(const std::string& folder, const OccupancyMap& map,
                       const std::string& name) {
  if (map.cells.empty()) throw InputError("the map is still empty, so there is nothing to write");
  const std::filesystem::path path(folder);
  const std::string image = name + ".pgm";
  WriteFileAtomically(path / image, [&](std::ostream& out) { WriteImage(map, out); });
  WriteFileAtomically(path / (name + ".yaml"),
                      [&](std::ostream& out) { WriteYaml(map, image, out); });
}

OccupancyMap ReadOccupancyMap(const std::string& yaml_path) try {
  const MapFile file = ReadYaml(yaml_path);
  const std::string image_path = std::filesystem::path(yaml_path).parent_path() / file.image;
  if (!std::filesystem::exists(image_path)) throw InputError("no such picture: " + image_path);
  const cv::Mat image = cv::imread(image_path, cv::IMREAD_GRAYSCALE);
  if (image.empty()) throw InputError("cannot read the picture " + image_path);
  OccupancyMap map;
  map.resolution_m = file.resolution_m;
  map.origin_m = {file.origin[0], file.origin[1]};
  map.width = image.cols;
  map.height = image.rows;
  map.cells.reserve(image.total());
  for (int y = 0; y < map.height; ++y) {
    const auto* row = image.ptr<std::uint8_t>(map.height - 1 - y);
    for (int x = 0; x < map.width; ++x) map.cells.push_back(FromGrey(row[x], file));
  }
  return map;
} catch (const ConfigError& e) {
  throw InputError(e.what());
}

}  // namespace semantic_slam
