#include "semantic_slam/tracking/keyframe_maker.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace semantic_slam {
namespace {

// "Few near points": fewer than this are tracked while more than that could be had.
constexpr int kFewTrackedNearPoints = 100;
constexpr int kManyNewNearPoints = 70;

}  // namespace

void KeyframeMaker::Reset() {
  images_since_keyframe_ = 0;
  most_inliers_since_keyframe_ = 0;
}

bool KeyframeMaker::WantsKeyframe(const FrameInWork& frame) {
  most_inliers_since_keyframe_ = std::max(most_inliers_since_keyframe_, frame.inliers);
  if (images_since_keyframe_ >= options_.max_keyframe_gap) return true;
  int tracked_near = 0, new_near = 0;
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const Feature& feature = (*frame.features)[i];
    if (frame.moves[i] || !feature.has_depth()) continue;
    if (feature.depth_m > options_.max_point_depth_m) continue;
    ++(frame.points[i] != kNoPoint ? tracked_near : new_near);
  }
  if (tracked_near < kFewTrackedNearPoints && new_near > kManyNewNearPoints) return true;
  return frame.inliers < options_.min_tracked_ratio * most_inliers_since_keyframe_;
}

KeyframeId KeyframeMaker::Insert(const CameraModel& camera, FrameInWork& frame) {
  Keyframe& keyframe = map_.AddKeyframe(frame.features, frame.T_map_camera);
  keyframe.left_out = frame.moves;
  const KeyframeId id = keyframe.id;
  AddObservations(id, frame);
  AddPoints(id, camera, frame);
  map_.UpdateCovisibility(id);
  map_.BumpRevision(RevisionReason::kLocalBa);
  frame.reference = id;
  Reset();
  return id;
}

void KeyframeMaker::AddObservations(KeyframeId keyframe, const FrameInWork& frame) {
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    if (frame.points[i] == kNoPoint) continue;
    map_.AddObservation(frame.points[i], keyframe, static_cast<int>(i));
    map_.UpdatePointAppearance(frame.points[i]);
    map_.UpdatePointGeometry(frame.points[i]);
  }
}

void KeyframeMaker::AddPoints(KeyframeId keyframe, const CameraModel& camera, FrameInWork& frame) {
  std::vector<std::pair<float, int>> without_point;  // depth, feature
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const Feature& feature = (*frame.features)[i];
    if (frame.points[i] == kNoPoint && feature.has_depth() && !frame.moves[i]) {
      without_point.emplace_back(feature.depth_m, static_cast<int>(i));
    }
  }
  std::sort(without_point.begin(), without_point.end());
  int added = 0;
  for (const auto& [depth_m, i] : without_point) {
    if (depth_m > options_.max_point_depth_m && added >= options_.min_new_points) break;
    const Eigen::Vector2f& pixel = (*frame.features)[i].pixel;
    const Eigen::Vector3d p_camera = camera.Unproject(pixel.x(), pixel.y(), depth_m);
    frame.points[i] = map_.AddPoint(frame.T_map_camera * p_camera, keyframe, i).id;
    ++added;
  }
}

}  // namespace semantic_slam
