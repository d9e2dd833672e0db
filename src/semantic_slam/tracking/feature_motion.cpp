#include "semantic_slam/tracking/feature_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "semantic_slam/tracking/image_cells.h"
#include "semantic_slam/tracking/pose_optimizer.h"
#include "semantic_slam/tracking/projection_matcher.h"

namespace semantic_slam {
namespace {

constexpr int kMaxVotesPerCell = 8;
constexpr int kMinVotes = 20;
constexpr double kMinDepthM = 0.05;
// Half the side of the square in which a feature is looked for that stands still [px on level 0].
constexpr double kStillRadiusPx = 10.0;
constexpr int kMaxDistance = 60;
constexpr double kMaxRatio = 0.85;

Eigen::Vector3d InCamera(const Feature& feature, double depth_m, const CameraModel& camera) {
  return camera.Unproject(feature.pixel.x(), feature.pixel.y(), depth_m);
}

}  // namespace

FeatureMotions::FeatureMotions(const FeatureMotionOptions& options, const ObservationNoise& noise,
                               std::vector<float> scales)
    : options_(Validated(options)), noise_(noise), scales_(std::move(scales)) {}

std::vector<FeatureMotion> FeatureMotions::Follow(std::shared_ptr<const FrameFeatures> features,
                                                  const Rigid3d& T_last_camera,
                                                  const CameraModel& camera) {
  Image now;
  now.moves.assign(features->size(), false);
  now.features = std::move(features);
  std::vector<FeatureMotion> motions(now.features->size());
  const Stamp stamp = now.features->stamp();
  while (!images_.empty() &&
         SecondsBetween(images_.front().features->stamp(), stamp) > options_.window_s) {
    images_.pop_front();
  }
  if (!images_.empty()) {
    now.T_still_camera = images_.back().T_still_camera * T_last_camera;
    const Image& then = images_.front();
    std::vector<int> voters;
    for (std::size_t i = 0; i < then.moves.size(); ++i) {
      if (!then.moves[i]) voters.push_back(static_cast<int>(i));
    }
    const std::vector<Pair> pairs = Match(then, now, voters, now.moves, 0.0, camera);
    if (MoveCamera(then, pairs, now, camera)) {
      JudgeAll(then, pairs, now, camera, motions);
    } else {
      images_.clear();
    }
  }
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Feature& feature = (*now.features)[i];
    if (!feature.has_depth()) continue;
    motions[i].position = now.T_still_camera * InCamera(feature, feature.depth_m, camera);
  }
  images_.push_back(std::move(now));
  return motions;
}

// Features of before that were found about where they are if they stand still, and then the others,
// where they may have gone.
void FeatureMotions::JudgeAll(const Image& then, const std::vector<Pair>& near, const Image& now,
                              const CameraModel& camera,
                              std::vector<FeatureMotion>& motions) const {
  std::vector<bool> is_found(then.features->size(), false), is_taken = now.moves;
  const auto judge = [&](const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) {
      const FeatureMotion motion = Judge(then, now, pair, camera);
      if (motion.verdict == FeatureMotion::Verdict::kUnknown) continue;
      motions[pair.now] = motion;
      is_found[pair.then] = is_taken[pair.now] = true;
    }
  };
  judge(near);
  std::vector<int> gone;
  for (std::size_t i = 0; i < is_found.size(); ++i) {
    if (!is_found[i]) gone.push_back(static_cast<int>(i));
  }
  judge(Match(then, now, gone, is_taken, options_.max_speed_mps, camera));
}

// Looks for the wanted features of the image before that have depth, as far away as what moves with
// that speed may be.
std::vector<FeatureMotions::Pair> FeatureMotions::Match(const Image& then, const Image& now,
                                                        const std::vector<int>& wanted,
                                                        const std::vector<bool>& is_taken,
                                                        double speed_mps,
                                                        const CameraModel& camera) const {
  const Rigid3d T_now_then = now.T_still_camera.inverse() * then.T_still_camera;
  const double way_px_m = camera.intrinsics().fx_px * speed_mps *
                          SecondsBetween(then.features->stamp(), now.features->stamp());
  std::vector<ProjectionCandidate> candidates;
  std::vector<int> candidate_of;
  for (const int i : wanted) {
    const Feature& feature = (*then.features)[i];
    if (!feature.has_depth()) continue;
    const Eigen::Vector3d p = T_now_then * InCamera(feature, feature.depth_m, camera);
    if (p.z() < kMinDepthM) continue;
    const double radius_px = kStillRadiusPx * scales_[feature.octave] + way_px_m / p.z();
    candidates.push_back({camera.Project(p).cast<float>(), static_cast<float>(radius_px),
                          feature.octave - 1, feature.octave + 1, feature.angle_rad,
                          &then.features->descriptor(i)});
    candidate_of.push_back(i);
  }
  ProjectionMatchingOptions matching;
  matching.max_distance = kMaxDistance;
  matching.max_ratio = kMaxRatio;
  const std::vector<int> matches = MatchByProjection(candidates, *now.features, is_taken, matching);
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (matches[k] >= 0) pairs.push_back({candidate_of[k], matches[k]});
  }
  return pairs;
}

// The camera's motion by vote. False if too few agree.
bool FeatureMotions::MoveCamera(const Image& then, const std::vector<Pair>& pairs, Image& now,
                                const CameraModel& camera) const {
  ImageCells<int> votes(camera);
  std::vector<PoseObservation> observations;
  for (const Pair& pair : pairs) {
    const Feature& feature = (*now.features)[pair.now];
    if (++votes.At(feature.pixel) > kMaxVotesPerCell) continue;
    const Feature& before = (*then.features)[pair.then];
    observations.push_back({then.T_still_camera * InCamera(before, before.depth_m, camera),
                            feature.pixel.cast<double>(), feature.depth_m,
                            scales_[feature.octave]});
  }
  const PoseEstimate estimate = OptimizePose(observations, now.T_still_camera, camera, noise_);
  if (estimate.inliers < kMinVotes ||
      estimate.inliers < options_.min_vote_share * static_cast<double>(observations.size())) {
    return false;
  }
  now.T_still_camera = estimate.T_map_camera;
  const Image& last = images_.back();
  const double seconds = SecondsBetween(last.features->stamp(), now.features->stamp());
  const Rigid3d T_last_camera = last.T_still_camera.inverse() * now.T_still_camera;
  now.turn_radps = RotationAngle(T_last_camera.linear()) / seconds;
  now.speed_mps = T_last_camera.translation().norm() / seconds;
  return true;
}

// How well is known where the feature is seen, with the camera moving as it does.
double FeatureMotions::SigmaPx(const Image& image, const Feature& feature,
                               const CameraModel& camera) const {
  const double moving_radps = feature.has_depth() ? image.speed_mps / feature.depth_m : 0.0;
  return std::hypot(
      noise_.PixelSigma(scales_[feature.octave]),
      camera.intrinsics().fx_px * (image.turn_radps + moving_radps) * options_.timing_sigma_s);
}

FeatureMotion FeatureMotions::Judge(const Image& then, const Image& now, const Pair& pair,
                                    const CameraModel& camera) const {
  const Feature& before = (*then.features)[pair.then];
  const Feature& feature = (*now.features)[pair.now];
  FeatureMotion motion;
  if (!feature.has_depth()) return motion;
  const double seconds = SecondsBetween(then.features->stamp(), now.features->stamp());
  const Rigid3d T_now_then = now.T_still_camera.inverse() * then.T_still_camera;
  const Eigen::Vector3d p = T_now_then * InCamera(before, before.depth_m, camera);

  const double focal_px = camera.intrinsics().fx_px, depth_m = feature.depth_m;
  const Eigen::Vector2d off_px = feature.pixel.cast<double>() - camera.Project(p);
  const double parallax_px =
      focal_px * noise_.InverseDepthSigma() * T_now_then.translation().norm();
  const double sigma_px =
      Eigen::Vector3d(SigmaPx(then, before, camera), SigmaPx(now, feature, camera), parallax_px)
          .norm();
  const double across = off_px.norm() / sigma_px;
  const double along =
      std::abs(1.0 / depth_m - 1.0 / p.z()) / (std::sqrt(2.0) * noise_.InverseDepthSigma());
  if (std::max(across, along) <= options_.deviation_sigmas) {
    motion.verdict = FeatureMotion::Verdict::kStill;
    return motion;
  }
  // Depth is rough: what it says of the way counts only where it says that there is one.
  const Eigen::Vector3d way_m(off_px.x() * depth_m / focal_px, off_px.y() * depth_m / focal_px,
                              along > options_.deviation_sigmas ? depth_m - p.z() : 0.0);
  const double speed_mps = way_m.norm() / seconds;
  if (speed_mps < options_.min_speed_mps || speed_mps > options_.max_speed_mps) return motion;
  motion.verdict = FeatureMotion::Verdict::kMoves;
  motion.velocity_mps = now.T_still_camera.linear() * way_m / seconds;
  return motion;
}

}  // namespace semantic_slam
