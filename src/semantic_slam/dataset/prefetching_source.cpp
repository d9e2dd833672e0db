#include "semantic_slam/dataset/prefetching_source.h"

#include <cassert>
#include <utility>

#include "semantic_slam/common/cpu_time.h"

namespace semantic_slam {

PrefetchingSource::PrefetchingSource(std::unique_ptr<RgbdSource> source, std::size_t max_ahead)
    : source_(std::move(source)),
      size_(source_->size()),
      problems_(source_->problems()),
      dropped_(source_->dropped()),
      queue_(max_ahead - 1, WhenFull::kBlock),  // one more is in the reader's hand
      thread_([this] { ReadAhead(); }) {
  assert(max_ahead >= 2);
}

PrefetchingSource::~PrefetchingSource() {
  queue_.Close();  // a reader that waits for room gives up
  thread_.join();
}

std::optional<RgbdImage> PrefetchingSource::Next() {
  std::optional<Step> step = queue_.Pop();
  if (!step) return std::nullopt;
  problems_ = std::move(step->problems);
  dropped_ = step->dropped;
  cpu_s_ = step->cpu_s;
  if (step->error) std::rethrow_exception(step->error);
  return std::move(step->image);
}

void PrefetchingSource::ReadAhead() {
  bool goes_on = true;
  while (goes_on) {
    Step step = TakeStep();
    goes_on = step.image.has_value();
    if (!queue_.Push(std::move(step))) return;
  }
  queue_.Close();
}

PrefetchingSource::Step PrefetchingSource::TakeStep() const {
  Step step;
  try {
    step.image = source_->Next();
  } catch (...) {
    step.error = std::current_exception();
  }
  step.problems = source_->problems();
  step.dropped = source_->dropped();
  step.cpu_s = ThreadCpuSeconds();
  return step;
}

}  // namespace semantic_slam
