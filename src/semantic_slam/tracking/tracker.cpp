#include "semantic_slam/tracking/tracker.h"

#include <mutex>
#include <utility>

#include "semantic_slam/tracking/local_points.h"

namespace semantic_slam {
namespace {

// Over a longer time the mean velocity says nothing of the present one.
constexpr double kMaxTwistIntervalS = 0.2;
constexpr float kWidenIfRough = 2.0f;

}  // namespace

Tracker::Tracker(const TrackerOptions& options, const ReadoutOptions& readout_options,
                 std::shared_ptr<const CameraModel> camera, Map& map, const PlaceIndex& index,
                 const MovingThingsOptions& moving_options)
    : options_(Validated(options)),
      map_(map),
      fitter_(options.depth_sigma_at_1m_m, readout_options, std::move(camera), map),
      keyframes_(options, map),
      lost_(options, index),
      moving_(moving_options.moving_parts, moving_options.feature_motion, fitter_.noise(),
              map.scales()),
      mask_(moving_options.semantic_mask) {}

void Tracker::Reset(std::shared_ptr<const CameraModel> camera) {
  fitter_.Reset(std::move(camera));
  ForgetLast();
  mask_.Reset();
  status_ = TrackingStatus::kInitializing;
  T_odom_camera_.reset();
}

void Tracker::StartLost() {
  ForgetLast();
  status_ = TrackingStatus::kLost;
}

void Tracker::ForgetLast() {
  last_ = FrameInWork();
  motion_.Reset();
  moving_.Reset();
  keyframes_.Reset();
  lost_.ForgetUnknown();
}

LabelImageFate Tracker::AddLabels(const LabelImage& image) {
  return mask_.Add(image, fitter_.camera());
}

void Tracker::SetMapping(bool on) {
  mapping_ = on;
  lost_.ForgetUnknown();
}

TrackerResult Tracker::Track(std::shared_ptr<const FrameFeatures> features, bool keyframe_allowed) {
  std::lock_guard<std::mutex> lock(map_.mutex());
  FrameInWork frame(std::move(features));
  if (status_ == TrackingStatus::kInitializing) {
    if (!mapping_ || !lost_.CanBeginMap(*frame.features)) {
      return Finish(frame, TrackingStatus::kInitializing, std::nullopt);
    }
    frame.covariance = BoundedPoseCovariance(Matrix6d::Zero());  // there by definition
    return BeginMap(frame, T_map_start_);
  }
  keyframes_.CountImage();
  lost_.CountImage();
  bool found = false;
  if (status_ == TrackingStatus::kTracking) {
    last_.T_map_camera = LastPose();
    found = TrackFromLast(frame) && TrackLocalMap(frame, lost_.MinInliers());
  }
  if (!found && !Relocalise(frame)) return StayLost(frame);
  lost_.ForgetUnknown();
  return FinishTracked(frame, keyframe_allowed);
}

// Where the image tracked last is in today's map; where a map starts if there is none.
Rigid3d Tracker::LastPose() const {
  if (last_.features == nullptr) return T_map_start_;
  return map_.KeyframePose(last_.reference) * last_.T_reference_camera;
}

// The frame's motion, now that its pose is about known.
void Tracker::MeasureTwist(FrameInWork& frame) const {
  const double since_last_s =
      last_.features ? SecondsBetween(last_.features->stamp(), frame.features->stamp()) : 0.0;
  const bool is_known = status_ == TrackingStatus::kTracking && since_last_s < kMaxTwistIntervalS;
  frame.twist = is_known
                    ? MeanTwist(last_.T_map_camera.inverse() * frame.T_map_camera, since_last_s)
                    : CameraTwist();
}

TrackerResult Tracker::BeginMap(FrameInWork& frame, const Rigid3d& T_map_camera) {
  frame.ForgetPoints();
  LeaveOutMasked(Rigid3d::Identity(), frame);
  frame.T_map_camera = T_map_camera;
  fitter_.Rectify(frame, CameraTwist());
  lost_.BeginMap();
  const KeyframeId first = keyframes_.Insert(fitter_.camera(), frame);
  return Finish(frame, TrackingStatus::kTracking, first);
}

// Begins a new map if the camera has been lost for long.
TrackerResult Tracker::StayLost(FrameInWork& frame) {
  if (!mapping_ || !lost_.IsLostForLong(*frame.features)) {
    return Finish(frame, TrackingStatus::kLost, std::nullopt);
  }
  const Rigid3d T_map_last = LastPose();
  map_.BeginNew(options_.max_dormant_keyframes);
  ForgetLast();
  frame.covariance = UnknownPoseCovariance();
  return BeginMap(frame, T_map_last);
}

TrackerResult Tracker::FinishTracked(FrameInWork& frame, bool keyframe_allowed) {
  const bool wants_keyframe = mapping_ && keyframes_.WantsKeyframe(frame);
  std::optional<KeyframeId> new_keyframe;
  if (wants_keyframe && keyframe_allowed) new_keyframe = keyframes_.Insert(fitter_.camera(), frame);
  TrackerResult result = Finish(frame, TrackingStatus::kTracking, new_keyframe);
  result.keyframe_rejected = wants_keyframe && !keyframe_allowed;
  return result;
}

// Leaves out what labels say. `T_last_camera` is the way since the last image, about.
void Tracker::LeaveOutMasked(const Rigid3d& T_last_camera, FrameInWork& frame) const {
  const Rigid3d T_odom_last = T_odom_camera_.value_or(T_map_start_);
  frame.moves = mask_.Find(*frame.features, T_odom_last * T_last_camera, fitter_.camera());
}

// Leaves out, too, what is seen to move.
void Tracker::LeaveOutMoving(FrameInWork& frame) {
  const Rigid3d T_last_camera = last_.T_map_camera.inverse() * frame.T_map_camera;
  frame.moves = moving_.Find(frame.features, T_last_camera, frame.moves, fitter_.camera());
  MarkWithoutDepth(*frame.features, fitter_.camera(), frame.moves);
  for (std::size_t i = 0; i < frame.moves.size(); ++i) {
    if (frame.moves[i]) frame.points[i] = kNoPoint;
  }
}

// The features of the last image that show a map point or have at least depth of their own, but
// for what moves.
KnownView Tracker::LastView() const {
  KnownView view{last_.features.get(), {}};
  for (std::size_t i = 0; i < last_.features->size(); ++i) {
    const Feature& feature = (*last_.features)[i];
    if (last_.moves[i]) continue;
    const PointId id = map_.Resolve(last_.points[i]);
    if (id != kNoPoint) {
      view.points.push_back({static_cast<int>(i), map_.FindPoint(id)->position, id});
    } else if (feature.has_depth()) {
      const Eigen::Vector3d p_camera =
          fitter_.camera().Unproject(feature.pixel.x(), feature.pixel.y(), feature.depth_m);
      view.points.push_back({static_cast<int>(i), last_.T_map_camera * p_camera, kNoPoint});
    }
  }
  return view;
}

// The pose from what the last image knew: where the prediction expects it, in a wider circle, and
// at last wherever it may be. Leaves the map points found in `frame`.
bool Tracker::TrackFromLast(FrameInWork& frame) {
  const KnownView view = LastView();
  const Stamp last = last_.features->stamp(), now = frame.features->stamp();
  const Rigid3d T_last_expected = motion_.Predict(last, now);
  const Rigid3d T_map_predicted = last_.T_map_camera * T_last_expected;
  frame.reference = last_.reference;
  fitter_.Rectify(frame, motion_.Twist(last, now));
  LeaveOutMasked(T_last_expected, frame);
  if (fitter_.MatchNear(view, T_map_predicted, options_.search_radius_px, frame) ||
      fitter_.MatchNear(view, T_map_predicted, 2.0 * options_.search_radius_px, frame)) {
    LeaveOutMoving(frame);
    return true;
  }
  moving_.Reset();
  auto found = Relocalize(*frame.features, view, map_.scales(), fitter_.camera(), fitter_.noise(),
                          options_.min_inliers);
  if (!found) return false;
  frame.T_map_camera = found->T_map_camera;
  frame.points = std::move(found->points);
  return true;
}

bool Tracker::Relocalise(FrameInWork& frame) {
  moving_.Reset();
  LeaveOutMasked(Rigid3d::Identity(), frame);
  for (const KeyframeId candidate : lost_.Candidates(*frame.features, map_)) {
    auto found = Relocalize(*frame.features, ViewOf(*map_.FindKeyframe(candidate), map_),
                            map_.scales(), fitter_.camera(), fitter_.noise(), options_.min_inliers);
    if (!found) continue;
    frame.T_map_camera = found->T_map_camera;
    frame.points = std::move(found->points);
    frame.reference = candidate;
    if (!TrackLocalMap(frame, options_.min_relocalization_inliers)) continue;
    motion_.Reset();
    lost_.Found();
    return true;
  }
  return false;
}

bool Tracker::TrackLocalMap(FrameInWork& frame, int min_inliers) {
  const auto local_points = CollectLocalPoints(map_, options_.max_local_keyframes, frame);
  LocalMatching matching;
  matching.widen = lost_.IsJustFound() ? kWidenIfRough : 1.0f;
  matching.count_visible = mapping_;
  MatchLocalPoints(local_points, fitter_.camera(), matching, map_, frame);
  MeasureTwist(frame);
  fitter_.FitToPoints(mapping_, frame);
  return frame.inliers >= min_inliers;
}

// odom goes on from the last image by the way that the camera has made in today's map.
void Tracker::AdvanceOdom(const FrameInWork& frame, bool was_tracking) {
  if (last_.features != nullptr) {
    const Rigid3d T_last_camera = LastPose().inverse() * frame.T_map_camera;
    T_odom_camera_ = Orthonormalised(*T_odom_camera_ * T_last_camera);
    if (was_tracking) {
      motion_.Update(last_.features->stamp(), frame.features->stamp(), T_last_camera);
    }
  } else if (!T_odom_camera_) {
    T_odom_camera_ = T_map_start_;
  }
  mask_.AddPose(frame.features->stamp(), *T_odom_camera_);
}

TrackerResult Tracker::Finish(FrameInWork& frame, TrackingStatus status,
                              std::optional<KeyframeId> new_keyframe) {
  const bool was_tracking = status_ == TrackingStatus::kTracking;
  status_ = status;
  TrackerResult result;
  result.new_keyframe = new_keyframe;
  result.is_inlier = frame.is_inlier;
  result.moves = frame.moves;
  TrackedImage& image = result.image;
  image.stamp = frame.features->stamp();
  image.status = status;
  image.map_id = map_.map_id();
  if (status != TrackingStatus::kTracking) return result;

  frame.T_reference_camera =
      map_.FindKeyframe(frame.reference)->T_map_camera.inverse() * frame.T_map_camera;
  AdvanceOdom(frame, was_tracking);
  image.keyframe_id = frame.reference;
  image.T_keyframe_camera = frame.T_reference_camera;
  image.T_map_camera = frame.T_map_camera;
  image.T_odom_camera = *T_odom_camera_;
  image.covariance = frame.covariance;
  image.inliers = frame.inliers;
  image.is_keyframe = new_keyframe.has_value();
  last_ = std::move(frame);
  return result;
}

}  // namespace semantic_slam
