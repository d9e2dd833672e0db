#include "semantic_slam/common/duration_histogram.h"

#include <algorithm>
#include <cmath>
#include <iomanip>

namespace semantic_slam {
namespace {

constexpr double kSmallestMs = 1e-3;
constexpr double kGrowth = 1.02;

}  // namespace

void DurationHistogram::Add(double milliseconds) {
  const double ratio = std::max(milliseconds, kSmallestMs) / kSmallestMs;
  const int bucket = static_cast<int>(std::log(ratio) / std::log(kGrowth));
  ++buckets_[std::clamp(bucket, 0, kBuckets - 1)];
  ++count_;
  sum_ms_ += milliseconds;
}

double DurationHistogram::QuantileMs(double q) const {
  if (count_ == 0) return 0.0;
  const auto rank = static_cast<std::int64_t>(std::ceil(q * static_cast<double>(count_)));
  std::int64_t seen = 0;
  int bucket = 0;
  for (; bucket < kBuckets - 1; ++bucket) {
    seen += buckets_[bucket];
    if (seen >= std::max<std::int64_t>(rank, 1)) break;
  }
  return kSmallestMs * std::pow(kGrowth, bucket + 0.5);  // the bucket's geometric middle
}

StageTimer::Scope::Scope(StageTimer& timer, const char* stage)
    : timer_(timer), stage_(stage), start_(std::chrono::steady_clock::now()) {}

StageTimer::Scope::~Scope() {
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start_;
  timer_.Add(stage_, elapsed.count());
}

void StageTimer::Add(const std::string& stage, double milliseconds) {
  std::lock_guard<std::mutex> lock(mutex_);
  histograms_[stage].Add(milliseconds);
}

std::vector<StageTiming> StageTimer::Timings() const {
  std::lock_guard<std::mutex> lock(mutex_);
  std::vector<StageTiming> timings;
  for (const auto& [stage, histogram] : histograms_) {
    timings.push_back(
        {stage, histogram.count(), histogram.QuantileMs(0.5), histogram.QuantileMs(0.95)});
  }
  return timings;
}

void WriteTimingCsv(const std::vector<StageTiming>& timings, std::ostream& out) {
  out << "stage,count,median_ms,p95_ms\n" << std::fixed << std::setprecision(3);
  for (const StageTiming& timing : timings) {
    out << timing.stage << ',' << timing.count << ',' << timing.median_ms << ',' << timing.p95_ms
        << '\n';
  }
}

}  // namespace semantic_slam
