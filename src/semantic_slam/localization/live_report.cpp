#include "semantic_slam/localization/live_report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "semantic_slam/common/atomic_file.h"

namespace semantic_slam {
namespace {

// The least value that a share `q` in (0, 1] of all does not exceed; 0 if there are none.
double Quantile(const std::vector<double>& ascending, double q) {
  if (ascending.empty()) return 0.0;
  const double rank = std::ceil(q * static_cast<double>(ascending.size()));
  return ascending[static_cast<std::size_t>(rank) - 1];
}

}  // namespace

nlohmann::ordered_json LiveJson(const LiveFacts& facts, std::size_t images) {
  std::vector<double> ascending;
  for (const PoseDelay& pose : facts.delays) ascending.push_back(pose.delay_ms);
  std::sort(ascending.begin(), ascending.end());
  const auto late = std::upper_bound(ascending.begin(), ascending.end(), kLatestPoseMs);
  const double ms_per_image = 1e3 / static_cast<double>(std::max<std::size_t>(images, 1));
  nlohmann::ordered_json json;
  json["in_time"] = late - ascending.begin();
  json["late"] = ascending.end() - late;
  json["latest_ms"] = kLatestPoseMs;
  json["delay_median_ms"] = Quantile(ascending, 0.5);
  json["delay_p95_ms"] = Quantile(ascending, 0.95);
  json["cpu_ms_per_image"] = ms_per_image * (facts.cpu_s - facts.decoding_cpu_s);
  json["decoding_ms_per_image"] = ms_per_image * facts.decoding_cpu_s;
  return json;
}

void WriteDelays(const std::vector<PoseDelay>& delays, const std::string& path) {
  WriteFileAtomically(path, [&](std::ostream& file) {
    file << "stamp,delay_ms\n" << std::fixed << std::setprecision(3);
    for (const PoseDelay& pose : delays)
      file << ToString(pose.stamp) << ',' << pose.delay_ms << '\n';
  });
}

}  // namespace semantic_slam
