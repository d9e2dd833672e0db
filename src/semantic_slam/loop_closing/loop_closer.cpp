#include "semantic_slam/loop_closing/loop_closer.h"

#include <set>
#include <utility>

namespace semantic_slam {

LoopCloser::LoopCloser(const LoopCloserOptions& options,
                       std::shared_ptr<const CameraModel> camera, Map& map, PlaceIndex& index,
                       std::mutex& poses_mutex)
    : options_(Validated(options.loop_closing)),
      camera_(std::move(camera)),
      map_(map),
      index_(index),
      poses_mutex_(poses_mutex),
      detector_(options.detection, index, map),
      corrector_(options.correction, map),
      adjuster_(options.full_adjustment, map) {}

bool LoopCloser::Process(KeyframeId keyframe, StageTimer& timer) {
  std::optional<Loop> loop;
  {
    StageTimer::Scope scope(timer, "loop_closing.detect");
    loop = Detect(keyframe);
    Remember(keyframe);
  }
  if (!loop) return false;
  StageTimer::Scope scope(timer, "loop_closing.correct");
  std::lock_guard<std::mutex> lock(poses_mutex_);
  if (!corrector_.Correct(*loop, *camera_)) return false;
  last_closed_ = keyframe;
  ++loops_;
  return true;
}

// After a loop was closed its keyframes are connected; the next ones would only close it again.
std::optional<Loop> LoopCloser::Detect(KeyframeId keyframe) const {
  if (!options_.enabled) return std::nullopt;
  const bool too_soon =
      last_closed_ != kNoKeyframe && keyframe < last_closed_ + options_.min_gap_keyframes;
  return too_soon ? std::nullopt : detector_.Detect(keyframe, *camera_);
}

void LoopCloser::AdjustAll(StageTimer& timer) {
  StageTimer::Scope scope(timer, "loop_closing.full_adjustment");
  const std::size_t loops = loops_;
  FullAdjuster::Work work = adjuster_.Copy();
  adjuster_.Solve(work, *camera_);
  std::lock_guard<std::mutex> lock(poses_mutex_);
  if (loops_ == loops) adjuster_.Apply(work);
}

void LoopCloser::Reset(std::shared_ptr<const CameraModel> camera) {
  camera_ = std::move(camera);
  index_.Clear();
  last_closed_ = kNoKeyframe;
}

void LoopCloser::KnowMap() {
  index_.Clear();
  last_closed_ = kNoKeyframe;
  std::lock_guard<std::mutex> lock(map_.mutex());
  for (const auto& [id, keyframe] : map_.keyframes()) index_.Add(id, keyframe->features);
}

// Puts the keyframe into the index, and takes those out that have been culled.
void LoopCloser::Remember(KeyframeId id) {
  std::shared_ptr<const FrameFeatures> features;
  std::set<KeyframeId> gone = index_.Keyframes();
  {
    std::lock_guard<std::mutex> lock(map_.mutex());
    if (const Keyframe* keyframe = map_.FindKeyframe(id)) features = keyframe->features;
    for (const auto& entry : map_.keyframes()) gone.erase(entry.first);
  }
  if (features != nullptr) index_.Add(id, std::move(features));
  for (const KeyframeId culled : gone) index_.Remove(culled);
}

}  // namespace semantic_slam
