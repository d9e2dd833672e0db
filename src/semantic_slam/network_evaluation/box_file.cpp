#include "semantic_slam/network_evaluation/box_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <optional>
#include <sstream>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

// The numbers of a line; nullopt if there is anything else in it.
std::optional<std::vector<double>> ParseNumbers(const std::string& line) {
  std::istringstream stream(line);
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number = 0.0; stream >> number;) {
    if (!std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
  }
  if (!stream.eof()) return std::nullopt;
  return numbers;
}

// In shares of the image: left, top and right, bottom.
cv::Rect2d BoundingBox(const std::vector<double>& numbers) {
  if (numbers.size() < 7) {
    return {numbers[1] - 0.5 * numbers[3], numbers[2] - 0.5 * numbers[4], numbers[3], numbers[4]};
  }
  cv::Point2d low(numbers[1], numbers[2]);
  cv::Point2d high = low;
  for (std::size_t i = 3; i < numbers.size(); i += 2) {
    low = {std::min(low.x, numbers[i]), std::min(low.y, numbers[i + 1])};
    high = {std::max(high.x, numbers[i]), std::max(high.y, numbers[i + 1])};
  }
  return {low, high};
}

std::optional<FileBox> ParseLine(const std::string& line, cv::Size image) {
  const auto numbers = ParseNumbers(line);
  if (!numbers || numbers->size() < 5) return std::nullopt;
  const bool tells_share = numbers->size() == 6;
  if (numbers->size() % 2 == 0 && !tells_share) return std::nullopt;
  const double number = numbers->front();
  if (number != std::floor(number) || std::abs(number) > 1e6) return std::nullopt;
  const cv::Rect2d shares = BoundingBox(*numbers);
  const auto cut = [](double share) { return std::clamp(share, 0.0, 1.0); };
  const cv::Point2d low(cut(shares.x) * image.width - 0.5, cut(shares.y) * image.height - 0.5);
  const cv::Point2d high(cut(shares.x + shares.width) * image.width - 0.5,
                         cut(shares.y + shares.height) * image.height - 0.5);
  return FileBox{static_cast<int>(number), cv::Rect2f(cv::Point2f(low), cv::Point2f(high)),
                 tells_share ? numbers->back() : 1.0};
}

}  // namespace

std::vector<FileBox> ReadBoxFile(const std::string& path, cv::Size image) {
  std::ifstream file(path);
  std::vector<FileBox> boxes;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto box = ParseLine(line, image);
    if (!box) {
      throw InputError(path + ":" + std::to_string(number) +
                       ": expected class, cx, cy, width, height, or class and a polygon");
    }
    boxes.push_back(*box);
  }
  return boxes;
}

}  // namespace semantic_slam
