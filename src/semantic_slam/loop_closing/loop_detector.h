#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"
#include "semantic_slam/place_recognition/place_index.h"

namespace semantic_slam {

struct LoopDetectorOptions {
  double depth_sigma_at_1m_m = 0.02;  // of the depth sensor; grows with depth squared
  int max_candidates = 3;             // places looked at per keyframe
  double min_score_share = 0.25;    // of a place's score, to that of the keyframe's best neighbour
  int min_ransac_inliers = 20;      // features that agree on a pose by appearance alone
  int min_inliers = 50;             // map points around the place that are found again from there
  int confirming_keyframes = 2;     // neighbours of the keyframe that must find the place too
  int min_confirming_inliers = 25;  // and with how many points

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("depth_sigma_at_1m_m", self.depth_sigma_at_1m_m, 1e-4, 1.0);
    visit("max_candidates", self.max_candidates, 1, 100);
    visit("min_score_share", self.min_score_share, 0.0, 10.0);
    visit("min_ransac_inliers", self.min_ransac_inliers, 6, 1000);
    visit("min_inliers", self.min_inliers, 6, 1000);
    visit("confirming_keyframes", self.confirming_keyframes, 0, 10);
    visit("min_confirming_inliers", self.min_confirming_inliers, 6, 1000);
  }
};

// A keyframe of the present map that shows a place which an older part of it, or a dormant map,
// shows too.
struct Loop {
  KeyframeId keyframe = kNoKeyframe;
  KeyframeId place = kNoKeyframe;                // a keyframe of the older part
  Rigid3d T_map_keyframe = Rigid3d::Identity();  // where the older part's points put the keyframe,
                                                 // in the frame of the place's map
  std::vector<PointId> points;  // per feature of the keyframe: the older part's point; or kNoPoint
};

// Thesis section 3.2.4: finds out that the camera is back at a known place. Appearance proposes,
// and geometry decides: a pose by RANSAC, refined on all points around the place, which neighbours
// of the keyframe must confirm. Holds the map's mutex only to copy from the map. Safe from any
// thread.
class LoopDetector {
 public:
  // Throws ConfigError if an option is out of range. `index` and `map` must outlive it.
  LoopDetector(const LoopDetectorOptions& options, const PlaceIndex& index, const Map& map);

  // nullopt if the keyframe shows no place that it is not connected with already, or is gone.
  std::optional<Loop> Detect(KeyframeId keyframe, const CameraModel& camera) const;

 private:
  struct View;

  std::vector<KeyframeId> Candidates(KeyframeId keyframe, const FrameFeatures& features) const;
  std::optional<Loop> Verify(const View& view, KeyframeId place, const CameraModel& camera) const;
  bool IsConfirmed(const View& view, const Rigid3d& T_map_keyframe,
                   const std::vector<MapPoint>& place_points, const CameraModel& camera) const;

  const LoopDetectorOptions options_;
  const ObservationNoise noise_;
  const PlaceIndex& index_;
  const Map& map_;
};

}  // namespace semantic_slam
