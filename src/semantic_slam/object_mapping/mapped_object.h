#pragma once

#include <vector>

#include "semantic_slam/object_mapping/label_evidence.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/object_mapping/object_geometry.h"
#include "semantic_slam/object_mapping/object_shape.h"

namespace semantic_slam {

// How many observations of one object are kept.
struct ObservationLimits {
  int all = 20;
  int per_keyframe = 3;  // views of one keyframe are much alike
};

// One object of the map: what was seen of it, hung on keyframes, and the shape that comes of it
// with the poses that these have today. Its memory is bounded. Not thread-safe.
class MappedObject {
 public:
  MappedObject(ObjectId id, int classes) : id_(id), labels_(classes) {}

  // Takes in what one image showed of it.
  void Add(const ObjectObservation& observation, const ObservationLimits& limits, Stamp stamp);
  void AddLabel(LabelId label, float confidence) { labels_.Add(label, confidence); }

  // Takes over all that `other` knows: it was this object.
  void Absorb(const MappedObject& other, const ObservationLimits& limits);

  // Works the shape out anew. It stays what it was if the observations make none.
  void Place(const KeyframePoseOf& keyframe_pose);

  ObjectId id() const { return id_; }
  const ObjectShape& shape() const { return shape_; }
  LabelId label() const { return labels_.Best(); }
  int images() const { return images_; }
  Stamp last_seen() const { return last_seen_; }
  const std::vector<ObjectObservation>& observations() const { return observations_; }

  MapObject Report(const LabelVocabulary& vocabulary, const HollownessOptions& hollowness) const;

 private:
  void Keep(const ObjectObservation& observation, const ObservationLimits& limits);

  ObjectId id_;
  LabelEvidence labels_;
  std::vector<ObjectObservation> observations_;  // the best first
  ObjectShape shape_;
  int images_ = 0;
  Stamp last_seen_;
};

}  // namespace semantic_slam
