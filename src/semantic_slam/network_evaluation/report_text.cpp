#include "semantic_slam/network_evaluation/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace semantic_slam {
namespace {

constexpr std::size_t kNameWidth = 24;
constexpr std::size_t kCellWidth = 11;

}  // namespace

std::string NumberText(double value, int decimals) {
  if (std::isnan(value)) return "-";
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string PercentText(double share) {
  return std::isnan(share) ? "-" : NumberText(100.0 * share, 1) + " %";
}

void PrintTableRow(const std::string& name, const std::vector<std::string>& cells,
                   std::ostream& out) {
  out << name << std::string(kNameWidth - std::min(kNameWidth, name.size()), ' ');
  for (const std::string& cell : cells) {
    out << ' ' << std::string(kCellWidth - std::min(kCellWidth, cell.size()), ' ') << cell;
  }
  out << '\n';
}

}  // namespace semantic_slam
