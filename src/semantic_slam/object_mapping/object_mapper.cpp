#include "semantic_slam/object_mapping/object_mapper.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam/common/option_groups.h"
#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {
namespace {

constexpr double kJumpBackS = 1.0;
constexpr std::size_t kMaxUnlistedPoses = 100;  // more, and it is worth looking which are in use

void CheckTracks(const ObjectTracks& tracks, const LabelVocabulary& vocabulary) {
  Detections detections{tracks.stamp, tracks.vocabulary_hash, tracks.image_size, {}};
  for (const ObjectTrack& track : tracks.tracks) detections.boxes.push_back(track.detection);
  CheckDetections(detections, vocabulary);
}

}  // namespace

ObjectMapper::ObjectMapper(const ObjectMappingOptions& options,
                           std::shared_ptr<const LabelVocabulary> vocabulary)
    : options_(ValidatedGroups(options)),
      vocabulary_(std::move(vocabulary)),
      ignored_(FindLabels("ignored_classes", options.mapper.ignored_classes, *vocabulary_)) {}

void ObjectMapper::Reset() {
  objects_.clear();
  aside_.clear();
  links_.clear();
  unlisted_poses_.clear();
}

void ObjectMapper::BeginMap(int map_id) {
  if (map_id_ == map_id) return;
  for (MappedObject& object : objects_) {
    if (object.images() >= options_.mapper.min_observations) aside_.push_back(std::move(object));
  }
  const auto too_many = static_cast<std::ptrdiff_t>(aside_.size()) - options_.mapper.max_objects;
  if (too_many > 0) aside_.erase(aside_.begin(), aside_.begin() + too_many);
  objects_.clear();
  links_.clear();
  unlisted_poses_.clear();
  poses_ = KeyframePoses();
  map_id_ = map_id;
}

// Objects of a map that tracking has found again.
void ObjectMapper::TakeBackListed() {
  const auto first =
      std::stable_partition(aside_.begin(), aside_.end(), [this](const MappedObject& object) {
        const auto& seen = object.observations();
        return !std::all_of(seen.begin(), seen.end(), [this](const ObjectObservation& observation) {
          return poses_.Find(observation.keyframe_id).has_value();
        });
      });
  std::move(first, aside_.end(), std::back_inserter(objects_));
  aside_.erase(first, aside_.end());
  std::sort(objects_.begin(), objects_.end(),
            [](const MappedObject& a, const MappedObject& b) { return a.id() < b.id(); });
}

void ObjectMapper::Check(const ObjectTracks& tracks, const RgbdImage& image,
                         const CameraModel& camera, const TrackedImage& tracked) const {
  CheckRgbdImage(image, camera);
  CheckTracks(tracks, *vocabulary_);
  if (tracks.stamp != image.stamp || tracked.stamp != image.stamp) {
    throw InputError("objects: tracks of " + ToString(tracks.stamp) + ", pose of " +
                     ToString(tracked.stamp) + ", but image of " + ToString(image.stamp));
  }
  if (tracks.image_size != image.depth_m.size()) {
    throw InputError("objects: tracks are of another image size than the image");
  }
  if (tracked.status != TrackingStatus::kTracking || tracked.keyframe_id == kNoKeyframe ||
      !IsFinite(tracked.T_keyframe_camera) || !IsFinite(tracked.T_map_camera)) {
    throw InputError("objects: the image of " + ToString(image.stamp) + " has no pose");
  }
  if (map_id_ && tracked.map_id < *map_id_) {
    throw InputError("objects: the image is of map " + std::to_string(tracked.map_id) +
                     ", but map " + std::to_string(*map_id_) + " has begun");
  }
  if (stamp_ && image.stamp <= *stamp_ && SecondsBetween(image.stamp, *stamp_) <= kJumpBackS) {
    throw InputError("objects: stamp " + ToString(image.stamp) +
                     " is not later than the last one, " + ToString(*stamp_));
  }
}

void ObjectMapper::Observe(const ObjectTracks& tracks, const RgbdImage& image,
                           const CameraModel& camera, const TrackedImage& tracked) {
  Check(tracks, image, camera, tracked);
  BeginMap(tracked.map_id);
  stamp_ = image.stamp;
  if (!poses_.Find(tracked.keyframe_id)) {
    unlisted_poses_[tracked.keyframe_id] =
        tracked.T_map_camera * tracked.T_keyframe_camera.inverse();
  }
  std::vector<Sighting> sightings = Look(tracks, image, camera, tracked);
  JoinDoubles(sightings, options_.association);
  const auto shown = AssociateSightings(sightings, objects_, links_, options_.association);
  const auto classes = static_cast<int>(vocabulary_->classes().size());
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    if (!shown[i]) objects_.emplace_back(next_id_++, classes);
    TakeIn(sightings[i], shown[i] ? objects_[*shown[i]] : objects_.back(), image.stamp);
  }
  ForgetLinks(tracks);
  if (!sightings.empty()) MergeDuplicates();
  ForgetCandidates(image.stamp);
  if (unlisted_poses_.size() > kMaxUnlistedPoses) ForgetUnusedPoses();
}

std::vector<Sighting> ObjectMapper::Look(const ObjectTracks& tracks, const RgbdImage& image,
                                         const CameraModel& camera,
                                         const TrackedImage& tracked) const {
  std::vector<Sighting> sightings;
  const Eigen::Matrix3d R_map_camera = tracked.T_map_camera.linear();
  for (const ObjectTrack& track : tracks.tracks) {
    const DetectedBox& seen = track.detection;
    if (track.state != TrackState::kConfirmed) continue;
    if (std::count(ignored_.begin(), ignored_.end(), seen.label) > 0) continue;
    const auto points = ExtractObjectPoints(seen.box, image, camera, options_.points);
    if (!points) continue;
    auto observation =
        MeasureObject(*points, R_map_camera, tracked.keyframe_id, tracked.T_keyframe_camera,
                      options_.top_plane, options_.hollowness);
    if (!observation) continue;
    auto shape =
        FuseObservations({*observation}, [this](KeyframeId id) { return KeyframePose(id); });
    if (!shape) continue;
    sightings.push_back({seen.box,
                         {{track.id, seen.label, seen.confidence}},
                         std::move(*observation),
                         std::move(*shape)});
  }
  return sightings;
}

void ObjectMapper::TakeIn(const Sighting& sighting, MappedObject& object, Stamp stamp) {
  object.Add(sighting.observation, Limits(), stamp);
  for (const Sighting::Name& name : sighting.names) {
    object.AddLabel(name.label, name.confidence);
    links_[name.track] = object.id();
  }
  object.Place([this](KeyframeId id) { return KeyframePose(id); });
}

Rigid3d ObjectMapper::KeyframePose(KeyframeId id) const {
  if (const auto listed = poses_.Find(id)) return *listed;
  return unlisted_poses_.at(id);
}

// Tracks that have ended never come back.
void ObjectMapper::ForgetLinks(const ObjectTracks& tracks) {
  std::set<TrackId> alive;
  for (const ObjectTrack& track : tracks.tracks) alive.insert(track.id);
  for (auto link = links_.begin(); link != links_.end();) {
    link = alive.count(link->first) > 0 ? std::next(link) : links_.erase(link);
  }
}

void ObjectMapper::MergeDuplicates() {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    for (std::size_t j = i + 1; j < objects_.size();) {
      if (!AreOne(objects_[i], objects_[j], options_.association)) {
        ++j;
        continue;
      }
      for (auto& [track, object] : links_) {
        if (object == objects_[j].id()) object = objects_[i].id();
      }
      objects_[i].Absorb(objects_[j], Limits());
      objects_.erase(objects_.begin() + static_cast<std::ptrdiff_t>(j));
      objects_[i].Place([this](KeyframeId id) { return KeyframePose(id); });
      j = i + 1;  // it has grown, so it may now be one with others too
    }
  }
}

void ObjectMapper::ForgetCandidates(Stamp now) {
  const auto is_stale = [&](const MappedObject& object) {
    return object.images() < options_.mapper.min_observations &&
           SecondsBetween(object.last_seen(), now) > options_.mapper.max_candidate_age_s;
  };
  objects_.erase(std::remove_if(objects_.begin(), objects_.end(), is_stale), objects_.end());
  while (objects_.size() > static_cast<std::size_t>(options_.mapper.max_objects)) {
    objects_.erase(std::min_element(objects_.begin(), objects_.end(),
                                    [](const MappedObject& a, const MappedObject& b) {
                                      if (a.images() != b.images()) return a.images() < b.images();
                                      return a.last_seen() < b.last_seen();
                                    }));
  }
}

void ObjectMapper::ForgetUnusedPoses() {
  std::map<KeyframeId, Rigid3d> used;
  for (const MappedObject& object : objects_) {
    for (const ObjectObservation& observation : object.observations()) {
      const auto pose = unlisted_poses_.find(observation.keyframe_id);
      if (pose != unlisted_poses_.end()) used.insert(*pose);
    }
  }
  unlisted_poses_.swap(used);
}

void ObjectMapper::FollowGraph(const KeyframeGraph& graph) {
  if (map_id_ && graph.map_id < *map_id_) return;
  if (map_id_ == graph.map_id && graph.revision < poses_.revision()) return;
  BeginMap(graph.map_id);
  if (ForgetsLostMaps(graph.reason)) aside_.clear();
  KeyframePoses listed(graph);
  // What is not listed, as it should be, stays where it was.
  for (const MappedObject& object : objects_) {
    for (const ObjectObservation& observation : object.observations()) {
      const KeyframeId id = observation.keyframe_id;
      if (!listed.Find(id)) unlisted_poses_.try_emplace(id, KeyframePose(id));
    }
  }
  poses_ = std::move(listed);
  for (auto pose = unlisted_poses_.begin(); pose != unlisted_poses_.end();) {
    pose = poses_.Find(pose->first) ? unlisted_poses_.erase(pose) : std::next(pose);
  }
  TakeBackListed();
  for (MappedObject& object : objects_) {
    object.Place([this](KeyframeId id) { return KeyframePose(id); });
  }
  MergeDuplicates();
}

ObservationLimits ObjectMapper::Limits() const {
  return {options_.mapper.max_observations, options_.mapper.max_per_keyframe};
}

ObjectMap ObjectMapper::Objects() const {
  ObjectMap map;
  map.stamp = stamp_.value_or(Stamp{});
  map.map_id = map_id_.value_or(0);
  map.revision = poses_.revision();
  map.vocabulary_hash = vocabulary_->hash();
  for (const MappedObject& object : objects_) {
    if (object.images() < options_.mapper.min_observations) continue;
    map.objects.push_back(object.Report(*vocabulary_, options_.hollowness));
  }
  return map;
}

}  // namespace semantic_slam
