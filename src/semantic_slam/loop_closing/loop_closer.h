#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/loop_closing/full_adjuster.h"
#include "semantic_slam/loop_closing/loop_corrector.h"
#include "semantic_slam/loop_closing/loop_detector.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/place_recognition/place_index.h"

namespace semantic_slam {

struct LoopClosingOptions {
  bool enabled = true;
  int min_gap_keyframes = 5;  // after a loop was closed, until another is looked for

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("enabled", self.enabled);
    visit("min_gap_keyframes", self.min_gap_keyframes, 1, 10000);
  }
};

// The options of every part of loop closing, in the groups that configuration files use.
struct LoopCloserOptions {
  LoopClosingOptions loop_closing;
  LoopDetectorOptions detection;
  LoopCorrectorOptions correction;
  FullAdjusterOptions full_adjustment;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("loop_closing", self.loop_closing);
    visit_group("loop_detection", self.detection);
    visit_group("loop_correction", self.correction);
    visit_group("full_adjustment", self.full_adjustment);
  }
};

// Thesis section 3.2.4 from a new keyframe to a corrected map. Process() is for one thread.
class LoopCloser {
 public:
  // Throws ConfigError if an option is out of range. `map`, `index` and `poses_mutex` must outlive it;
  // who changes poses of the map's keyframes holds `poses_mutex`.
  LoopCloser(const LoopCloserOptions& options, std::shared_ptr<const CameraModel> camera, Map& map,
             PlaceIndex& index, std::mutex& poses_mutex);

  // Looks for the place that the keyframe shows among all earlier ones, and closes the loop if there
  // is one. Returns whether. Then AdjustAll() is due.
  bool Process(KeyframeId keyframe, StageTimer& timer);

  // Bundle adjustment of the whole map. The map may be worked on meanwhile; gives up if another loop
  // was closed. From any thread, one at a time.
  void AdjustAll(StageTimer& timer);

  // Forgets what it knows of the map: to be called with Map::Clear().
  void Reset(std::shared_ptr<const CameraModel> camera);

  // Knows the keyframes that the map has now and no others: to be called with Map::Load().
  void KnowMap();

  std::size_t loops() const { return loops_; }

 private:
  std::optional<Loop> Detect(KeyframeId keyframe) const;
  void Remember(KeyframeId keyframe);

  const LoopClosingOptions options_;
  std::shared_ptr<const CameraModel> camera_;
  Map& map_;
  PlaceIndex& index_;
  std::mutex& poses_mutex_;
  const LoopDetector detector_;
  LoopCorrector corrector_;
  FullAdjuster adjuster_;
  std::atomic<std::size_t> loops_{0};
  KeyframeId last_closed_ = kNoKeyframe;
};

}  // namespace semantic_slam
