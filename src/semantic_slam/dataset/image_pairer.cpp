#include "semantic_slam/dataset/image_pairer.h"

#include <cstdlib>

namespace semantic_slam {
namespace {

struct Candidate {
  std::int64_t gap_ns;
  std::size_t colour;
  std::size_t depth;
};

// All candidates within the gap, nearest first.
std::vector<Candidate> Candidates(const std::vector<Stamp>& colour, const std::vector<Stamp>& depth,
                                  std::int64_t max_gap_ns) {
  std::vector<Candidate> candidates;
  for (std::size_t c = 0; c < colour.size(); ++c) {
    const Stamp first{colour[c].ns - max_gap_ns};
    auto d = std::lower_bound(depth.begin(), depth.end(), first);
    for (; d != depth.end() && d->ns - colour[c].ns <= max_gap_ns; ++d) {
      candidates.push_back(
          {std::abs(d->ns - colour[c].ns), c, static_cast<std::size_t>(d - depth.begin())});
    }
  }
  // Stable: candidates of equal gap stay in order of colour, then depth.
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gap_ns < b.gap_ns; });
  return candidates;
}

// How near to `stamp` an image at `next` or later can be.
std::int64_t NearestToComeNs(Stamp stamp, Stamp next) {
  return std::max<std::int64_t>(next.ns - stamp.ns, 0);
}

// kOpen: free so far, but an image still to come may take it.
enum class State { kFree, kOpen, kTaken };

}  // namespace

namespace internal {

std::vector<ColourFate> DecideFates(const std::vector<Stamp>& colour,
                                    const std::vector<Stamp>& depth, std::int64_t max_gap_ns,
                                    Stamp next_colour, Stamp next_depth) {
  std::vector<State> colours(colour.size(), State::kFree);
  std::vector<State> depths(depth.size(), State::kFree);
  std::vector<ColourFate> fates(colour.size(), {ColourFate::kUnpaired, 0});
  for (const auto& [gap_ns, c, d] : Candidates(colour, depth, max_gap_ns)) {
    if (colours[c] == State::kTaken || depths[d] == State::kTaken) continue;
    const bool may_be_beaten = NearestToComeNs(colour[c], next_depth) < gap_ns ||
                               NearestToComeNs(depth[d], next_colour) < gap_ns;
    if (may_be_beaten || colours[c] == State::kOpen || depths[d] == State::kOpen) {
      colours[c] = depths[d] = State::kOpen;
    } else {
      colours[c] = depths[d] = State::kTaken;
      fates[c] = {ColourFate::kPaired, d};
    }
  }
  for (std::size_t c = 0; c < colour.size(); ++c) {
    if (colours[c] == State::kTaken) continue;
    const bool may_still_pair = NearestToComeNs(colour[c], next_depth) <= max_gap_ns;
    if (may_still_pair || colours[c] == State::kOpen) fates[c] = {ColourFate::kOpen, 0};
  }
  return fates;
}

}  // namespace internal

std::vector<PairIndices> PairStamps(const std::vector<Stamp>& colour,
                                    const std::vector<Stamp>& depth, double max_gap_s) {
  using internal::kEndOfTime;  // nothing is still to come
  const auto fates = internal::DecideFates(colour, depth, internal::Nanoseconds(max_gap_s),
                                           kEndOfTime, kEndOfTime);
  std::vector<PairIndices> pairs;
  for (std::size_t c = 0; c < fates.size(); ++c) {
    if (fates[c].kind == internal::ColourFate::kPaired) pairs.push_back({c, fates[c].depth});
  }
  return pairs;
}

}  // namespace semantic_slam
