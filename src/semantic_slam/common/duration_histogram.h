#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <ostream>
#include <string>
#include <vector>

namespace semantic_slam {

// Durations of one stage, kept in logarithmic buckets 2 % wide from 1 us to over an hour, so that a
// day of frames takes no more memory than a minute of them. Not thread-safe.
class DurationHistogram {
 public:
  void Add(double milliseconds);

  std::int64_t count() const { return count_; }
  double mean_ms() const { return count_ == 0 ? 0.0 : sum_ms_ / static_cast<double>(count_); }

  // The duration that a share `q` in [0, 1] of all does not exceed, to 1 %; 0 if there are none.
  double QuantileMs(double q) const;

 private:
  static constexpr int kBuckets = 1120;
  std::array<std::int64_t, kBuckets> buckets_{};
  std::int64_t count_ = 0;
  double sum_ms_ = 0.0;
};

// One line of timing.csv.
struct StageTiming {
  std::string stage;
  std::int64_t count = 0;
  double median_ms = 0.0;
  double p95_ms = 0.0;
};

// Histograms by stage name. Thread-safe.
class StageTimer {
 public:
  // Times from its construction to its destruction, wall clock.
  class Scope {
   public:
    Scope(StageTimer& timer, const char* stage);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    StageTimer& timer_;
    const char* const stage_;
    const std::chrono::steady_clock::time_point start_;
  };

  void Add(const std::string& stage, double milliseconds);

  // By stage name.
  std::vector<StageTiming> Timings() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, DurationHistogram> histograms_;  // guarded by mutex_
};

// Writes the header "stage,count,median_ms,p95_ms" and a line per stage.
void WriteTimingCsv(const std::vector<StageTiming>& timings, std::ostream& out);

}  // namespace semantic_slam
