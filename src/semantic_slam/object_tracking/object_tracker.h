#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_tracking/box_filter.h"
#include "semantic_slam/object_tracking/camera_motion.h"
#include "semantic_slam/object_tracking/object_tracks.h"

namespace semantic_slam {

// The thresholds are those of the BoT-SORT paper, but for the confidences: 0.6, 0.1 and 0.7 suit
// detectors of pedestrians, ones of eighty classes are less sure of each. "IoU" is the intersection
// over union of a track's predicted box and a detected one.
struct ObjectTrackerOptions {
  double high_confidence = 0.4;          // boxes above take part in the first association
  double low_confidence = 0.1;           // boxes above, in the second; the others are not looked at
  double new_confidence = 0.5;           // a box needs this to begin a track
  double first_max_cost = 0.8;           // 1 - IoU * confidence of a pair, in the first association
  double second_max_cost = 0.5;          // 1 - IoU of a pair, in the second association
  double tentative_max_cost = 0.7;       // 1 - IoU * confidence of a pair with a tentative track
  double duplicate_max_distance = 0.15;  // 1 - IoU of two tracks that are one
  int max_lost_images = 30;              // after so many without a box a track ends
  double max_lost_s = 3.0;               // the same in time, for detectors that are slow or pause
  bool same_label_only = true;           // pair boxes with tracks of their own class only
  bool compensate_camera = true;         // warp the tracks when the camera moves
  int max_boxes = 300;                   // looked at per image, the most confident ones

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("high_confidence", self.high_confidence, 0.0, 1.0);
    visit("low_confidence", self.low_confidence, 0.0, self.high_confidence);
    visit("new_confidence", self.new_confidence, 0.0, 1.0);
    visit("first_max_cost", self.first_max_cost, 0.0, 1.0);
    visit("second_max_cost", self.second_max_cost, 0.0, 1.0);
    visit("tentative_max_cost", self.tentative_max_cost, 0.0, 1.0);
    visit("duplicate_max_distance", self.duplicate_max_distance, 0.0, 1.0);
    visit("max_lost_images", self.max_lost_images, 0, 10000);
    visit("max_lost_s", self.max_lost_s, 0.0, 3600.0);
    visit("same_label_only", self.same_label_only);
    visit("compensate_camera", self.compensate_camera);
    visit("max_boxes", self.max_boxes, 1, 10000);
  }
};

// The options of object tracking, in the groups that configuration files use.
struct ObjectTrackingOptions {
  ObjectTrackerOptions tracker;
  BoxFilterOptions box_filter;
  CameraMotionOptions camera_motion;

  // Calls visit_group(name, group) for each.
  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("tracker", self.tracker);
    visit_group("box_filter", self.box_filter);
    visit_group("camera_motion", self.camera_motion);
  }
};

// Gives detected objects ids that hold from image to image: BoT-SORT (Aharon, Orfaig, Bobrovsky,
// 2022) without appearance; thesis section 3.4.1.
//
// Boxes are paired with tracks of the same class only, by default: indoors boxes of different
// classes lie within each other all the time (a keyboard before a monitor, a cup on a table) and
// BoT-SORT, made for pedestrians alone, would swap them. A detector that wavers between two classes
// makes two tracks of one object, which the object map joins again.
//
// Not thread-safe.
class ObjectTracker {
 public:
  // Throws ConfigError if an option is out of range.
  ObjectTracker(const ObjectTrackingOptions& options,
                std::shared_ptr<const LabelVocabulary> vocabulary);

  // Takes in what was found in the next image and returns what is followed now, tentative and lost
  // tracks too.
  //
  //   image  the colour or grey image (CV_8UC3, CV_8UC1) that was searched, for the camera's
  //   motion;
  //          may be empty: then the camera is taken to stand still
  //
  // Throws InputError, and leaves the tracks alone, if CheckDetections() does, if the image is of
  // another size or type, or not later than the one before. Over a second back in time, and with
  // images of another size, all tracks end and new ones begin; ids go on.
  ObjectTracks Update(const Detections& detections, const cv::Mat& image);

  // Ends all tracks; ids go on.
  void Reset();

 private:
  struct Track {
    TrackId id;
    TrackState state;
    DetectedBox seen;  // as detected last
    BoxFilter filter;
    int hits;
    int first_image;
    int last_image;  // that it was seen in
    Stamp last_seen;
  };
  using Indices = std::vector<std::size_t>;  // into tracks_

  void Check(const Detections& detections, const cv::Mat& image) const;
  std::vector<DetectedBox> BoxesBetween(const Detections& detections, double low,
                                        double high) const;
  void EndOldTracks();
  void Predict(const cv::Mat& image);

  // The three associations; tracks without a box become lost or end, boxes without a track begin
  // one.
  void Follow(const Detections& detections);
  Indices TracksIn(std::initializer_list<TrackState> states) const;

  // Pairs `tracks` with `boxes`, corrects the tracks that got one, and leaves in both lists what is
  // without partner.
  void Associate(Indices& tracks, std::vector<DetectedBox>& boxes, bool fuse_confidence,
                 double max_cost);
  void Correct(Track& track, const DetectedBox& box);
  void Begin(const DetectedBox& box);
  void RemoveDuplicates();
  ObjectTracks Report(const Detections& detections) const;

  const ObjectTrackingOptions options_;
  const std::shared_ptr<const LabelVocabulary> vocabulary_;
  CameraMotion camera_motion_;
  std::vector<Track> tracks_;  // by ascending id
  TrackId next_id_ = 1;
  int image_ = 0;  // counts images since the last reset
  std::optional<Stamp> stamp_;
  cv::Size image_size_;
};

}  // namespace semantic_slam
