#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/object_mapping/mapped_object.h"
#include "semantic_slam/object_tracking/object_tracks.h"

namespace semantic_slam {

struct ObjectAssociationOptions {
  double same_class_overlap = 0.25;  // of the smaller one's space: one object of a class
  double other_class_overlap = 0.4;  // of the space of both: one object that has two names
  double merge_overlap = 0.5;       // of the smaller one's space: two objects of a class become one
  double double_box_overlap = 0.7;  // of two boxes in one image that show one object
  double track_slack_m = 0.1;       // how far beyond touching an object may be from its track

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("same_class_overlap", self.same_class_overlap, 0.0, 1.0);
    visit("other_class_overlap", self.other_class_overlap, 0.0, 1.0);
    visit("merge_overlap", self.merge_overlap, 0.0, 1.0);
    visit("double_box_overlap", self.double_box_overlap, 0.0, 1.0);
    visit("track_slack_m", self.track_slack_m, 0.0, 10.0);
  }
};

// One object as one image shows it.
struct Sighting {
  struct Name {  // a box of it: a detector that wavers gives it two, of two tracks
    TrackId track;
    LabelId label;
    float confidence;
  };

  cv::Rect2f box;  // of the first name
  std::vector<Name> names;
  ObjectObservation observation;
  ObjectShape shape;  // of this observation alone
};

using TrackLinks = std::map<TrackId, ObjectId>;  // which object a track has shown so far

// Makes one of sightings whose boxes in the image nearly agree: the names of the one go to the
// other, which is the more confident.
void JoinDoubles(std::vector<Sighting>& sightings, const ObjectAssociationOptions& options);

// Which object each sighting shows: index into `objects`; nullopt for one that is new. No two
// sightings show one object. A sighting can show the object that its track has shown before, if
// that is near; one of the same class that it overlaps; or one of another class that it overlaps
// nearly all. Of all ways to pair them the one with greatest overlap.
std::vector<std::optional<std::size_t>> AssociateSightings(const std::vector<Sighting>& sightings,
                                                           const std::vector<MappedObject>& objects,
                                                           const TrackLinks& links,
                                                           const ObjectAssociationOptions& options);

// Whether two objects of the map are one.
bool AreOne(const MappedObject& a, const MappedObject& b, const ObjectAssociationOptions& options);

}  // namespace semantic_slam
