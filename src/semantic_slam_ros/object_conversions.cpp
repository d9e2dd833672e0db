#include "semantic_slam_ros/object_conversions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

using semantic_slam::DetectedBox;
using semantic_slam::Detections;
using semantic_slam::Hollowness;
using semantic_slam::InputError;
using semantic_slam::LabelProbability;
using semantic_slam::LabelVocabulary;
using semantic_slam::MapObject;
using semantic_slam::ObjectMap;
using semantic_slam::ObjectTrack;
using semantic_slam::ObjectTracks;
using semantic_slam::TrackState;
using DetectionMsg = semantic_slam::Detection;
using ObjectMsg = semantic_slam::SemanticObject;
using TrackMsg = semantic_slam::TrackedObject;

// The enumerations are the same on both sides, so a cast converts them.
static_assert(TrackMsg::STATE_TENTATIVE == static_cast<std::uint8_t>(TrackState::kTentative));
static_assert(TrackMsg::STATE_CONFIRMED == static_cast<std::uint8_t>(TrackState::kConfirmed));
static_assert(TrackMsg::STATE_LOST == static_cast<std::uint8_t>(TrackState::kLost));
static_assert(ObjectMsg::HOLLOW_NO == static_cast<std::uint8_t>(Hollowness::kNo));
static_assert(ObjectMsg::HOLLOW_PARTLY == static_cast<std::uint8_t>(Hollowness::kPartly));
static_assert(ObjectMsg::HOLLOW_FULL == static_cast<std::uint8_t>(Hollowness::kFull));

namespace {

constexpr std::uint32_t kMaxSidePx = 16384;
constexpr std::uint32_t kMaxInt = std::numeric_limits<int>::max();

DetectionMsg ToDetection(const DetectedBox& found) {
  DetectionMsg msg;
  msg.label = found.label;
  msg.confidence = found.confidence;
  msg.x_min = found.box.x;
  msg.y_min = found.box.y;
  msg.x_max = found.box.x + found.box.width;
  msg.y_max = found.box.y + found.box.height;
  return msg;
}

DetectedBox ToDetectedBox(const DetectionMsg& msg) {
  return {msg.label, msg.confidence,
          cv::Rect2f(msg.x_min, msg.y_min, msg.x_max - msg.x_min, msg.y_max - msg.y_min)};
}

cv::Size ToSize(std::uint32_t width, std::uint32_t height, const char* who) {
  if (width == 0 || height == 0 || width > kMaxSidePx || height > kMaxSidePx) {
    throw InputError(std::string(who) + ": image size is " + std::to_string(width) + " x " +
                     std::to_string(height));
  }
  return {static_cast<int>(width), static_cast<int>(height)};
}

TrackMsg ToTrackedObject(const ObjectTrack& track) {
  TrackMsg msg;
  msg.id = track.id;
  msg.state = static_cast<std::uint8_t>(track.state);
  msg.detection = ToDetection(track.detection);
  msg.hits = static_cast<std::uint32_t>(track.hits);
  msg.since_seen = ros::Duration(track.since_seen_s);
  return msg;
}

ObjectTrack ToObjectTrack(const TrackMsg& msg) {
  if (msg.state > TrackMsg::STATE_LOST) {
    throw InputError("tracked objects: state is " + std::to_string(msg.state) +
                     ", expected 0 to 2");
  }
  ObjectTrack track;
  track.id = msg.id;
  track.state = static_cast<TrackState>(msg.state);
  track.detection = ToDetectedBox(msg.detection);
  track.hits = static_cast<int>(std::min(msg.hits, kMaxInt));
  track.since_seen_s = msg.since_seen.toSec();
  return track;
}

// `items` have ids.
template <typename Items>
void CheckIdsAscend(const Items& items, const char* who) {
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (items[i - 1].id < items[i].id) continue;
    throw InputError(std::string(who) + ": id " + std::to_string(items[i].id) + " follows " +
                     std::to_string(items[i - 1].id) + ", expected ascending ids");
  }
}

template <typename XYZ>
void SetXyz(const Eigen::Vector3d& v, XYZ& msg) {
  msg.x = v.x(), msg.y = v.y(), msg.z = v.z();
}

std::vector<LabelProbability> ReadLabels(const ObjectMsg& msg, const LabelVocabulary& vocabulary) {
  constexpr float kRounding = 1e-3f;
  if (msg.labels.size() != msg.probabilities.size()) {
    throw InputError("has " + std::to_string(msg.labels.size()) + " labels and " +
                     std::to_string(msg.probabilities.size()) + " probabilities");
  }
  std::vector<LabelProbability> labels;
  float sum = 0.0f, last = 1.0f + kRounding;
  for (std::size_t i = 0; i < msg.labels.size(); ++i) {
    const float p = msg.probabilities[i];
    semantic_slam::CheckLabel("labels", msg.labels[i], vocabulary);
    if (!(p >= 0.0f && p <= last)) {
      throw InputError("probability is " + std::to_string(p) +
                       ", expected 0 to 1 in descending order");
    }
    labels.push_back({msg.labels[i], p});
    sum += p;
    last = p;
  }
  if (sum > 1.0f + kRounding) {
    throw InputError("probabilities sum up to " + std::to_string(sum) + ", expected at most 1");
  }
  return labels;
}

template <typename XYZ>
Eigen::Vector3d ReadVector(const XYZ& msg, const char* what) {
  const Eigen::Vector3d v(msg.x, msg.y, msg.z);
  if (!v.allFinite()) throw InputError(std::string(what) + " is not finite");
  return v;
}

Eigen::Matrix3d ReadCovariance(const ObjectMsg& msg) {
  const Eigen::Matrix3d covariance = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
      msg.position_covariance.data());
  if (!covariance.allFinite() || !(covariance.diagonal().array() >= 0.0).all()) {
    throw InputError("position_covariance is not finite or has a negative variance");
  }
  return covariance;
}

std::vector<Eigen::Vector2d> ReadFootprint(const ObjectMsg& msg) {
  std::vector<Eigen::Vector2d> footprint;
  for (const auto& point : msg.footprint.points) {
    footprint.emplace_back(point.x, point.y);
    if (!footprint.back().allFinite()) throw InputError("footprint is not finite");
  }
  return footprint;
}

MapObject ToMapObject(const ObjectMsg& msg, const LabelVocabulary& vocabulary) try {
  MapObject object;
  object.id = msg.id;
  object.labels = ReadLabels(msg, vocabulary);
  object.position_m = ReadVector(msg.position, "position");
  object.position_covariance_m2 = ReadCovariance(msg);
  object.T_map_box = ToRigid(msg.box_pose);
  object.box_size_m = ReadVector(msg.box_size, "box_size");
  if (object.box_size_m.minCoeff() < 0.0) throw InputError("box_size is negative");
  if (!std::isfinite(msg.min_height) || !std::isfinite(msg.max_height) ||
      msg.min_height > msg.max_height) {
    throw InputError("heights are " + std::to_string(msg.min_height) + " to " +
                     std::to_string(msg.max_height));
  }
  object.min_height_m = msg.min_height;
  object.max_height_m = msg.max_height;
  if (msg.hollow > ObjectMsg::HOLLOW_FULL) {
    throw InputError("hollow is " + std::to_string(msg.hollow) + ", expected 0 to 2");
  }
  object.hollow = static_cast<Hollowness>(msg.hollow);
  object.footprint_m = ReadFootprint(msg);
  object.observations = static_cast<int>(std::min(msg.observations, kMaxInt));
  object.last_seen = ToStamp(msg.last_seen);
  return object;
} catch (const InputError& e) {
  throw InputError("objects: object " + std::to_string(msg.id) + ": " + e.what());
}

}  // namespace

semantic_slam::DetectionArray ToDetectionArray(const Detections& detections,
                                               const std::string& frame_id) {
  semantic_slam::DetectionArray msg;
  msg.header = MakeHeader(detections.stamp, frame_id);
  msg.label_set_hash = detections.vocabulary_hash;
  msg.width = static_cast<std::uint32_t>(detections.image_size.width);
  msg.height = static_cast<std::uint32_t>(detections.image_size.height);
  msg.detections.reserve(detections.boxes.size());
  for (const DetectedBox& found : detections.boxes) msg.detections.push_back(ToDetection(found));
  return msg;
}

Detections ToDetections(const semantic_slam::DetectionArray& msg,
                        const LabelVocabulary& vocabulary) {
  Detections detections;
  detections.stamp = ToStamp(msg.header.stamp);
  detections.vocabulary_hash = msg.label_set_hash;
  detections.image_size = ToSize(msg.width, msg.height, "detections");
  detections.boxes.reserve(msg.detections.size());
  for (const DetectionMsg& found : msg.detections) {
    detections.boxes.push_back(ToDetectedBox(found));
  }
  semantic_slam::CheckDetections(detections, vocabulary);
  const auto descends = [](const DetectedBox& a, const DetectedBox& b) {
    return a.confidence > b.confidence;
  };
  if (!std::is_sorted(detections.boxes.begin(), detections.boxes.end(), descends)) {
    throw InputError("detections: confidences do not descend");
  }
  return detections;
}

semantic_slam::TrackedObjectArray ToTrackedObjectArray(const ObjectTracks& tracks,
                                                       const std::string& frame_id) {
  semantic_slam::TrackedObjectArray msg;
  msg.header = MakeHeader(tracks.stamp, frame_id);
  msg.label_set_hash = tracks.vocabulary_hash;
  msg.width = static_cast<std::uint32_t>(tracks.image_size.width);
  msg.height = static_cast<std::uint32_t>(tracks.image_size.height);
  msg.objects.reserve(tracks.tracks.size());
  for (const ObjectTrack& track : tracks.tracks) msg.objects.push_back(ToTrackedObject(track));
  return msg;
}

ObjectTracks ToObjectTracks(const semantic_slam::TrackedObjectArray& msg,
                            const LabelVocabulary& vocabulary) {
  ObjectTracks tracks;
  tracks.stamp = ToStamp(msg.header.stamp);
  tracks.vocabulary_hash = msg.label_set_hash;
  tracks.image_size = ToSize(msg.width, msg.height, "tracked objects");
  Detections boxes{tracks.stamp, tracks.vocabulary_hash, tracks.image_size, {}};
  for (const TrackMsg& object : msg.objects) {
    tracks.tracks.push_back(ToObjectTrack(object));
    boxes.boxes.push_back(tracks.tracks.back().detection);
  }
  semantic_slam::CheckDetections(boxes, vocabulary);
  CheckIdsAscend(tracks.tracks, "tracked objects");
  return tracks;
}

ObjectMsg ToSemanticObject(const MapObject& object) {
  ObjectMsg msg;
  msg.id = object.id;
  for (const LabelProbability& label : object.labels) {
    msg.labels.push_back(label.label);
    msg.probabilities.push_back(label.probability);
  }
  SetXyz(object.position_m, msg.position);
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(msg.position_covariance.data()) =
      object.position_covariance_m2;
  msg.box_pose = ToPose(object.T_map_box);
  SetXyz(object.box_size_m, msg.box_size);
  msg.min_height = static_cast<float>(object.min_height_m);
  msg.max_height = static_cast<float>(object.max_height_m);
  msg.hollow = static_cast<std::uint8_t>(object.hollow);
  for (const Eigen::Vector2d& corner : object.footprint_m) {
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(corner.x()), point.y = static_cast<float>(corner.y());
    msg.footprint.points.push_back(point);
  }
  msg.observations = static_cast<std::uint32_t>(object.observations);
  msg.last_seen = ToRos(object.last_seen);
  return msg;
}

semantic_slam::SemanticObjectArray ToSemanticObjectArray(const ObjectMap& map,
                                                         const std::string& map_frame) {
  semantic_slam::SemanticObjectArray msg;
  msg.header = MakeHeader(map.stamp, map_frame);
  msg.map_id = map.map_id;
  msg.revision = map.revision;
  msg.label_set_hash = map.vocabulary_hash;
  msg.objects.reserve(map.objects.size());
  for (const MapObject& object : map.objects) msg.objects.push_back(ToSemanticObject(object));
  return msg;
}

ObjectMap ToObjectMap(const semantic_slam::SemanticObjectArray& msg,
                      const LabelVocabulary& vocabulary) {
  semantic_slam::CheckLabelSet("objects", msg.label_set_hash, vocabulary);
  ObjectMap map;
  map.stamp = ToStamp(msg.header.stamp);
  map.map_id = msg.map_id;
  map.revision = msg.revision;
  map.vocabulary_hash = msg.label_set_hash;
  map.objects.reserve(msg.objects.size());
  for (const ObjectMsg& object : msg.objects) {
    map.objects.push_back(ToMapObject(object, vocabulary));
  }
  CheckIdsAscend(map.objects, "objects");
  return map;
}

}  // namespace semantic_slam_ros
