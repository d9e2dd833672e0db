#include "semantic_slam/tracking/tracker.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "semantic_slam/tracking/pose_optimizer.h"
#include "semantic_slam/tracking/projection_matcher.h"

namespace semantic_slam {
namespace {

// A match to the last image is believed with this much support; else it was made in the wrong
// place.
constexpr int kMinInliersFromLast = 20;
constexpr double kMinInlierShareFromLast = 0.25;
// After the camera was lost a pose is believed only with more support, for this many images.
constexpr int kCautiousImages = 30;
// Over a longer time the mean velocity says nothing of the present one.
constexpr double kMaxTwistIntervalS = 0.2;
// Local map: search radius on level 0 for a view nearly from the front, and else.
constexpr float kFrontalRadiusPx = 5.0f;
constexpr float kObliqueRadiusPx = 8.0f;
constexpr double kFrontalCosine = 0.998;
constexpr double kMaxLocalRatio = 0.8;
constexpr int kMaxLocalDistance = 60;
constexpr int kNeighboursPerLocalKeyframe = 10;
// "Few near points": fewer than this are tracked while more than that could be had.
constexpr int kFewTrackedNearPoints = 100;
constexpr int kManyNewNearPoints = 70;

Eigen::Vector3d Unproject(const Feature& feature, const CameraModel& camera) {
  return camera.Unproject(feature.pixel.x(), feature.pixel.y(), feature.depth_m);
}

std::vector<bool> Taken(const std::vector<PointId>& points) {
  std::vector<bool> taken(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) taken[i] = points[i] != kNoPoint;
  return taken;
}

PoseObservation Observe(const Eigen::Vector3d& p_map, const Feature& feature,
                        const std::vector<float>& scales, const CameraModel& camera) {
  return {p_map, feature.exposed.cast<double>(), feature.depth_m, scales[feature.octave],
          camera.RowFraction(feature.raw.y())};
}

}  // namespace

Tracker::Tracker(const TrackerOptions& options, const ReadoutOptions& readout_options,
                 std::shared_ptr<const CameraModel> camera, Map& map, const PlaceIndex& index)
    : options_(Validated(options)),
      noise_{options.depth_sigma_at_1m_m},
      camera_(std::move(camera)),
      map_(map),
      index_(index),
      readout_(readout_options, camera_->intrinsics().readout_s) {}

void Tracker::Reset(std::shared_ptr<const CameraModel> camera) {
  if (!(camera->intrinsics() == camera_->intrinsics()))
    readout_.Reset(camera->intrinsics().readout_s);
  camera_ = std::move(camera);
  ForgetLast();
  status_ = TrackingStatus::kInitializing;
  T_odom_camera_.reset();
}

void Tracker::StartLost() {
  ForgetLast();
  status_ = TrackingStatus::kLost;
}

void Tracker::ForgetLast() {
  last_ = Frame();
  motion_.Reset();
  images_since_keyframe_ = 0;
  most_inliers_since_keyframe_ = 0;
  unknown_since_.reset();
}

void Tracker::SetMapping(bool on) {
  mapping_ = on;
  unknown_since_.reset();
}

TrackerResult Tracker::Track(std::shared_ptr<const FrameFeatures> features, bool keyframe_allowed) {
  std::lock_guard<std::mutex> lock(map_.mutex());
  Frame frame;
  frame.points.assign(features->size(), kNoPoint);
  frame.is_inlier.assign(features->size(), false);
  frame.features = std::move(features);
  if (status_ == TrackingStatus::kInitializing) {
    if (!mapping_ || !CanBeginMap(frame)) {
      return Finish(frame, TrackingStatus::kInitializing, std::nullopt);
    }
    return BeginMap(frame, T_map_start_);
  }
  ++images_since_keyframe_;
  ++images_since_relocalization_;
  bool found = false;
  if (status_ == TrackingStatus::kTracking) {
    last_.T_map_camera = LastPose();
    found = TrackFromLast(frame);
  }
  found = found && TrackLocalMap(frame, images_since_relocalization_ < kCautiousImages
                                            ? options_.min_relocalization_inliers
                                            : options_.min_inliers);
  if (!found && !Relocalise(frame)) {
    if (!mapping_ || !IsLostForLong(frame)) {
      return Finish(frame, TrackingStatus::kLost, std::nullopt);
    }
    const Rigid3d T_map_last = LastPose();
    map_.BeginNew(options_.max_dormant_keyframes);
    ForgetLast();
    return BeginMap(frame, T_map_last);
  }
  unknown_since_.reset();

  TrackerResult result;
  std::optional<KeyframeId> new_keyframe;
  const bool wants_keyframe = mapping_ && WantsKeyframe(frame);
  if (wants_keyframe && keyframe_allowed) new_keyframe = InsertKeyframe(frame);
  result = Finish(frame, TrackingStatus::kTracking, new_keyframe);
  result.keyframe_rejected = wants_keyframe && !keyframe_allowed;
  return result;
}

// Where the image tracked last is in today's map; where a map starts if there is none.
Rigid3d Tracker::LastPose() const {
  if (last_.features == nullptr) return T_map_start_;
  return map_.KeyframePose(last_.reference) * last_.T_reference_camera;
}

// What the rows of the frame tell apart; nothing if the shutter is known not to roll.
std::optional<RollingShutter> Tracker::Shutter(const Frame& frame) const {
  if (!readout_.is_rolling()) return std::nullopt;
  return RollingShutter{readout_.readout_s(), frame.twist, readout_.turn_sigma_radps()};
}

// From here on the frame's features are where they would be without a rolling shutter.
void Tracker::Rectify(Frame& frame, const CameraTwist& twist) const {
  if (!readout_.is_rolling()) return;
  frame.twist = twist;
  frame.features = frame.features->Rectified(twist, readout_.readout_s(), *camera_);
}

// The frame's motion, now that its pose is about known.
void Tracker::MeasureTwist(Frame& frame) const {
  const double since_last_s =
      last_.features ? SecondsBetween(last_.features->stamp(), frame.features->stamp()) : 0.0;
  const bool is_known = status_ == TrackingStatus::kTracking && since_last_s < kMaxTwistIntervalS;
  frame.twist = is_known
                    ? MeanTwist(last_.T_map_camera.inverse() * frame.T_map_camera, since_last_s)
                    : CameraTwist();
}

bool Tracker::CanBeginMap(const Frame& frame) const {
  int with_depth = 0;
  for (const Feature& feature : frame.features->features()) with_depth += feature.has_depth();
  return with_depth >= options_.min_initial_points;
}

// Whether the lost camera has seen for long enough what it does not know. An image that shows
// hardly anything, of a covered lens, begins the time anew.
bool Tracker::IsLostForLong(const Frame& frame) {
  if (!CanBeginMap(frame)) {
    unknown_since_.reset();
    return false;
  }
  const Stamp stamp = frame.features->stamp();
  if (!unknown_since_) unknown_since_ = stamp;
  return SecondsBetween(*unknown_since_, stamp) >= options_.new_map_after_s;
}

TrackerResult Tracker::BeginMap(Frame& frame, const Rigid3d& T_map_camera) {
  std::fill(frame.points.begin(), frame.points.end(), kNoPoint);
  std::fill(frame.is_inlier.begin(), frame.is_inlier.end(), false);
  frame.T_map_camera = T_map_camera;
  Rectify(frame, CameraTwist());
  images_since_relocalization_ = kCautiousImages;
  unknown_since_.reset();
  const KeyframeId first = InsertKeyframe(frame);
  return Finish(frame, TrackingStatus::kTracking, first);
}

// The features of the last image that show a map point or have at least depth of their own.
KnownView Tracker::LastView() const {
  KnownView view{last_.features.get(), {}};
  for (std::size_t i = 0; i < last_.features->size(); ++i) {
    const Feature& feature = (*last_.features)[i];
    const PointId id = map_.Resolve(last_.points[i]);
    if (id != kNoPoint) {
      view.points.push_back({static_cast<int>(i), map_.FindPoint(id)->position, id});
    } else if (feature.has_depth()) {
      view.points.push_back(
          {static_cast<int>(i), last_.T_map_camera * Unproject(feature, *camera_), kNoPoint});
    }
  }
  return view;
}

// The pose from what the last image knew: where the prediction expects it, in a wider circle, and
// at last wherever it may be. Leaves the map points found in `frame`.
bool Tracker::TrackFromLast(Frame& frame) const {
  const KnownView view = LastView();
  const Rigid3d T_map_predicted =
      last_.T_map_camera * motion_.Predict(last_.features->stamp(), frame.features->stamp());
  frame.reference = last_.reference;
  Rectify(frame, motion_.Twist(last_.features->stamp(), frame.features->stamp()));
  if (MatchNear(view, T_map_predicted, options_.search_radius_px, frame) ||
      MatchNear(view, T_map_predicted, 2.0 * options_.search_radius_px, frame)) {
    return true;
  }
  auto found =
      Relocalize(*frame.features, view, map_.scales(), *camera_, noise_, options_.min_inliers);
  if (!found) return false;
  frame.T_map_camera = found->T_map_camera;
  frame.points = std::move(found->points);
  return true;
}

bool Tracker::MatchNear(const KnownView& view, const Rigid3d& T_map_predicted, double radius_px,
                        Frame& frame) const {
  const Rigid3d T_camera_map = T_map_predicted.inverse();
  std::vector<ProjectionCandidate> candidates;
  std::vector<const KnownView::Point*> points;
  for (const KnownView::Point& point : view.points) {
    const Eigen::Vector3d p_camera = T_camera_map * point.position;
    if (!(p_camera.z() > 0.0)) continue;
    const Eigen::Vector2f pixel = camera_->Project(p_camera).cast<float>();
    if (!camera_->undistorted_bounds().contains(cv::Point2f(pixel.x(), pixel.y()))) continue;
    const Feature& feature = (*view.features)[point.feature];
    candidates.push_back({pixel, static_cast<float>(radius_px) * map_.scales()[feature.octave],
                          feature.octave - 1, feature.octave + 1, feature.angle_rad,
                          &view.features->descriptor(point.feature)});
    points.push_back(&point);
  }
  ProjectionMatchingOptions matching;
  matching.check_rotation = true;
  const std::vector<int> matches = MatchByProjection(
      candidates, *frame.features, std::vector<bool>(frame.features->size(), false), matching);

  std::vector<PoseObservation> observations;
  std::vector<std::pair<int, PointId>> matched;  // feature, point
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (matches[i] < 0) continue;
    observations.push_back(
        Observe(points[i]->position, (*frame.features)[matches[i]], map_.scales(), *camera_));
    matched.emplace_back(matches[i], points[i]->id);
  }
  const PoseEstimate estimate =
      OptimizePose(observations, T_map_predicted, *camera_, noise_, Shutter(frame));
  if (estimate.inliers < kMinInliersFromLast ||
      estimate.inliers < kMinInlierShareFromLast * static_cast<double>(matched.size())) {
    return false;
  }
  Rectify(frame, estimate.twist);
  frame.T_map_camera = estimate.T_map_camera;
  std::fill(frame.points.begin(), frame.points.end(), kNoPoint);
  for (std::size_t i = 0; i < matched.size(); ++i) {
    if (estimate.is_inlier[i]) frame.points[matched[i].first] = matched[i].second;
  }
  return true;
}

// Half of the candidates are keyframes that look like the image, best first; the others take turns,
// so that every keyframe of a large map is tried once in a while.
std::vector<KeyframeId> Tracker::RelocalizationCandidates(const FrameFeatures& features) {
  const std::size_t limit = options_.relocalization_keyframes;
  std::vector<KeyframeId> candidates;
  for (const PlaceScore& place : index_.Query(features)) {
    if (candidates.size() >= (limit + 1) / 2) break;
    const Keyframe* keyframe = map_.FindKeyframe(place.keyframe);
    if (keyframe != nullptr && map_.IsPresent(*keyframe)) candidates.push_back(place.keyframe);
  }
  std::vector<KeyframeId> others;
  for (const auto& entry : map_.keyframes()) {
    const auto end = candidates.end();
    if (!map_.IsPresent(*entry.second)) continue;
    if (std::find(candidates.begin(), end, entry.first) == end) others.push_back(entry.first);
  }
  std::reverse(others.begin(), others.end());  // the latest first
  const std::size_t turns = std::min(limit - candidates.size(), others.size());
  for (std::size_t i = 0; i < turns; ++i) {
    candidates.push_back(others[next_old_keyframe_++ % others.size()]);
  }
  return candidates;
}

bool Tracker::Relocalise(Frame& frame) {
  for (const KeyframeId candidate : RelocalizationCandidates(*frame.features)) {
    auto found = Relocalize(*frame.features, ViewOf(*map_.FindKeyframe(candidate), map_),
                            map_.scales(), *camera_, noise_, options_.min_inliers);
    if (!found) continue;
    frame.T_map_camera = found->T_map_camera;
    frame.points = std::move(found->points);
    frame.reference = candidate;
    if (!TrackLocalMap(frame, options_.min_relocalization_inliers)) continue;
    motion_.Reset();
    images_since_relocalization_ = 0;
    return true;
  }
  return false;
}

bool Tracker::TrackLocalMap(Frame& frame, int min_inliers) {
  MatchLocalPoints(frame, CollectLocalPoints(frame));
  OptimiseFrame(frame);
  return frame.inliers >= min_inliers;
}

// The points of all keyframes that share points with the frame, and of those keyframes' neighbours.
// Also makes the keyframe that shares most the frame's reference.
std::vector<PointId> Tracker::CollectLocalPoints(Frame& frame) const {
  std::map<KeyframeId, int> votes;
  for (const PointId id : frame.points) {
    if (id == kNoPoint) continue;
    for (const Observation& o : map_.FindPoint(id)->observations) ++votes[o.keyframe];
  }
  if (votes.empty()) votes[frame.reference] = 0;  // its point may be gone; start from what is known
  std::vector<std::pair<int, KeyframeId>> order;
  for (const auto& [id, count] : votes) {
    if (map_.FindKeyframe(id) != nullptr) order.emplace_back(-count, id);
  }
  std::sort(order.begin(), order.end());
  if (!order.empty()) frame.reference = order.front().second;

  std::vector<KeyframeId> local;
  std::set<KeyframeId> seen;
  const auto add = [&](KeyframeId id) {
    if (static_cast<int>(local.size()) < options_.max_local_keyframes && seen.insert(id).second) {
      local.push_back(id);
    }
  };
  for (const auto& entry : order) add(entry.second);
  const std::size_t direct = local.size();
  for (std::size_t i = 0; i < direct; ++i) {
    for (const KeyframeId id : map_.BestCovisible(local[i], kNeighboursPerLocalKeyframe)) add(id);
  }
  std::vector<PointId> points;
  for (const KeyframeId id : local) {
    for (const PointId point : map_.FindKeyframe(id)->points) {
      if (point != kNoPoint) points.push_back(point);
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void Tracker::MatchLocalPoints(Frame& frame, const std::vector<PointId>& local_points) {
  std::set<PointId> matched(frame.points.begin(), frame.points.end());
  for (const PointId id : matched) {
    if (id != kNoPoint) map_.FindPoint(id)->visible += mapping_;
  }
  const Rigid3d T_camera_map = frame.T_map_camera.inverse();
  std::vector<ProjectionCandidate> candidates;
  std::vector<PointId> ids;
  // Wider while the pose is still rough.
  const float widen = images_since_relocalization_ < 2 ? 2.0f : 1.0f;
  for (const PointId id : local_points) {
    if (matched.count(id) > 0) continue;
    MapPoint& point = *map_.FindPoint(id);
    const auto view = PredictView(point, T_camera_map, *camera_, map_.scales());
    if (!view) continue;
    point.visible += mapping_;
    const float radius = view->view_cosine > kFrontalCosine ? kFrontalRadiusPx : kObliqueRadiusPx;
    candidates.push_back({view->pixel, widen * radius * map_.scales()[view->octave],
                          view->octave - 1, view->octave + 1, 0.0f, &point.descriptor});
    ids.push_back(id);
  }
  ProjectionMatchingOptions matching;
  matching.max_ratio = kMaxLocalRatio;
  matching.max_distance = kMaxLocalDistance;
  const std::vector<int> matches =
      MatchByProjection(candidates, *frame.features, Taken(frame.points), matching);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (matches[i] >= 0) frame.points[matches[i]] = ids[i];
  }
}

void Tracker::OptimiseFrame(Frame& frame) {
  std::vector<PoseObservation> observations;
  std::vector<std::size_t> features;
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    if (frame.points[i] == kNoPoint) continue;
    observations.push_back(Observe(map_.FindPoint(frame.points[i])->position, (*frame.features)[i],
                                   map_.scales(), *camera_));
    features.push_back(i);
  }
  MeasureTwist(frame);
  const PoseEstimate estimate =
      OptimizePose(observations, frame.T_map_camera, *camera_, noise_, Shutter(frame));
  Rectify(frame, estimate.twist);
  readout_.Add(estimate.readout);
  frame.T_map_camera = estimate.T_map_camera;
  frame.inliers = estimate.inliers;
  std::fill(frame.is_inlier.begin(), frame.is_inlier.end(), false);
  for (std::size_t k = 0; k < features.size(); ++k) {
    frame.is_inlier[features[k]] = estimate.is_inlier[k];
    if (estimate.is_inlier[k]) {
      map_.FindPoint(frame.points[features[k]])->found += mapping_;
    } else {
      frame.points[features[k]] = kNoPoint;
    }
  }
}

// After Mur-Artal and Tardos, ORB-SLAM2, section III.E: often rather than seldom, because local
// mapping takes out what turns out to be redundant.
bool Tracker::WantsKeyframe(const Frame& frame) {
  most_inliers_since_keyframe_ = std::max(most_inliers_since_keyframe_, frame.inliers);
  if (images_since_keyframe_ >= options_.max_keyframe_gap) return true;
  int tracked_near = 0, new_near = 0;
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const Feature& feature = (*frame.features)[i];
    if (!feature.has_depth() || feature.depth_m > options_.max_point_depth_m) continue;
    ++(frame.points[i] != kNoPoint ? tracked_near : new_near);
  }
  if (tracked_near < kFewTrackedNearPoints && new_near > kManyNewNearPoints) return true;
  return frame.inliers < options_.min_tracked_ratio * most_inliers_since_keyframe_;
}

KeyframeId Tracker::InsertKeyframe(Frame& frame) {
  Keyframe& keyframe = map_.AddKeyframe(frame.features, frame.T_map_camera);
  std::vector<std::pair<float, int>> without_point;  // depth, feature
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    if (frame.points[i] != kNoPoint) {
      map_.AddObservation(frame.points[i], keyframe.id, static_cast<int>(i));
      map_.UpdatePointAppearance(frame.points[i]);
      map_.UpdatePointGeometry(frame.points[i]);
    } else if ((*frame.features)[i].has_depth()) {
      without_point.emplace_back((*frame.features)[i].depth_m, static_cast<int>(i));
    }
  }
  std::sort(without_point.begin(), without_point.end());
  int added = 0;
  for (const auto& [depth_m, i] : without_point) {
    if (depth_m > options_.max_point_depth_m && added >= options_.min_new_points) break;
    const Eigen::Vector3d p_camera = Unproject((*frame.features)[i], *camera_);
    frame.points[i] = map_.AddPoint(frame.T_map_camera * p_camera, keyframe.id, i).id;
    ++added;
  }
  map_.UpdateCovisibility(keyframe.id);
  map_.BumpRevision(RevisionReason::kLocalBa);
  frame.reference = keyframe.id;
  images_since_keyframe_ = 0;
  most_inliers_since_keyframe_ = 0;
  return keyframe.id;
}

TrackerResult Tracker::Finish(Frame& frame, TrackingStatus status,
                              std::optional<KeyframeId> new_keyframe) {
  const bool was_tracking = status_ == TrackingStatus::kTracking;
  status_ = status;
  TrackerResult result;
  result.new_keyframe = new_keyframe;
  result.is_inlier = frame.is_inlier;
  TrackedImage& image = result.image;
  image.stamp = frame.features->stamp();
  image.status = status;
  image.map_id = map_.map_id();
  if (status != TrackingStatus::kTracking) return result;

  frame.T_reference_camera =
      map_.FindKeyframe(frame.reference)->T_map_camera.inverse() * frame.T_map_camera;
  if (last_.features != nullptr) {
    const Rigid3d T_last_camera = LastPose().inverse() * frame.T_map_camera;
    T_odom_camera_ = Orthonormalised(*T_odom_camera_ * T_last_camera);
    if (was_tracking) {
      motion_.Update(last_.features->stamp(), frame.features->stamp(), T_last_camera);
    }
  } else if (!T_odom_camera_) {
    T_odom_camera_ = T_map_start_;
  }
  image.keyframe_id = frame.reference;
  image.T_keyframe_camera = frame.T_reference_camera;
  image.T_map_camera = frame.T_map_camera;
  image.T_odom_camera = *T_odom_camera_;
  image.inliers = frame.inliers;
  image.is_keyframe = new_keyframe.has_value();
  last_ = std::move(frame);
  return result;
}

}  // namespace semantic_slam
