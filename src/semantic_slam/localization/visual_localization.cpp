#include "semantic_slam/localization/visual_localization.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/map_file.h"

namespace semantic_slam {
namespace {

// One keyframe in work and one waiting: with more the map would lag behind the camera.
constexpr std::size_t kMaxPendingKeyframes = 2;
// Mapping waits when loop closing lags behind by more.
constexpr std::size_t kMaxKeyframesToClose = 64;

struct Adjustment {};  // of the whole map is due

}  // namespace

class VisualLocalization::Implementation {
 public:
  Implementation(const LocalizationOptions& options, std::shared_ptr<const CameraModel> camera,
                 MappingMode mode)
      : camera_(std::move(camera)),
        extractor_(options.features),
        map_(extractor_.scales()),
        mapper_(options.local_mapping, camera_, map_),
        index_(options.place_recognition),
        closer_(options.loop_closer, camera_, map_, index_, poses_mutex_),
        tracker_(options.tracking, options.readout, camera_, map_, index_) {
    if (mode == MappingMode::kThreaded) {
      adjusting_ = std::make_unique<Worker<Adjustment>>(1, WhenFull::kReject,
                                                        [this](Adjustment) { AdjustAll(); });
      closing_ = std::make_unique<Worker<KeyframeId>>(kMaxKeyframesToClose, WhenFull::kBlock,
                                                      [this](KeyframeId id) { CloseLoop(id); });
      mapping_ = std::make_unique<Worker<KeyframeId>>(
          kMaxPendingKeyframes, WhenFull::kBlock, [this](KeyframeId id) { MapKeyframe(id); });
    }
  }

  void SetStart(const Rigid3d& T_map_camera) {
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    tracker_.SetStart(T_map_camera);
  }

  TrackedImage Track(const RgbdImage& image) {
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    StageTimer::Scope whole(timer_, "tracking");
    if (last_stamp_ && image.stamp <= *last_stamp_) {
      throw InputError("image at " + ToString(image.stamp) + " s is not later than the one before at " +
                       ToString(*last_stamp_) + " s");
    }
    std::shared_ptr<const FrameFeatures> features;
    {
      StageTimer::Scope scope(timer_, "tracking.features");
      features = std::make_shared<FrameFeatures>(image, *camera_, extractor_);
    }
    last_stamp_ = image.stamp;
    TrackerResult result;
    {
      StageTimer::Scope scope(timer_, "tracking.pose");
      result = tracker_.Track(features, MappingHasRoom());
    }
    rejected_keyframes_ += result.keyframe_rejected;
    KeepForView(std::move(features), std::move(result.is_inlier));
    if (result.new_keyframe) Hand(*result.new_keyframe);
    return result.image;
  }

  void Reset() {
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    Begin();
  }

  void Reset(std::shared_ptr<const CameraModel> camera) {
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    camera_ = std::move(camera);
    Begin();
  }

  void Restart() {
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    if (!HasMap()) return Begin();
    tracker_.StartLost();
    last_stamp_.reset();
  }

  void SetMapping(bool on) {
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    tracker_.SetMapping(on);
  }

  void SaveMap(const std::string& path) {
    StoredMap stored;
    {
      std::lock_guard<std::mutex> lock(tracking_mutex_);
      Finish();
      std::lock_guard<std::mutex> map_lock(map_.mutex());
      stored = {camera_->intrinsics(), map_.scales(), map_.Contents()};
    }
    WriteMapFile(path, stored);
  }

  void LoadMap(const std::string& path) {
    const StoredMap stored = ReadMapFile(path);
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    CheckMapFits(path, stored, camera_->intrinsics(), map_.scales());
    Finish();
    {
      std::lock_guard<std::mutex> map_lock(map_.mutex());
      map_.Load(stored.contents);
    }
    mapper_.Reset(camera_);
    closer_.KnowMap();
    tracker_.StartLost();
  }

  void Finish() {
    std::unique_lock<std::mutex> lock(pending_mutex_);
    idle_.wait(lock, [this] { return unfinished_ == 0; });
  }

  std::uint64_t revision() const {
    std::lock_guard<std::mutex> lock(map_.mutex());
    return map_.revision();
  }

  KeyframeGraph keyframe_graph() const {
    std::lock_guard<std::mutex> lock(map_.mutex());
    return map_.Graph();
  }

  std::vector<ColouredPoint> map_points() const {
    std::lock_guard<std::mutex> lock(map_.mutex());
    return map_.ColouredPoints();
  }

  std::vector<FeatureView> features() const {
    std::lock_guard<std::mutex> lock(view_mutex_);
    std::vector<FeatureView> views;
    for (std::size_t i = 0; i < is_inlier_.size(); ++i) {
      const Feature& feature = (*viewed_)[i];
      views.push_back({feature.raw, 31.0f * extractor_.scales()[feature.octave], is_inlier_[i]});
    }
    return views;
  }

  std::size_t closed_loops() const { return closer_.loops(); }
  std::size_t rejected_keyframes() const { return rejected_keyframes_; }
  std::vector<StageTiming> timings() const { return timer_.Timings(); }

 private:
  // Begins an empty map of camera_'s images. The caller holds tracking_mutex_, so local mapping gets
  // no work; when it has finished, it may be changed too.
  void Begin() {
    Finish();
    {
      std::lock_guard<std::mutex> lock(map_.mutex());
      map_.Clear();
    }
    tracker_.Reset(camera_);
    mapper_.Reset(camera_);
    closer_.Reset(camera_);
    last_stamp_.reset();
  }

  bool HasMap() const {
    std::lock_guard<std::mutex> lock(map_.mutex());
    return !map_.keyframes().empty();
  }

  bool MappingHasRoom() const {
    std::lock_guard<std::mutex> lock(pending_mutex_);
    return pending_ < kMaxPendingKeyframes;
  }

  void Hand(KeyframeId id) {
    {
      std::lock_guard<std::mutex> lock(pending_mutex_);
      ++pending_;
      ++unfinished_;
    }
    // Never blocks: MappingHasRoom() was asked before.
    if (mapping_ != nullptr) {
      mapping_->Push(id);
    } else {
      MapKeyframe(id);
    }
  }

  void MapKeyframe(KeyframeId id) {
    {
      StageTimer::Scope scope(timer_, "local_mapping");
      std::lock_guard<std::mutex> lock(poses_mutex_);
      mapper_.Process(id, timer_);
    }
    {
      std::lock_guard<std::mutex> lock(pending_mutex_);
      --pending_;
    }
    if (closing_ != nullptr) {
      closing_->Push(id);
    } else {
      CloseLoop(id);
    }
  }

  void CloseLoop(KeyframeId id) {
    if (closer_.Process(id, timer_)) WantAdjustment();
    FinishOne();
  }

  // One adjustment may wait while another runs; a third would only repeat what the second does.
  void WantAdjustment() {
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

  void AdjustAll() {
    closer_.AdjustAll(timer_);
    FinishOne();
  }

  void FinishOne() {
    std::lock_guard<std::mutex> lock(pending_mutex_);
    --unfinished_;
    idle_.notify_all();
  }

  void KeepForView(std::shared_ptr<const FrameFeatures> features, std::vector<bool> is_inlier) {
    std::lock_guard<std::mutex> lock(view_mutex_);
    viewed_ = std::move(features);
    is_inlier_ = std::move(is_inlier);
  }

  std::shared_ptr<const CameraModel> camera_;  // guarded by tracking_mutex_
  const OrbExtractor extractor_;
  StageTimer timer_;
  Map map_;
  std::mutex poses_mutex_;  // held by who changes poses of keyframes, for long; before the map's
  LocalMapper mapper_;
  PlaceIndex index_;
  LoopCloser closer_;
  std::atomic<std::size_t> rejected_keyframes_{0};

  std::mutex tracking_mutex_;        // taken before all others
  Tracker tracker_;                  // guarded by tracking_mutex_
  std::optional<Stamp> last_stamp_;  // guarded by tracking_mutex_

  mutable std::mutex pending_mutex_;
  std::condition_variable idle_;
  std::size_t pending_ = 0;     // guarded by pending_mutex_; keyframes that mapping has not finished
  std::size_t unfinished_ = 0;  // guarded by pending_mutex_; these, and what follows of them

  mutable std::mutex view_mutex_;
  std::shared_ptr<const FrameFeatures> viewed_;  // guarded by view_mutex_
  std::vector<bool> is_inlier_;                  // guarded by view_mutex_

  // Last, each after the one it feeds: joined before anything they use goes. Empty: done inline.
  std::unique_ptr<Worker<Adjustment>> adjusting_;
  std::unique_ptr<Worker<KeyframeId>> closing_;
  std::unique_ptr<Worker<KeyframeId>> mapping_;
};

VisualLocalization::VisualLocalization(const LocalizationOptions& options,
                                       std::shared_ptr<const CameraModel> camera, MappingMode mode)
    : implementation_(std::make_unique<Implementation>(options, std::move(camera), mode)) {}

VisualLocalization::~VisualLocalization() = default;

void VisualLocalization::SetStart(const Rigid3d& T_map_camera) {
  implementation_->SetStart(T_map_camera);
}
TrackedImage VisualLocalization::Track(const RgbdImage& image) {
  return implementation_->Track(image);
}
void VisualLocalization::Reset() { implementation_->Reset(); }
void VisualLocalization::Reset(std::shared_ptr<const CameraModel> camera) {
  implementation_->Reset(std::move(camera));
}
void VisualLocalization::Restart() { implementation_->Restart(); }
void VisualLocalization::SetMapping(bool on) { implementation_->SetMapping(on); }
void VisualLocalization::SaveMap(const std::string& path) { implementation_->SaveMap(path); }
void VisualLocalization::LoadMap(const std::string& path) { implementation_->LoadMap(path); }
void VisualLocalization::Finish() { implementation_->Finish(); }
std::uint64_t VisualLocalization::revision() const { return implementation_->revision(); }
KeyframeGraph VisualLocalization::keyframe_graph() const {
  return implementation_->keyframe_graph();
}
std::vector<ColouredPoint> VisualLocalization::map_points() const {
  return implementation_->map_points();
}
std::vector<FeatureView> VisualLocalization::features() const {
  return implementation_->features();
}
std::size_t VisualLocalization::closed_loops() const { return implementation_->closed_loops(); }
std::size_t VisualLocalization::rejected_keyframes() const {
  return implementation_->rejected_keyframes();
}
std::vector<StageTiming> VisualLocalization::timings() const { return implementation_->timings(); }

}  // namespace semantic_slam
