#include "semantic_slam/localization/mapping_pipeline.h"

namespace semantic_slam {
namespace {

// One keyframe in work and one waiting: with more the map would lag behind the camera.
constexpr std::size_t kMaxPendingKeyframes = 2;
// Mapping waits when loop closing lags behind by more.
constexpr std::size_t kMaxKeyframesToClose = 64;

}  // namespace

MappingPipeline::MappingPipeline(const LocalMapperOptions& mapping,
                                 const LoopCloserOptions& closing,
                                 const std::shared_ptr<const CameraModel>& camera, Map& map,
                                 PlaceIndex& index, StageTimer& timer, MappingMode mode)
    : timer_(timer),
      mapper_(mapping, camera, map),
      closer_(closing, camera, map, index, poses_mutex_) {
  if (mode == MappingMode::kInline) return;
  adjusting_ = std::make_unique<Worker<Adjustment>>(1, WhenFull::kReject,
                                                    [this](Adjustment) { AdjustAll(); });
  closing_ = std::make_unique<Worker<KeyframeId>>(kMaxKeyframesToClose, WhenFull::kBlock,
                                                  [this](KeyframeId id) { CloseLoop(id); });
  mapping_ = std::make_unique<Worker<KeyframeId>>(kMaxPendingKeyframes, WhenFull::kBlock,
                                                  [this](KeyframeId id) { MapKeyframe(id); });
}

bool MappingPipeline::HasRoom() const {
  std::lock_guard<std::mutex> lock(pending_mutex_);
  return pending_ < kMaxPendingKeyframes;
}

void MappingPipeline::Add(KeyframeId keyframe) {
  {
    std::lock_guard<std::mutex> lock(pending_mutex_);
    ++pending_;
    ++unfinished_;
  }
  if (mapping_ != nullptr) {
    mapping_->Push(keyframe);  // never blocks: there is room
  } else {
    MapKeyframe(keyframe);
  }
}

void MappingPipeline::Finish() {
  std::unique_lock<std::mutex> lock(pending_mutex_);
  idle_.wait(lock, [this] { return unfinished_ == 0; });
}

void MappingPipeline::Reset(const std::shared_ptr<const CameraModel>& camera) {
  mapper_.Reset(camera);
  closer_.Reset(camera);
}

void MappingPipeline::KnowMap(const std::shared_ptr<const CameraModel>& camera) {
  mapper_.Reset(camera);
  closer_.KnowMap();
}

void MappingPipeline::MapKeyframe(KeyframeId keyframe) {
  {
    StageTimer::Scope scope(timer_, "local_mapping");
    std::lock_guard<std::mutex> lock(poses_mutex_);
    mapper_.Process(keyframe, timer_);
  }
  {
    std::lock_guard<std::mutex> lock(pending_mutex_);
    --pending_;
  }
  if (closing_ != nullptr) {
    closing_->Push(keyframe);
  } else {
    CloseLoop(keyframe);
  }
}

void MappingPipeline::CloseLoop(KeyframeId keyframe) {
  if (closer_.Process(keyframe, timer_)) WantAdjustment();
  FinishOne();
}

// One adjustment may wait while another runs; a third would only repeat what the second does.
void MappingPipeline::WantAdjustment() {
  {
    std::lock_guard<std::mutex> lock(pending_mutex_);
    ++unfinished_;
  }
  if (adjusting_ == nullptr) {
    AdjustAll();
  } else if (!adjusting_->Push({})) {
    FinishOne();
  }
}

void MappingPipeline::AdjustAll() {
  closer_.AdjustAll(timer_);
  FinishOne();
}

void MappingPipeline::FinishOne() {
  std::lock_guard<std::mutex> lock(pending_mutex_);
  --unfinished_;
  idle_.notify_all();
}

}  // namespace semantic_slam
