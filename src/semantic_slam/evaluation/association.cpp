#include "semantic_slam/evaluation/association.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <tuple>

#include "semantic_slam/common/options.h"

namespace semantic_slam {
namespace {

struct Candidate {
  double dt_s;  // absolute
  std::size_t reference;
  std::size_t estimate;

  friend bool operator<(const Candidate& a, const Candidate& b) {
    return std::tie(a.dt_s, a.reference, a.estimate) < std::tie(b.dt_s, b.reference, b.estimate);
  }
};

std::vector<double> StampsInSeconds(const Trajectory& trajectory, double offset_s) {
  std::vector<double> seconds;
  seconds.reserve(trajectory.size());
  for (const StampedPose& stamped : trajectory) {
    seconds.push_back(RoundedSeconds(stamped.stamp) + offset_s);
  }
  return seconds;
}

// All pairs at most max_dt_s apart, nearest first.
std::vector<Candidate> SortedCandidates(const std::vector<double>& reference_s,
                                        const std::vector<double>& estimate_s, double max_dt_s) {
  std::vector<Candidate> candidates;
  for (std::size_t j = 0; j < estimate_s.size(); ++j) {
    const double t_s = estimate_s[j];
    const auto begin = std::lower_bound(reference_s.begin(), reference_s.end(), t_s - max_dt_s);
    const auto end = std::upper_bound(begin, reference_s.end(), t_s + max_dt_s);
    for (auto it = begin; it != end; ++it) {
      const auto i = static_cast<std::size_t>(it - reference_s.begin());
      candidates.push_back({std::abs(*it - t_s), i, j});
    }
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

}  // namespace

double RoundedSeconds(Stamp stamp) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53;  // a double holds integers up to here
  if (std::abs(stamp.ns) <= kExact) return static_cast<double>(stamp.ns) / 1e9;
  // The quotient below is rounded too, by 2^-54 at most. That cannot tip the sum: a multiple of
  // 1e-9 lies in the middle of two doubles of this size or, as 5^9 < 2^21, 2^-51 or more beside it.
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  const std::int64_t seconds = stamp.ns / kNsPerSecond;
  return static_cast<double>(seconds) + static_cast<double>(stamp.ns % kNsPerSecond) / 1e9;
}

std::vector<MatchedPose> AssociateTrajectories(const Trajectory& reference,
                                               const Trajectory& estimate,
                                               const AssociationOptions& options) {
  Validate(options);
  constexpr std::size_t kFree = static_cast<std::size_t>(-1);
  std::vector<std::size_t> reference_of(estimate.size(), kFree);
  std::vector<bool> is_taken(reference.size(), false);
  for (const Candidate& candidate :
       SortedCandidates(StampsInSeconds(reference, 0.0),
                        StampsInSeconds(estimate, options.offset_s), options.max_dt_s)) {
    if (is_taken[candidate.reference] || reference_of[candidate.estimate] != kFree) continue;
    is_taken[candidate.reference] = true;
    reference_of[candidate.estimate] = candidate.reference;
  }
  std::vector<MatchedPose> matches;
  for (std::size_t j = 0; j < estimate.size(); ++j) {
    if (reference_of[j] == kFree) continue;
    matches.push_back({estimate[j].stamp, reference[reference_of[j]].pose, estimate[j].pose});
  }
  return matches;
}

}  // namespace semantic_slam
