#include "tools/mapping_stage.h"

#include <iostream>
#include <utility>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

// Images that may wait for a stage: enough for both cores to have work, few enough for any memory.
std::size_t Capacity(WhenFull when_full) { return when_full == WhenFull::kBlock ? 4 : 1; }

}  // namespace

StageRunner::StageRunner(std::unique_ptr<MappingStage> stage, double period_s, WhenFull when_full)
    : stage_(std::move(stage)),
      // Half a millisecond less: stamps of a sensor jitter, and that must not cost a whole image.
      throttle_(period_s - 0.5e-3),
      worker_(std::make_unique<Worker<Item>>(Capacity(when_full), when_full,
                                             [this](const Item& item) { Process(item); })) {}

void StageRunner::Offer(const RgbdImage& image, const TrackedImage& tracked,
                        std::shared_ptr<const KeyframeGraph> graph) {
  if (tracked.status != TrackingStatus::kTracking || !throttle_.IsDue(tracked.stamp)) return;
  worker_->Push({image, tracked, std::move(graph)});
}

void StageRunner::Finish(const KeyframeGraph& graph) {
  late_ = worker_->dropped();
  worker_.reset();
  stage_->FollowGraph(graph);
}

MappingStage::Counts StageRunner::counts() const {
  MappingStage::Counts counts = stage_->counts();
  counts["images"] = images_;
  if (malformed_ > 0) counts["malformed"] = malformed_;
  if (late_ > 0) counts["late"] = late_;
  return counts;
}

void StageRunner::Process(const Item& item) try {
  if (item.graph != followed_) stage_->FollowGraph(*item.graph);
  followed_ = item.graph;
  stage_->Process(item.image, item.tracked);
  ++images_;
} catch (const InputError& e) {
  ++malformed_;
  std::cerr << stage_->name() << ": dropped image at " << ToString(item.tracked.stamp)
            << " s: " << e.what() << '\n';
}

}  // namespace semantic_slam
