#include "semantic_slam_ros/object_conversions.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::Detections;
using semantic_slam::InputError;
using semantic_slam::MapObject;
using semantic_slam::MessageOf;
using semantic_slam::ObjectMap;
using semantic_slam::ObjectTracks;
using semantic_slam::SmallVocabulary;
using DetectionArrayMsg = semantic_slam::DetectionArray;
using ObjectArrayMsg = semantic_slam::SemanticObjectArray;
using TrackArrayMsg = semantic_slam::TrackedObjectArray;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr float kNanF = std::numeric_limits<float>::quiet_NaN();

// Every member of a message, one after another spoilt by a function and refused with a line.
template <typename Message>
struct Fault {
  std::function<void(Message&)> spoil;
  std::string error;
};

template <typename Message, typename Read>
void ExpectRefused(const Message& good, const std::vector<Fault<Message>>& faults, Read read) {
  EXPECT_EQ(MessageOf<InputError>([&] { read(good, SmallVocabulary()); }), "");
  for (const Fault<Message>& fault : faults) {
    Message msg = good;
    fault.spoil(msg);
    const std::string error = MessageOf<InputError>([&] { read(msg, SmallVocabulary()); });
    semantic_slam::ExpectOneLineWith(error, {fault.error.c_str()});
  }
}

Detections SomeDetections() {
  Detections detections;
  detections.stamp = Stamp{1305031453359684001};
  detections.vocabulary_hash = SmallVocabulary().hash();
  detections.image_size = {640, 480};
  detections.boxes = {{4, 0.75f, {-10.5f, 20.0f, 100.0f, 50.25f}},
                      {3, 0.5f, {1.0f, 2.0f, 3.0f, 4.0f}}};
  return detections;
}

TEST(DetectionConversionsTest, ReadBackWhatTheyWrite) {
  const Detections written = SomeDetections();
  const DetectionArrayMsg msg = ToDetectionArray(written, "camera");
  EXPECT_EQ(msg.header.frame_id, "camera");
  EXPECT_EQ(msg.width, 640u);
  EXPECT_EQ(msg.detections[0].x_min, -10.5f);
  EXPECT_EQ(msg.detections[0].x_max, 89.5f);
  EXPECT_EQ(msg.detections[0].y_max, 70.25f);
  const Detections read = ToDetections(msg, SmallVocabulary());
  EXPECT_EQ(read.stamp, written.stamp);
  EXPECT_EQ(read.vocabulary_hash, written.vocabulary_hash);
  EXPECT_EQ(read.image_size, written.image_size);
  ASSERT_EQ(read.boxes.size(), 2u);
  EXPECT_EQ(read.boxes[0].label, 4);
  EXPECT_EQ(read.boxes[0].confidence, 0.75f);
  EXPECT_EQ(read.boxes[0].box, written.boxes[0].box);
  EXPECT_EQ(read.boxes[1].box, written.boxes[1].box);
}

TEST(DetectionConversionsTest, NothingFoundIsNoFault) {
  Detections nothing = SomeDetections();
  nothing.boxes.clear();
  EXPECT_TRUE(ToDetections(ToDetectionArray(nothing, "camera"), SmallVocabulary()).boxes.empty());
}

TEST(DetectionConversionsTest, RefuseWhatIsMalformed) {
  using M = DetectionArrayMsg;
  ExpectRefused<M>(
      ToDetectionArray(SomeDetections(), "camera"),
      {{[](M& m) { m.label_set_hash = 1; }, "another label set"},
       {[](M& m) { m.width = 0; }, "detections: image size is 0 x 480"},
       {[](M& m) { m.height = 4000000000u; }, "detections: image size is 640 x 4000000000"},
       {[](M& m) { m.detections[1].label = 8; }, "label id 8 is not in the vocabulary"},
       {[](M& m) { m.detections[1].confidence = -0.5f; }, "confidence is -0.500000"},
       {[](M& m) { m.detections[0].confidence = kNanF; }, "confidence is nan"},
       {[](M& m) { m.detections[0].confidence = 0.25f; }, "confidences do not descend"},
       {[](M& m) { m.detections[0].x_max = -10.5f; }, "a box is empty or not finite"},
       {[](M& m) { m.detections[0].y_min = kNanF; }, "a box is empty or not finite"}},
      ToDetections);
}

ObjectTracks SomeTracks() {
  ObjectTracks tracks;
  tracks.stamp = Stamp{30};
  tracks.vocabulary_hash = SmallVocabulary().hash();
  tracks.image_size = {640, 480};
  tracks.tracks = {
      {5, semantic_slam::TrackState::kLost, {3, 0.5f, {1.0f, 2.0f, 3.0f, 4.0f}}, 7, 0.25},
      {8, semantic_slam::TrackState::kConfirmed, {4, 0.75f, {5.0f, 6.0f, 7.0f, 8.0f}}, 2, 0.0}};
  return tracks;
}

TEST(TrackConversionsTest, ReadBackWhatTheyWrite) {
  const ObjectTracks written = SomeTracks();
  const ObjectTracks read =
      ToObjectTracks(ToTrackedObjectArray(written, "camera"), SmallVocabulary());
  EXPECT_EQ(read.stamp, written.stamp);
  EXPECT_EQ(read.image_size, written.image_size);
  EXPECT_EQ(read.vocabulary_hash, written.vocabulary_hash);
  ASSERT_EQ(read.tracks.size(), 2u);
  EXPECT_EQ(read.tracks[0].id, 5);
  EXPECT_EQ(read.tracks[0].state, semantic_slam::TrackState::kLost);
  EXPECT_EQ(read.tracks[0].hits, 7);
  EXPECT_EQ(read.tracks[0].since_seen_s, 0.25);
  EXPECT_EQ(read.tracks[1].detection.label, 4);
  EXPECT_EQ(read.tracks[1].detection.box, written.tracks[1].detection.box);
}

TEST(TrackConversionsTest, RefuseWhatIsMalformed) {
  using M = TrackArrayMsg;
  ExpectRefused<M>(
      ToTrackedObjectArray(SomeTracks(), "camera"),
      {{[](M& m) { m.label_set_hash = 1; }, "another label set"},
       {[](M& m) { m.width = 0; }, "tracked objects: image size is 0 x 480"},
       {[](M& m) { m.objects[0].state = 3; }, "tracked objects: state is 3, expected 0 to 2"},
       {[](M& m) { m.objects[1].id = 5; },
        "tracked objects: id 5 follows 5, expected ascending ids"},
       {[](M& m) { m.objects[1].detection.label = 8; }, "label id 8 is not in the vocabulary"},
       {[](M& m) { m.objects[1].detection.x_max = 0.0f; }, "a box is empty or not finite"}},
      ToObjectTracks);
}

MapObject SomeObject() {
  MapObject object;
  object.id = 12;
  object.labels = {{4, 0.75f}, {3, 0.125f}};
  object.position_m = {1.0, 2.0, 0.5};
  object.position_covariance_m2 = Eigen::Vector3d(0.01, 0.02, 0.03).asDiagonal();
  object.position_covariance_m2(0, 1) = object.position_covariance_m2(1, 0) = 0.005;
  object.T_map_box =
      Eigen::Translation3d(1.0, 2.0, 0.25) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ());
  object.box_size_m = {1.5, 0.75, 0.5};
  object.min_height_m = 0.0;
  object.max_height_m = 0.5;
  object.hollow = semantic_slam::Hollowness::kFull;
  object.footprint_m = {{0.0, 0.0}, {1.5, 0.0}, {1.5, 0.75}, {0.0, 0.75}};
  object.observations = 9;
  object.last_seen = Stamp{77};
  return object;
}

ObjectMap SomeMap() {
  ObjectMap map;
  map.stamp = Stamp{80};
  map.map_id = 2;
  map.revision = 31;
  map.vocabulary_hash = SmallVocabulary().hash();
  map.objects = {SomeObject(), SomeObject()};
  map.objects[1].id = 15;
  return map;
}

TEST(ObjectConversionsTest, ReadBackWhatTheyWrite) {
  const ObjectArrayMsg msg = ToSemanticObjectArray(SomeMap(), "map");
  EXPECT_EQ(msg.header.frame_id, "map");
  EXPECT_EQ(msg.objects[0].position_covariance[1], 0.005);
  const ObjectMap read = ToObjectMap(msg, SmallVocabulary());
  EXPECT_EQ(read.stamp, Stamp{80});
  EXPECT_EQ(read.map_id, 2);
  EXPECT_EQ(read.revision, 31u);
  ASSERT_EQ(read.objects.size(), 2u);
  EXPECT_EQ(read.objects[1].id, 15);
  const MapObject object = read.objects[0], expected = SomeObject();
  EXPECT_EQ(object.id, expected.id);
  ASSERT_EQ(object.labels.size(), 2u);
  EXPECT_EQ(object.labels[1].label, 3);
  EXPECT_EQ(object.labels[1].probability, 0.125f);
  EXPECT_EQ(object.position_m, expected.position_m);
  EXPECT_EQ(object.position_covariance_m2, expected.position_covariance_m2);
  // 1e-12: a quaternion in between.
  EXPECT_TRUE(object.T_map_box.isApprox(expected.T_map_box, 1e-12));
  EXPECT_EQ(object.box_size_m, expected.box_size_m);
  EXPECT_EQ(object.min_height_m, 0.0);
  EXPECT_EQ(object.max_height_m, 0.5);
  EXPECT_EQ(object.hollow, expected.hollow);
  EXPECT_EQ(object.footprint_m, expected.footprint_m);
  EXPECT_EQ(object.observations, 9);
  EXPECT_EQ(object.last_seen, Stamp{77});
}

TEST(ObjectConversionsTest, AnEmptyMapIsNoFault) {
  ObjectMap map = SomeMap();
  map.objects.clear();
  EXPECT_TRUE(ToObjectMap(ToSemanticObjectArray(map, "map"), SmallVocabulary()).objects.empty());
}

TEST(ObjectConversionsTest, RefuseWhatIsMalformed) {
  using M = ObjectArrayMsg;
  const std::string who = "objects: object 15: ";
  ExpectRefused<M>(
      ToSemanticObjectArray(SomeMap(), "map"),
      {{[](M& m) { m.label_set_hash = 1; }, "objects: made with another label set, hash 1"},
       {[](M& m) { m.objects[1].id = 12; }, "objects: id 12 follows 12, expected ascending ids"},
       {[](M& m) { m.objects[1].labels[0] = 8; }, who + "labels: label id 8 is not in the vocabulary"},
       {[](M& m) { m.objects[1].labels.pop_back(); }, who + "has 1 labels and 2 probabilities"},
       {[](M& m) { m.objects[1].probabilities[0] = kNanF; }, who + "probability is nan"},
       {[](M& m) { m.objects[1].probabilities[1] = 0.875f; }, who + "probability is 0.875000"},
       {[](M& m) {
          m.objects[1].probabilities = {0.75f, 0.5f};
        },
        who + "probabilities sum up to 1.250000, expected at most 1"},
       {[](M& m) { m.objects[1].position.y = kNan; }, who + "position is not finite"},
       {[](M& m) { m.objects[1].position_covariance[2] = kNan; }, who + "position_covariance"},
       {[](M& m) { m.objects[1].position_covariance[4] = -1.0; }, who + "position_covariance"},
       {[](M& m) { m.objects[1].box_pose.orientation.w = 3.0; }, who + "transform's quaternion"},
       {[](M& m) { m.objects[1].box_size.z = -1.0; }, who + "box_size is negative"},
       {[](M& m) { m.objects[1].min_height = 0.75f; }, who + "heights are 0.750000 to 0.500000"},
       {[](M& m) { m.objects[1].max_height = kNanF; }, who + "heights are"},
       {[](M& m) { m.objects[1].hollow = 3; }, who + "hollow is 3, expected 0 to 2"},
       {[](M& m) { m.objects[1].footprint.points[2].x = kNanF; }, who + "footprint is not finite"}},
      ToObjectMap);
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
