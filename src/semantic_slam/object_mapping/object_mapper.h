#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/keyframe_poses.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/object_mapping/mapped_object.h"
#include "semantic_slam/object_mapping/object_association.h"
#include "semantic_slam/object_mapping/object_points.h"
#include "semantic_slam/object_tracking/object_tracks.h"
#include "semantic_slam/plane_projection/hollowness.h"
#include "semantic_slam/plane_projection/top_plane.h"

namespace semantic_slam {

struct ObjectMapperOptions {
  // Classes that are never mapped, separated by commas. By default what moves by itself: where
  // somebody stood a minute ago says nothing of now, and the floor plan shows who stands there
  // today.
  std::string ignored_classes = "unknown,person,animal";
  int min_observations = 3;           // images that must show an object before it is reported
  int max_observations = 20;          // kept per object, the best ones
  int max_per_keyframe = 3;           // of those
  double max_candidate_age_s = 10.0;  // an object that is not reported yet is forgotten after that
  int max_objects = 1000;             // the ones seen least are forgotten

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("ignored_classes", self.ignored_classes);
    visit("min_observations", self.min_observations, 1, 1000);
    visit("max_observations", self.max_observations, 1, 1000);
    visit("max_per_keyframe", self.max_per_keyframe, 1, 1000);
    visit("max_candidate_age_s", self.max_candidate_age_s, 0.0, 3600.0);
    visit("max_objects", self.max_objects, 1, 100000);
  }
};

// The options of object mapping, in the groups that configuration files use.
struct ObjectMappingOptions {
  ObjectMapperOptions mapper;
  ObjectPointsOptions points;
  ObjectAssociationOptions association;
  TopPlaneOptions top_plane;
  HollownessOptions hollowness;

  // Calls visit_group(name, group) for each.
  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("mapper", self.mapper);
    visit_group("points", self.points);
    visit_group("association", self.association);
    visit_group("top_plane", self.top_plane);
    visit_group("hollowness", self.hollowness);
  }
};

// Puts tracked objects into the map, thesis sections 3.4.1 and 3.4.3: where they are, how large, of
// which class, and whether there is room below. One object each, however often its track was lost,
// and however many tracks it had.
//
// Everything hangs on keyframes and moves with them. Memory is bounded. Not thread-safe.
class ObjectMapper {
 public:
  // Throws ConfigError if an option is out of range or an ignored class is not in the vocabulary.
  ObjectMapper(const ObjectMappingOptions& options,
               std::shared_ptr<const LabelVocabulary> vocabulary);

  // Takes in one image: the tracks that were seen in it (confirmed ones), and what became of it. An
  // image of a later map than the ones before lays all objects aside. Throws InputError, and
  // changes nothing, if
  //   - image, tracks and tracked image are not of one stamp, or of one size with the camera,
  //   - the stamp is not later than the one before, unless by over a second: then time begins
  //   again,
  //   - the vocabulary is another, a label is not in it, or a box is not finite,
  //   - the camera was not tracked, or its map has been forgotten already.
  void Observe(const ObjectTracks& tracks, const RgbdImage& image, const CameraModel& camera,
               const TrackedImage& tracked);

  // Moves all objects with the keyframes that they were seen from. A graph of a later map lays all
  // objects aside; they come back when a graph lists their keyframes again, and are forgotten after
  // a reset. Older maps, and older revisions, are not looked at.
  void FollowGraph(const KeyframeGraph& graph);

  // Forgets all objects; ids go on.
  void Reset();

  // The objects that were seen often enough, with ids that never change but for objects that turn
  // out to be one: then the lower id stays.
  ObjectMap Objects() const;

 private:
  void Check(const ObjectTracks& tracks, const RgbdImage& image, const CameraModel& camera,
             const TrackedImage& tracked) const;
  void BeginMap(int map_id);
  void TakeBackListed();
  Rigid3d KeyframePose(KeyframeId id) const;
  std::vector<Sighting> Look(const ObjectTracks& tracks, const RgbdImage& image,
                             const CameraModel& camera, const TrackedImage& tracked) const;
  void TakeIn(const Sighting& sighting, MappedObject& object, Stamp stamp);
  void ForgetLinks(const ObjectTracks& tracks);
  void MergeDuplicates();
  void ForgetCandidates(Stamp now);
  void ForgetUnusedPoses();
  ObservationLimits Limits() const;

  const ObjectMappingOptions options_;
  const std::shared_ptr<const LabelVocabulary> vocabulary_;
  const std::vector<LabelId> ignored_;
  std::vector<MappedObject> objects_;  // by ascending id
  std::vector<MappedObject> aside_;    // of maps that tracking has lost, likewise
  ObjectId next_id_ = 1;
  TrackLinks links_;
  std::optional<int> map_id_;
  KeyframePoses poses_;
  std::map<KeyframeId, Rigid3d> unlisted_poses_;  // T_map_keyframe where no graph lists it
  std::optional<Stamp> stamp_;
};

}  // namespace semantic_slam
