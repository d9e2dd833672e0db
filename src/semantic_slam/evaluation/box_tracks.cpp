#include "semantic_slam/evaluation/box_tracks.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <optional>
#include <sstream>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr int kLeastCommas = 6;
constexpr int kMaxFrame = 1000000;  // nine hours; a greater number is none of a frame

bool IsUsable(const BoxInFrame& box) {
  return box.frame >= 1 && box.frame <= kMaxFrame && std::isfinite(box.box.x) &&
         std::isfinite(box.box.y) && std::isfinite(box.box.width) &&
         std::isfinite(box.box.height) && box.box.width >= 0.0 && box.box.height >= 0.0 &&
         std::isfinite(box.confidence);
}

std::optional<BoxInFrame> ParseLine(std::string line) {
  if (std::count(line.begin(), line.end(), ',') < kLeastCommas) return std::nullopt;
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream stream(line);
  stream.imbue(std::locale::classic());
  BoxInFrame box;
  stream >> box.frame >> box.id >> box.box.x >> box.box.y >> box.box.width >> box.box.height >>
      box.confidence;
  if (!stream || !IsUsable(box)) return std::nullopt;
  return box;
}

}  // namespace

std::vector<BoxInFrame> ReadBoxTracks(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot open " + path);
  std::vector<BoxInFrame> boxes;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto box = ParseLine(line);
    if (!box) {
      throw InputError(path + ":" + std::to_string(number) +
                       ": expected frame,id,left,top,width,height,confidence");
    }
    boxes.push_back(*box);
  }
  if (file.bad() || (number == 0 && !file.eof())) throw InputError("cannot read " + path);
  std::stable_sort(boxes.begin(), boxes.end(),
                   [](const BoxInFrame& a, const BoxInFrame& b) { return a.frame < b.frame; });
  return boxes;
}

void WriteBoxTracks(const std::string& path, const std::vector<BoxInFrame>& boxes) {
  WriteFileAtomically(path, [&](std::ostream& out) {
    out.imbue(std::locale::classic());
    out.setf(std::ios::fixed);
    out.precision(2);
    for (const BoxInFrame& box : boxes) {
      out << box.frame << ',' << box.id << ',' << box.box.x << ',' << box.box.y << ','
          << box.box.width << ',' << box.box.height << ',' << box.confidence << ",-1,-1,-1\n";
    }
  });
}

}  // namespace semantic_slam
