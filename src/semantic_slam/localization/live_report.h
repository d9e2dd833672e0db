#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// A pose that comes later after its image is of no use to who flies by it: one image's time at 30
// Hz.
constexpr double kLatestPoseMs = 33.0;

// How long after its image was delivered a pose was published.
struct PoseDelay {
  Stamp stamp;
  double delay_ms = 0.0;
};

// What a run at the sensor's rate was like, beside the poses themselves.
struct LiveFacts {
  std::vector<PoseDelay> delays;  // by image; only of those that have a pose
  double cpu_s = 0.0;             // CPU time of all threads, decoding in it
  double decoding_cpu_s = 0.0;    // of it, that for reading and decoding images
};

// Median and 95 % of the delays, how many poses came in time and how many later than kLatestPoseMs,
// and CPU time for each of `images`, without decoding and of decoding [ms].
nlohmann::ordered_json LiveJson(const LiveFacts& facts, std::size_t images);

// Writes the header "stamp,delay_ms" and a line per pose. Throws InputError naming the file if it
// cannot be written.
void WriteDelays(const std::vector<PoseDelay>& delays, const std::string& path);

}  // namespace semantic_slam
