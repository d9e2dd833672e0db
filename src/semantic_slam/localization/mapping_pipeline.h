#pragma once

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam/local_mapping/local_mapper.h"
#include "semantic_slam/loop_closing/loop_closer.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/place_recognition/place_index.h"

namespace semantic_slam {

enum class MappingMode {
  kInline,    // Track() returns after mapping and loop closing have finished: the same bytes always
  kThreaded,  // they run beside tracking, on threads of their own
};

// What becomes of a keyframe: local mapping, then loop closing, then, if a loop was closed,
// adjustment of the whole map. Inline, or each on a thread of its own. Thread-safe, but for Reset()
// and KnowMap().
class MappingPipeline {
 public:
  // Throws ConfigError if an option is out of range. `map`, `index` and `timer` must outlive it.
  MappingPipeline(const LocalMapperOptions& mapping, const LoopCloserOptions& closing,
                  const std::shared_ptr<const CameraModel>& camera, Map& map, PlaceIndex& index,
                  StageTimer& timer, MappingMode mode);

  // Whether a keyframe would be worked on soon: else the map would lag behind the camera.
  bool HasRoom() const;

  // Works the keyframe off, or has that done. Precondition: HasRoom().
  void Add(KeyframeId keyframe);

  // Waits until everything that was given is worked off.
  void Finish();

  // The map was cleared, and keyframes to come are of `camera`. Precondition: nothing is in work,
  // and nothing is added meanwhile; so for the next.
  void Reset(const std::shared_ptr<const CameraModel>& camera);

  // The map was loaded.
  void KnowMap(const std::shared_ptr<const CameraModel>& camera);

  // Loops closed so far, in all maps.
  std::size_t loops() const { return closer_.loops(); }

 private:
  struct Adjustment {};  // of the whole map is due

  void MapKeyframe(KeyframeId keyframe);
  void CloseLoop(KeyframeId keyframe);
  void WantAdjustment();
  void AdjustAll();
  void FinishOne();

  StageTimer& timer_;
  std::mutex poses_mutex_;  // held by who changes poses of keyframes, for long; before the map's
  LocalMapper mapper_;
  LoopCloser closer_;

  mutable std::mutex pending_mutex_;
  std::condition_variable idle_;
  std::size_t pending_ = 0;  // guarded by pending_mutex_; keyframes that mapping has not finished
  std::size_t unfinished_ = 0;  // guarded by pending_mutex_; these, and what follows of them

  // Last, each after the one it feeds: joined before anything they use goes. Empty: done inline.
  std::unique_ptr<Worker<Adjustment>> adjusting_;
  std::unique_ptr<Worker<KeyframeId>> closing_;
  std::unique_ptr<Worker<KeyframeId>> mapping_;
};

}  // namespace semantic_slam
