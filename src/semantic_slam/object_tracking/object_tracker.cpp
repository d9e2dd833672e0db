#include "semantic_slam/object_tracking/object_tracker.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "semantic_slam/common/assignment.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/common/option_groups.h"
#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {
namespace {

constexpr double kJumpBackS = 1.0;

std::string ToString(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

// Boxes may reach beyond the image, but what is more than one image away is no measurement.
cv::Rect2f Clipped(const cv::Rect2f& box, cv::Size image) {
  const auto width = static_cast<float>(image.width), height = static_cast<float>(image.height);
  return box & cv::Rect2f(-width, -height, 3.0f * width, 3.0f * height);
}

bool IsInView(const cv::Rect2f& box, cv::Size image) {
  return !(box & cv::Rect2f(cv::Rect(cv::Point(), image))).empty();
}

// Keeps of `items` those whose flag is not set.
template <typename T>
void EraseFlagged(std::vector<T>& items, const std::vector<char>& flagged) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (flagged[i]) continue;
    if (kept != i) items[kept] = std::move(items[i]);
    ++kept;
  }
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(kept), items.end());
}

}  // namespace

ObjectTracker::ObjectTracker(const ObjectTrackingOptions& options,
                             std::shared_ptr<const LabelVocabulary> vocabulary)
    : options_(ValidatedGroups(options)),
      vocabulary_(std::move(vocabulary)),
      camera_motion_(options.camera_motion) {}

void ObjectTracker::Reset() {
  tracks_.clear();
  camera_motion_.Update(cv::Mat());
  image_ = 0;
  stamp_.reset();
}

void ObjectTracker::Check(const Detections& detections, const cv::Mat& image) const {
  CheckDetections(detections, *vocabulary_);
  if (detections.image_size.width <= 0 || detections.image_size.height <= 0) {
    throw InputError("detections: image size is " + ToString(detections.image_size));
  }
  if (!image.empty() && image.size() != detections.image_size) {
    throw InputError("detections: made in an image of " + ToString(detections.image_size) +
                     ", but the image is " + ToString(image.size()));
  }
  if (!image.empty() && image.type() != CV_8UC1 && image.type() != CV_8UC3) {
    throw InputError("image is " + cv::typeToString(image.type()) +
                     ", expected CV_8UC1 or CV_8UC3");
  }
  if (stamp_ && detections.stamp <= *stamp_ &&
      SecondsBetween(detections.stamp, *stamp_) <= kJumpBackS) {
    throw InputError("detections: stamp " + semantic_slam::ToString(detections.stamp) +
                     " is not later than the last one, " + semantic_slam::ToString(*stamp_));
  }
}

ObjectTracks ObjectTracker::Update(const Detections& detections, const cv::Mat& image) {
  Check(detections, image);
  if (stamp_ && (detections.stamp < *stamp_ || detections.image_size != image_size_)) Reset();
  stamp_ = detections.stamp;
  image_size_ = detections.image_size;
  ++image_;
  EndOldTracks();
  Predict(image);
  Follow(detections);
  RemoveDuplicates();
  return Report(detections);
}

void ObjectTracker::Follow(const Detections& detections) {
  const ObjectTrackerOptions& limits = options_.tracker;
  constexpr double kMost = std::numeric_limits<double>::infinity();
  auto high = BoxesBetween(detections, limits.high_confidence, kMost);
  auto low = BoxesBetween(detections, limits.low_confidence, limits.high_confidence);
  Indices unmatched = TracksIn({TrackState::kConfirmed, TrackState::kLost});
  Indices tentative = TracksIn({TrackState::kTentative});
  Associate(unmatched, high, true, limits.first_max_cost);

  // Unsure boxes are good enough for what was in view a moment ago.
  const auto is_lost = [&](std::size_t i) { return tracks_[i].state == TrackState::kLost; };
  unmatched.erase(std::remove_if(unmatched.begin(), unmatched.end(), is_lost), unmatched.end());
  Associate(unmatched, low, false, limits.second_max_cost);
  for (const std::size_t i : unmatched) tracks_[i].state = TrackState::kLost;

  Associate(tentative, high, true, limits.tentative_max_cost);
  std::vector<char> ended(tracks_.size(), 0);
  for (const std::size_t i : tentative) ended[i] = 1;
  EraseFlagged(tracks_, ended);
  for (const DetectedBox& box : high) {
    if (box.confidence >= limits.new_confidence) Begin(box);
  }
}

std::vector<DetectedBox> ObjectTracker::BoxesBetween(const Detections& detections, double low,
                                                     double high) const {
  const std::size_t count =
      std::min<std::size_t>(detections.boxes.size(), options_.tracker.max_boxes);
  std::vector<DetectedBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    DetectedBox box = detections.boxes[i];
    if (!(box.confidence > low && box.confidence <= high)) continue;
    if (!IsInView(box.box, detections.image_size)) continue;
    box.box = Clipped(box.box, detections.image_size);
    boxes.push_back(box);
  }
  return boxes;
}

void ObjectTracker::EndOldTracks() {
  std::vector<char> ended;
  for (const Track& track : tracks_) {
    const int images_without = image_ - 1 - track.last_image;
    ended.push_back(images_without > options_.tracker.max_lost_images ||
                    SecondsBetween(track.last_seen, *stamp_) > options_.tracker.max_lost_s);
  }
  EraseFlagged(tracks_, ended);
}

// Tentative tracks were seen in the last image for the first time: they have no velocity yet.
void ObjectTracker::Predict(const cv::Mat& image) {
  for (Track& track : tracks_) {
    if (track.state == TrackState::kTentative) continue;
    track.filter.Predict(track.state == TrackState::kLost);
  }
  if (!options_.tracker.compensate_camera) return;
  const ImageMotion motion = camera_motion_.Update(image);
  for (Track& track : tracks_) track.filter.Warp(motion);
}

ObjectTracker::Indices ObjectTracker::TracksIn(std::initializer_list<TrackState> states) const {
  Indices indices;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (std::count(states.begin(), states.end(), tracks_[i].state) > 0) indices.push_back(i);
  }
  return indices;
}

void ObjectTracker::Associate(Indices& tracks, std::vector<DetectedBox>& boxes,
                              bool fuse_confidence, double max_cost) {
  Eigen::MatrixXd cost(tracks.size(), boxes.size());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Track& track = tracks_[tracks[i]];
    const cv::Rect2f predicted = track.filter.box();
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      const bool comparable =
          !options_.tracker.same_label_only || track.seen.label == boxes[j].label;
      const double iou = comparable ? IntersectionOverUnion(predicted, boxes[j].box) : 0.0;
      cost(i, j) = 1.0 - (fuse_confidence ? iou * boxes[j].confidence : iou);
    }
  }
  std::vector<char> track_paired(tracks.size(), 0), box_paired(boxes.size(), 0);
  for (const AssignedPair& pair : AssignAtLeastCost(cost, max_cost)) {
    Correct(tracks_[tracks[pair.row]], boxes[pair.column]);
    track_paired[pair.row] = box_paired[pair.column] = 1;
  }
  EraseFlagged(tracks, track_paired);
  EraseFlagged(boxes, box_paired);
}

void ObjectTracker::Correct(Track& track, const DetectedBox& box) {
  track.filter.Correct(box.box);
  track.seen = box;
  track.state = TrackState::kConfirmed;
  ++track.hits;
  track.last_image = image_;
  track.last_seen = *stamp_;
}

// In the first image every box is believed at once, later only when it is seen a second time.
void ObjectTracker::Begin(const DetectedBox& box) {
  const TrackState state = image_ == 1 ? TrackState::kConfirmed : TrackState::kTentative;
  tracks_.push_back({next_id_++, state, box, BoxFilter(box.box, options_.box_filter), 1, image_,
                     image_, *stamp_});
}

// A lost track that lies where one in view is was the same object: the one followed for less long
// goes.
void ObjectTracker::RemoveDuplicates() {
  std::vector<char> ended(tracks_.size(), 0);
  const auto followed_for = [](const Track& t) { return t.last_image - t.first_image; };
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    for (std::size_t j = 0; j < tracks_.size(); ++j) {
      const Track& in_view = tracks_[i];
      const Track& lost = tracks_[j];
      if (in_view.state == TrackState::kLost || lost.state != TrackState::kLost) continue;
      if (options_.tracker.same_label_only && in_view.seen.label != lost.seen.label) continue;
      const double iou = IntersectionOverUnion(in_view.filter.box(), lost.filter.box());
      if (1.0 - iou >= options_.tracker.duplicate_max_distance) continue;
      ended[followed_for(in_view) > followed_for(lost) ? j : i] = 1;
    }
  }
  EraseFlagged(tracks_, ended);
}

ObjectTracks ObjectTracker::Report(const Detections& detections) const {
  ObjectTracks report{detections.stamp, detections.vocabulary_hash, detections.image_size, {}};
  for (const Track& track : tracks_) {
    ObjectTrack entry;
    entry.id = track.id;
    entry.state = track.state;
    entry.detection = track.seen;
    entry.detection.box = track.filter.box();
    entry.hits = track.hits;
    entry.since_seen_s = SecondsBetween(track.last_seen, detections.stamp);
    report.tracks.push_back(entry);
  }
  return report;
}

}  // namespace semantic_slam
