#include "semantic_slam/object_mapping/mapped_object.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace semantic_slam {
namespace {

bool IsBetter(const ObjectObservation& a, const ObjectObservation& b) {
  return a.complete != b.complete ? a.complete : a.quality > b.quality;
}

}  // namespace

void MappedObject::Add(const ObjectObservation& observation, const ObservationLimits& limits,
                       Stamp stamp) {
  Keep(observation, limits);
  ++images_;
  last_seen_ = std::max(last_seen_, stamp);
}

void MappedObject::Absorb(const MappedObject& other, const ObservationLimits& limits) {
  for (const ObjectObservation& observation : other.observations_) Keep(observation, limits);
  labels_.Add(other.labels_);
  images_ += other.images_;
  last_seen_ = std::max(last_seen_, other.last_seen_);
}

void MappedObject::Keep(const ObjectObservation& observation, const ObservationLimits& limits) {
  observations_.insert(
      std::upper_bound(observations_.begin(), observations_.end(), observation, IsBetter),
      observation);
  const auto of_keyframe = [&](const ObjectObservation& o) {
    return o.keyframe_id == observation.keyframe_id;
  };
  if (std::count_if(observations_.begin(), observations_.end(), of_keyframe) >
      limits.per_keyframe) {
    const auto worst = std::find_if(observations_.rbegin(), observations_.rend(), of_keyframe);
    observations_.erase(std::next(worst).base());
  }
  if (observations_.size() > static_cast<std::size_t>(limits.all)) observations_.pop_back();
}

void MappedObject::Place(const KeyframePoseOf& keyframe_pose) {
  if (auto shape = FuseObservations(observations_, keyframe_pose)) shape_ = std::move(*shape);
}

MapObject MappedObject::Report(const LabelVocabulary& vocabulary,
                               const HollownessOptions& hollowness) const {
  MapObject object;
  object.id = id_;
  object.labels = labels_.Probabilities();
  object.position_m = shape_.position_m;
  object.position_covariance_m2 = shape_.covariance_m2;
  const double height_m = shape_.max_height_m - shape_.min_height_m;
  const Eigen::Vector2d centre = shape_.box.centre;
  object.T_map_box =
      Eigen::Translation3d(centre.x(), centre.y(), shape_.min_height_m + 0.5 * height_m) *
      Eigen::AngleAxisd(shape_.box.yaw_rad, Eigen::Vector3d::UnitZ());
  object.box_size_m = {shape_.box.size.x(), shape_.box.size.y(), height_m};
  object.min_height_m = shape_.min_height_m;
  object.max_height_m = shape_.max_height_m;
  object.hollow = JudgeHollowness(shape_.below, vocabulary[label()].hollow, hollowness);
  object.footprint_m = shape_.outline_m;
  object.observations = images_;
  object.last_seen = last_seen_;
  return object;
}

}  // namespace semantic_slam
