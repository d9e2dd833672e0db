#include "semantic_slam/tracking/moving_parts.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "semantic_slam/tracking/image_cells.h"

namespace semantic_slam {
namespace {

using Verdict = FeatureMotion::Verdict;

// Of a feature in the image, itself among them.
constexpr std::size_t kNeighbours = 9;
// Two features move alike if their velocities differ by less than this share of the greater one,
constexpr double kAlikeShare = 0.5;
// and what measuring them adds.
constexpr double kAlikeMps = 0.1;

bool MoveAlike(const FeatureMotion& a, const FeatureMotion& b) {
  const double greater = std::max(a.velocity_mps.norm(), b.velocity_mps.norm());
  return (a.velocity_mps - b.velocity_mps).norm() <= kAlikeShare * greater + kAlikeMps;
}

// Of the parts of the image that have features, those where most are marked.
double ImageShare(const FrameFeatures& features, const std::vector<bool>& marked,
                  const CameraModel& camera) {
  ImageCells<int> balance(camera);
  ImageCells<bool> has_features(camera);
  for (std::size_t i = 0; i < features.size(); ++i) {
    balance.At(features[i].pixel) += marked[i] ? 1 : -1;
    has_features.At(features[i].pixel) = true;
  }
  const auto is_left_out = [](int cell) { return cell > 0; };
  return static_cast<double>(std::count_if(balance.begin(), balance.end(), is_left_out)) /
         static_cast<double>(std::count(has_features.begin(), has_features.end(), true));
}

bool AreNear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius_m) {
  return (a - b).squaredNorm() <= radius_m * radius_m;
}

// How far around a feature, of the image's width.
constexpr float kAroundShare = 1.0f / 32.0f;

}  // namespace

MovingParts::MovingParts(const MovingPartsOptions& options,
                         const FeatureMotionOptions& motion_options, const ObservationNoise& noise,
                         std::vector<float> scales)
    : options_(Validated(options)), motions_(motion_options, noise, std::move(scales)) {}

void MovingParts::Reset() {
  motions_.Reset();
  places_.clear();
}

std::vector<bool> MovingParts::Find(std::shared_ptr<const FrameFeatures> features,
                                    const Rigid3d& T_last_camera, const std::vector<bool>& known,
                                    const CameraModel& camera) {
  if (!options_.enabled) return known;
  const Stamp now = features->stamp();
  const Motions motions = motions_.Follow(features, T_last_camera, camera);
  for (const auto& cluster : Clusters(AmongTheirKind(*features, motions), motions)) {
    if (static_cast<int>(cluster.size()) < options_.min_features) continue;
    Remember(cluster, motions, now);
  }
  const auto is_old = [&](const Place& place) {
    return SecondsBetween(place.seen, now) > options_.hold_s;
  };
  places_.erase(std::remove_if(places_.begin(), places_.end(), is_old), places_.end());
  std::vector<bool> moves = known, is_new(known.size(), false);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const FeatureMotion& motion = motions[i];
    if (known[i] || motion.verdict == Verdict::kStill || !motion.position) continue;
    moves[i] = is_new[i] = IsNearPlace(*motion.position, now);
  }
  if (ImageShare(*features, is_new, camera) > options_.max_image_share) {
    Reset();
    return known;
  }
  motions_.LeaveOut(moves);
  return moves;
}

// Features that move, with enough of their neighbours in the image.
std::vector<int> MovingParts::AmongTheirKind(const FrameFeatures& features,
                                             const Motions& motions) const {
  std::vector<int> known;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (motions[i].verdict != Verdict::kUnknown) known.push_back(static_cast<int>(i));
  }
  std::vector<int> found;
  std::vector<std::pair<float, bool>> neighbours;  // squared distance, moves
  for (const int i : known) {
    if (motions[i].verdict != Verdict::kMoves) continue;
    neighbours.clear();
    for (const int k : known) {
      neighbours.emplace_back((features[k].pixel - features[i].pixel).squaredNorm(),
                              motions[k].verdict == Verdict::kMoves);
    }
    const auto end = neighbours.begin() + std::min(kNeighbours, neighbours.size());
    std::partial_sort(neighbours.begin(), end, neighbours.end());
    const auto moving =
        std::count_if(neighbours.begin(), end, [](const auto& n) { return n.second; });
    if (static_cast<double>(moving) >= options_.min_moving_share * kNeighbours) found.push_back(i);
  }
  return found;
}

// Features put together from neighbour to neighbour that moves alike.
std::vector<std::vector<int>> MovingParts::Clusters(std::vector<int> left,
                                                    const Motions& motions) const {
  std::vector<std::vector<int>> clusters;
  while (!left.empty()) {
    std::vector<int> cluster{left.front()};
    left.erase(left.begin());
    for (std::size_t next = 0; next < cluster.size(); ++next) {
      const FeatureMotion& motion = motions[cluster[next]];
      const auto hangs_on = [&](int i) {
        return AreNear(*motions[i].position, *motion.position, options_.link_radius_m) &&
               MoveAlike(motions[i], motion);
      };
      const auto rest =
          std::stable_partition(left.begin(), left.end(), [&](int i) { return !hangs_on(i); });
      cluster.insert(cluster.end(), rest, left.end());
      left.erase(rest, left.end());
    }
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

void MovingParts::Remember(const std::vector<int>& cluster, const Motions& motions, Stamp now) {
  const bool is_sure = WasSeenBefore(cluster, motions, now);
  for (const int i : cluster) {
    places_.push_back({*motions[i].position, motions[i].velocity_mps, now, is_sure});
  }
}

// Whether something moved in the cluster's place in enough of the images before.
bool MovingParts::WasSeenBefore(const std::vector<int>& cluster, const Motions& motions,
                                Stamp now) const {
  std::set<Stamp> images{now};
  for (const Place& place : places_) {
    if (images.count(place.seen) > 0) continue;
    const Eigen::Vector3d position = place.At(now);
    const auto is_near = [&](int i) {
      return AreNear(*motions[i].position, position, options_.link_radius_m);
    };
    if (std::any_of(cluster.begin(), cluster.end(), is_near)) images.insert(place.seen);
  }
  return static_cast<int>(images.size()) >= options_.min_images;
}

bool MovingParts::IsNearPlace(const Eigen::Vector3d& position, Stamp now) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& place) {
    return place.is_sure && AreNear(position, place.At(now), options_.link_radius_m);
  });
}

void MarkWithoutDepth(const FrameFeatures& features, const CameraModel& camera,
                      std::vector<bool>& marked) {
  const float radius_px = kAroundShare * camera.undistorted_bounds().width;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (features[i].has_depth() || marked[i]) continue;
    int balance = 0;
    features.ForEachNear(features[i].pixel, radius_px, 0, std::numeric_limits<int>::max(),
                         [&](int k) {
                           if (features[k].has_depth()) balance += marked[k] ? 1 : -1;
                         });
    marked[i] = balance > 0;
  }
}

}  // namespace semantic_slam
