#include "semantic_slam/localization/visual_localization.h"

#include <atomic>
#include <mutex>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/localization/mapping_pipeline.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/map_file.h"

namespace semantic_slam {

class VisualLocalization::Implementation {
 public:
  Implementation(const LocalizationOptions& options, std::shared_ptr<const CameraModel> camera,
                 MappingMode mode)
      : camera_(std::move(camera)),
        extractor_(options.features),
        map_(extractor_.scales()),
        index_(options.place_recognition),
        pipeline_(options.local_mapping, options.loop_closer, camera_, map_, index_, timer_, mode),
        tracker_(options.tracking, options.readout, camera_, map_, index_, options.moving) {}

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
      result = tracker_.Track(features, pipeline_.HasRoom());
    }
    rejected_keyframes_ += result.keyframe_rejected;
    KeepForView(std::move(features), std::move(result.is_inlier), std::move(result.moves));
    if (result.new_keyframe) pipeline_.Add(*result.new_keyframe);
    return result.image;
  }

  LabelImageFate AddLabels(const LabelImage& image) {
    std::lock_guard<std::mutex> lock(tracking_mutex_);
    return tracker_.AddLabels(image);
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
    pipeline_.KnowMap(camera_);
    tracker_.StartLost();
  }

  void Finish() { pipeline_.Finish(); }

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
      views.push_back({feature.raw, 31.0f * extractor_.scales()[feature.octave], is_inlier_[i],
                       is_left_out_[i]});
    }
    return views;
  }

  std::size_t closed_loops() const { return pipeline_.loops(); }
  std::size_t rejected_keyframes() const { return rejected_keyframes_; }
  std::vector<StageTiming> timings() const { return timer_.Timings(); }

 private:
  // Begins an empty map of camera_'s images. The caller holds tracking_mutex_, so the pipeline
  // gets no work; when it has finished, it may be changed too.
  void Begin() {
    Finish();
    {
      std::lock_guard<std::mutex> lock(map_.mutex());
      map_.Clear();
    }
    tracker_.Reset(camera_);
    pipeline_.Reset(camera_);
    last_stamp_.reset();
  }

  bool HasMap() const {
    std::lock_guard<std::mutex> lock(map_.mutex());
    return !map_.keyframes().empty();
  }

  void KeepForView(std::shared_ptr<const FrameFeatures> features, std::vector<bool> is_inlier,
                   std::vector<bool> is_left_out) {
    std::lock_guard<std::mutex> lock(view_mutex_);
    viewed_ = std::move(features);
    is_inlier_ = std::move(is_inlier);
    is_left_out_ = std::move(is_left_out);
  }

  std::shared_ptr<const CameraModel> camera_;  // guarded by tracking_mutex_
  const OrbExtractor extractor_;
  StageTimer timer_;
  Map map_;
  PlaceIndex index_;
  MappingPipeline pipeline_;
  std::atomic<std::size_t> rejected_keyframes_{0};

  std::mutex tracking_mutex_;        // taken before all others
  Tracker tracker_;                  // guarded by tracking_mutex_
  std::optional<Stamp> last_stamp_;  // guarded by tracking_mutex_

  mutable std::mutex view_mutex_;
  std::shared_ptr<const FrameFeatures> viewed_;  // guarded by view_mutex_
  std::vector<bool> is_inlier_;                  // guarded by view_mutex_
  std::vector<bool> is_left_out_;                // the same
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
LabelImageFate VisualLocalization::AddLabels(const LabelImage& image) {
  return implementation_->AddLabels(image);
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
