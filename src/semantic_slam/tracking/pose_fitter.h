#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"
#include "semantic_slam/tracking/frame_in_work.h"
#include "semantic_slam/tracking/pose_optimizer.h"
#include "semantic_slam/tracking/readout_estimator.h"
#include "semantic_slam/tracking/relocalizer.h"

namespace semantic_slam {

// Fits the pose of an image to points that it shows, and knows what the rows of the image tell
// apart if the shutter rolls. The caller holds the map's mutex. Not thread-safe.
class PoseFitter {
 public:
  // Throws ConfigError if an option is out of range. `map` must outlive this.
  PoseFitter(double depth_sigma_at_1m_m, const ReadoutOptions& readout_options,
             std::shared_ptr<const CameraModel> camera, Map& map);

  // Images to come are of `camera`; the readout time is learned anew if its calibration is another.
  void Reset(std::shared_ptr<const CameraModel> camera);

  const CameraModel& camera() const { return *camera_; }
  const ObservationNoise& noise() const { return noise_; }
  double readout_s() const { return readout_.readout_s(); }

  // From here on the frame's features are where they would be without a rolling shutter.
  void Rectify(FrameInWork& frame, const CameraTwist& twist) const;

  // Looks for what `view` knows, within `radius_px` of where the predicted pose expects it, among
  // what is not left out. True if enough is found that agrees on a pose; then the frame has that
  // pose and the map points found.
  bool MatchNear(const KnownView& view, const Rigid3d& T_map_predicted, double radius_px,
                 FrameInWork& frame) const;

  // The pose by all points matched to the frame. Those that do not fit it are taken from the frame;
  // those that do are counted as found if `count_found`. Precondition: frame.twist is its motion as
  // far as it is known.
  void FitToPoints(bool count_found, FrameInWork& frame);

 private:
  std::optional<RollingShutter> Shutter(const FrameInWork& frame) const;

  const ObservationNoise noise_;
  std::shared_ptr<const CameraModel> camera_;
  Map& map_;
  ReadoutEstimator readout_;
};

}  // namespace semantic_slam
