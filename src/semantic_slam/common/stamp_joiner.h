#pragma once

#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// Joins an image and what was made of it, by exact stamp: `Source` is the image, `Result` what
// comes of some of the images a little later, or, where the image takes another way, a little
// sooner. Both wait for each other, in bounded numbers. Not thread-safe.
//
// When two meet, everything older is forgotten. A stamp over a second older than the newest one of
// its kind belongs to a new recording: everything is forgotten.
template <typename Source, typename Result>
class StampJoiner {
 public:
  struct Joined {
    Source source;
    Result result;
  };

  // Preconditions: at least 1.
  StampJoiner(std::size_t max_sources, std::size_t max_results)
      : max_sources_(max_sources), max_results_(max_results) {}

  std::optional<Joined> AddSource(Stamp stamp, Source source) {
    Insert(stamp, std::move(source), sources_);
    if (auto joined = Join(stamp)) return joined;
    if (sources_.size() > max_sources_) sources_.erase(sources_.begin());
    return std::nullopt;
  }

  std::optional<Joined> AddResult(Stamp stamp, Result result) {
    Insert(stamp, std::move(result), results_);
    if (auto joined = Join(stamp)) return joined;
    if (results_.size() > max_results_) {
      results_.erase(results_.begin());
      ++unjoined_results_;
    }
    return std::nullopt;
  }

  // Results whose image never came, or went too soon.
  std::size_t unjoined_results() const { return unjoined_results_; }

 private:
  static constexpr double kJumpBackS = 1.0;

  template <typename Item>
  void Insert(Stamp stamp, Item item, std::map<Stamp, Item>& items) {
    if (!items.empty() && SecondsBetween(stamp, items.rbegin()->first) > kJumpBackS) {
      unjoined_results_ += results_.size();
      sources_.clear();
      results_.clear();
    }
    items.insert_or_assign(stamp, std::move(item));
  }

  std::optional<Joined> Join(Stamp stamp) {
    const auto source = sources_.find(stamp);
    const auto result = results_.find(stamp);
    if (source == sources_.end() || result == results_.end()) return std::nullopt;
    Joined joined{std::move(source->second), std::move(result->second)};
    unjoined_results_ += static_cast<std::size_t>(std::distance(results_.begin(), result));
    sources_.erase(sources_.begin(), std::next(source));
    results_.erase(results_.begin(), std::next(result));
    return joined;
  }

  const std::size_t max_sources_;
  const std::size_t max_results_;
  std::map<Stamp, Source> sources_;
  std::map<Stamp, Result> results_;
  std::size_t unjoined_results_ = 0;
};

}  // namespace semantic_slam
