#include "semantic_slam/semantic_grid/semantic_grid_file.h"

#include <filesystem>
#include <iomanip>
#include <ostream>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/semantic_grid/semantic_costs.h"
#include "semantic_slam/semantic_grid/semantic_grid_picture.h"

namespace semantic_slam {
namespace {

constexpr char kPictureName[] = "semantic_grid.png";
constexpr char kCostName[] = "semantic_grid.pgm";
constexpr char kYamlName[] = "semantic_grid.yaml";

// The first row of the image is the one with the largest y.
void WriteCost(const SemanticCells& cells, std::ostream& out) {
  out << "P5\n" << cells.width << ' ' << cells.height << "\n255\n";
  for (int y = cells.height - 1; y >= 0; --y) {
    const std::uint8_t* row = cells.cost.data() + static_cast<std::size_t>(y) * cells.width;
    for (int x = 0; x < cells.width; ++x) out.put(static_cast<char>(ToOccupancyPercent(row[x])));
  }
}

void WriteYaml(const SemanticCells& cells, std::ostream& out) {
  out << std::fixed << std::setprecision(6) << "image: " << kCostName << '\n'
      << "resolution: " << cells.resolution_m << '\n'
      << "origin: [" << cells.origin_m.x() << ", " << cells.origin_m.y() << ", 0.000000]\n"
      << "mode: raw\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

}  // namespace

void WriteSemanticGrid(const std::string& folder, const SemanticCells& cells,
                       const OccupancyMap& map, const ObjectMap& objects,
                       const LabelVocabulary& vocabulary) {
  if (cells.cost.empty()) throw InputError("the grid is still empty, so there is nothing to write");
  const std::filesystem::path path(folder);
  const cv::Mat picture = DrawSemanticGrid(cells, map, objects, vocabulary);
  WriteFileAtomicallyVia(path / kPictureName, [&](const std::string& temporary) {
    return cv::imwrite(temporary, picture);
  });
  WriteFileAtomically(path / kCostName, [&](std::ostream& out) { WriteCost(cells, out); });
  WriteFileAtomically(path / kYamlName, [&](std::ostream& out) { WriteYaml(cells, out); });
}

}  // namespace semantic_slam
