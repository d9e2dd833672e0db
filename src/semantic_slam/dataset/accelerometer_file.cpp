#include "semantic_slam/dataset/accelerometer_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "semantic_slam/dataset/text_table.h"

namespace semantic_slam {
namespace {

constexpr char kExpected[] = "stamp ax ay az";

double ParseAcceleration(const std::string& path, const TextRow& row, const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (*end != '\0' || !std::isfinite(value)) ThrowBadRow(path, row, kExpected);
  return value;
}

}  // namespace

std::vector<AccelerometerReading> ReadAccelerometerFile(const std::string& path) {
  std::vector<AccelerometerReading> readings;
  for (const TextRow& row : ReadTextTable(path, 3, kExpected)) {
    AccelerometerReading reading{row.stamp, {}};
    for (int i = 0; i < 3; ++i) {
      reading.acceleration_imu[i] = ParseAcceleration(path, row, row.fields[i]);
    }
    readings.push_back(reading);
  }
  std::stable_sort(readings.begin(), readings.end(),
                   [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
  return readings;
}

}  // namespace semantic_slam
