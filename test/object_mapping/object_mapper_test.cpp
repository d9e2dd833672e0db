#include "semantic_slam/object_mapping/object_mapper.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/box_scene.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr LabelId kPerson = 1, kTable = 2, kChair = 3, kBox = 4, kAnimal = 5;

std::shared_ptr<const LabelVocabulary> Vocabulary() {
  std::vector<LabelClass> classes(6);
  const char* names[] = {"unknown", "person", "table", "chair", "box", "animal"};
  for (int i = 0; i < 6; ++i) {
    classes[i].id = static_cast<LabelId>(i);
    classes[i].name = names[i];
  }
  classes[kTable].hollow = classes[kChair].hollow = true;
  return std::make_shared<const LabelVocabulary>(classes);
}

Stamp At(int image) {
  return Stamp{(image + 1) * 200'000'000LL};
}

struct SeenObject {
  int object;
  TrackId track;
  LabelId label;
  TrackState state = TrackState::kConfirmed;
};

// Everything that belongs to one image. The keyframe is a metre left of the camera.
struct Input {
  ObjectTracks tracks;
  RgbdImage image;
  TrackedImage tracked;
};

Input MakeInput(const BoxScene& scene, int image, const Rigid3d& T_map_camera,
                const std::vector<SeenObject>& seen) {
  const BoxScene::View view = scene.Render(T_map_camera, *SmallCamera(), At(image));
  Input input;
  input.image = view.image;
  input.tracks = {At(image), Vocabulary()->hash(), view.objects.size(), {}};
  for (const SeenObject& one : seen) {
    ObjectTrack track;
    track.id = one.track;
    track.state = one.state;
    track.detection = {one.label, 0.8f, BoxScene::VisibleBox(view, one.object)};
    if (!track.detection.box.empty()) input.tracks.tracks.push_back(track);
  }
  input.tracked.stamp = At(image);
  input.tracked.status = TrackingStatus::kTracking;
  input.tracked.keyframe_id = image;
  input.tracked.T_map_camera = T_map_camera;
  input.tracked.T_keyframe_camera = Eigen::Translation3d(1.0, 0.0, 0.0) * Rigid3d::Identity();
  return input;
}

void Feed(ObjectMapper& mapper, const Input& input) {
  mapper.Observe(input.tracks, input.image, *SmallCamera(), input.tracked);
}

// Where a camera on its way past the furniture at (2.5, 0) is.
Rigid3d Along(int image) {
  return LookAt({0.2, -0.8 + 0.2 * image, 1.3}, {2.5, 0.1 * image - 0.4, 0.4});
}

ObjectMapper MakeMapper(const ObjectMappingOptions& options = {}) {
  return ObjectMapper(options, Vocabulary());
}

class ObjectMapperTest : public testing::Test {
 protected:
  ObjectMapperTest() {
    table_ = scene_.AddTable({2.6, 0.0}, {0.7, 1.1, 0.75}, 0.2);
    crate_ = scene_.AddCrate({1.6, 1.2}, {0.4, 0.3, 0.3}, 0.5);
  }

  void FeedTable(int from, int until, TrackId track = 1) {
    for (int i = from; i < until; ++i) {
      Feed(mapper_, MakeInput(scene_, i, Along(i), {{table_, track, kTable}}));
    }
  }

  BoxScene scene_;
  int table_, crate_;
  ObjectMapper mapper_ = MakeMapper();
};

TEST_F(ObjectMapperTest, ObjectsAreWhereTheyStand) {
  for (int i = 0; i < 8; ++i) {
    Feed(mapper_, MakeInput(scene_, i, Along(i), {{table_, 1, kTable}, {crate_, 2, kBox}}));
  }
  const ObjectMap map = mapper_.Objects();
  EXPECT_EQ(map.stamp, At(7));
  EXPECT_EQ(map.vocabulary_hash, Vocabulary()->hash());
  ASSERT_EQ(map.objects.size(), 2u);
  const MapObject& table = map.objects[0];
  EXPECT_EQ(table.labels.at(0).label, kTable);
  // Several views: the footprint is exact to about a pixel's size, a centimetre to each side.
  EXPECT_NEAR((table.T_map_box.translation() - Eigen::Vector3d(2.6, 0.0, 0.375)).norm(), 0.0, 0.03);
  EXPECT_NEAR(table.box_size_m.x(), 1.1, 0.04);
  EXPECT_NEAR(table.box_size_m.y(), 0.7, 0.04);
  EXPECT_NEAR(Area(table.footprint_m), 0.77, 0.05);
  EXPECT_NEAR(table.max_height_m, 0.75, 0.01);
  EXPECT_EQ(table.hollow, Hollowness::kFull);
  EXPECT_EQ(table.observations, 8);
  EXPECT_EQ(table.last_seen, At(7));
  const MapObject& crate = map.objects[1];
  EXPECT_NEAR((crate.T_map_box.translation().head<2>() - Eigen::Vector2d(1.6, 1.2)).norm(), 0.0,
              0.03);
  EXPECT_NEAR(crate.box_size_m.x(), 0.4, 0.03);
  EXPECT_NEAR(crate.box_size_m.y(), 0.3, 0.03);
  EXPECT_EQ(crate.hollow, Hollowness::kNo);
}

TEST_F(ObjectMapperTest, WhatIsSeenTooSeldomIsNotReported) {
  FeedTable(0, 2);
  EXPECT_TRUE(mapper_.Objects().objects.empty());
  FeedTable(2, 3);
  EXPECT_EQ(mapper_.Objects().objects.size(), 1u);
}

TEST_F(ObjectMapperTest, ATrackThatWasLostComesBackToItsObject) {
  FeedTable(0, 3, 1);
  FeedTable(5, 8, 99);  // found again under another id
  const ObjectMap map = mapper_.Objects();
  ASSERT_EQ(map.objects.size(), 1u);
  EXPECT_EQ(map.objects[0].observations, 6);
}

TEST_F(ObjectMapperTest, TwoTracksOfOneObjectAreOneObjectWithTwoNames) {
  for (int i = 0; i < 5; ++i) {
    Feed(mapper_, MakeInput(scene_, i, Along(i), {{table_, 1, kTable}, {table_, 2, kBox}}));
  }
  const ObjectMap map = mapper_.Objects();
  ASSERT_EQ(map.objects.size(), 1u);
  EXPECT_EQ(map.objects[0].observations, 5);
  EXPECT_EQ(map.objects[0].labels.size(), 2u);
}

TEST_F(ObjectMapperTest, TwoChairsAMetreApartStayTwo) {
  BoxScene scene;
  const int left = scene.AddChair({2.4, 0.5}, 2.8), right = scene.AddChair({2.4, -0.5}, 3.3);
  for (int i = 0; i < 6; ++i) {
    // A detector that swaps their tracks half-way.
    const TrackId a = i < 3 ? 1 : 2;
    Feed(mapper_, MakeInput(scene, i, Along(i), {{left, a, kChair}, {right, 3 - a, kChair}}));
  }
  const ObjectMap map = mapper_.Objects();
  ASSERT_EQ(map.objects.size(), 2u);
  for (const MapObject& chair : map.objects) {
    EXPECT_EQ(chair.observations, 6);
    EXPECT_NEAR(std::abs(chair.T_map_box.translation().y()), 0.5, 0.05);
  }
}

TEST_F(ObjectMapperTest, APartInViewDoesNotMoveWhatWasSeenWhole) {
  FeedTable(0, 4);
  const MapObject before = mapper_.Objects().objects.at(0);
  for (int i = 4; i < 12; ++i) {  // the table's left end at the image's edge
    Feed(mapper_,
         MakeInput(scene_, i, LookAt({0.8, -0.2, 1.3}, {2.2, -1.3, 0.5}), {{table_, 1, kTable}}));
  }
  const ObjectMap map = mapper_.Objects();
  ASSERT_EQ(map.objects.size(), 1u);
  EXPECT_EQ(map.objects[0].observations, 12);
  EXPECT_EQ(map.objects[0].box_size_m, before.box_size_m);
  EXPECT_EQ(map.objects[0].position_m, before.position_m);
}

TEST_F(ObjectMapperTest, IgnoredClassesAndTracksThatAreNotInViewAreLeftOut) {
  for (int i = 0; i < 5; ++i) {
    Feed(mapper_, MakeInput(scene_, i, Along(i),
                            {{table_, 1, kPerson}, {crate_, 2, kBox, TrackState::kLost}}));
  }
  EXPECT_TRUE(mapper_.Objects().objects.empty());
}

// A graph with one keyframe per image of Along(), all moved by `motion` in the map.
KeyframeGraph GraphOf(int images, const Rigid3d& motion, std::uint64_t revision) {
  KeyframeGraph graph;
  graph.revision = revision;
  for (int i = 0; i < images; ++i) {
    KeyframeNode node;
    node.id = i;
    node.stamp = At(i);
    node.T_map_keyframe = motion * Along(i) * Eigen::Translation3d(-1.0, 0.0, 0.0);
    graph.keyframes.push_back(node);
  }
  return graph;
}

TEST_F(ObjectMapperTest, ObjectsFollowTheirKeyframes) {
  FeedTable(0, 5);
  const MapObject before = mapper_.Objects().objects.at(0);
  const Rigid3d motion = Eigen::Translation3d(3.0, -1.0, 0.1) *
                         Rigid3d(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
  mapper_.FollowGraph(GraphOf(5, motion, 4));
  const ObjectMap map = mapper_.Objects();
  EXPECT_EQ(map.revision, 4u);
  const MapObject& after = map.objects.at(0);
  EXPECT_NEAR((after.position_m - motion * before.position_m).norm(), 0.0, 1e-9);
  EXPECT_NEAR((after.T_map_box.translation() - motion * before.T_map_box.translation()).norm(), 0.0,
              0.01);  // outlines are compared in other directions
  EXPECT_NEAR(after.max_height_m, before.max_height_m + 0.1, 1e-9);
  mapper_.FollowGraph(GraphOf(5, Rigid3d::Identity(), 3));  // an old revision
  EXPECT_EQ(mapper_.Objects().objects.at(0).position_m, after.position_m);
}

TEST_F(ObjectMapperTest, AKeyframeThatNoGraphListsStaysWhereItWas) {
  FeedTable(0, 4);
  mapper_.FollowGraph(GraphOf(4, Rigid3d::Identity(), 1));
  const MapObject before = mapper_.Objects().objects.at(0);
  KeyframeGraph empty;
  empty.revision = 2;
  mapper_.FollowGraph(empty);
  EXPECT_EQ(mapper_.Objects().objects.at(0).position_m, before.position_m);
  Input input = MakeInput(scene_, 4, Along(3), {{table_, 1, kTable}});
  for (int i = 4; i < 200; ++i) {  // more keyframes than need be remembered
    input.tracks.stamp = input.image.stamp = input.tracked.stamp = At(i);
    input.tracked.keyframe_id = i;
    Feed(mapper_, input);
  }
  EXPECT_EQ(mapper_.Objects().objects.at(0).observations, 200);
}

TEST_F(ObjectMapperTest, DuplicatesThatComeTogetherBecomeOne) {
  FeedTable(0, 3, 1);
  // The camera has drifted by a metre when it sees the table again: two objects, until the loop
  // closes.
  const Rigid3d drift(Eigen::Translation3d(0.0, 1.5, 0.0));
  for (int i = 3; i < 6; ++i) {
    Input input = MakeInput(scene_, i, Along(i), {{table_, 2, kTable}});
    input.tracked.T_map_camera = drift * input.tracked.T_map_camera;
    Feed(mapper_, input);
  }
  const ObjectMap two = mapper_.Objects();
  ASSERT_EQ(two.objects.size(), 2u);
  mapper_.FollowGraph(GraphOf(6, Rigid3d::Identity(), 1));
  const ObjectMap one = mapper_.Objects();
  ASSERT_EQ(one.objects.size(), 1u);
  EXPECT_EQ(one.objects[0].id, two.objects[0].id);
  EXPECT_EQ(one.objects[0].observations, 6);
}

TEST_F(ObjectMapperTest, ANewMapForgetsTheOldOneAndIdsGoOn) {
  FeedTable(0, 3);
  const ObjectId old_id = mapper_.Objects().objects.at(0).id;
  for (int i = 3; i < 6; ++i) {
    Input input = MakeInput(scene_, i, Along(i), {{table_, 1, kTable}});
    input.tracked.map_id = 1;
    Feed(mapper_, input);
  }
  const ObjectMap map = mapper_.Objects();
  EXPECT_EQ(map.map_id, 1);
  ASSERT_EQ(map.objects.size(), 1u);
  EXPECT_GT(map.objects[0].id, old_id);
  KeyframeGraph next;
  next.map_id = 2;
  mapper_.FollowGraph(next);
  EXPECT_EQ(mapper_.Objects().map_id, 2);
  EXPECT_TRUE(mapper_.Objects().objects.empty());
  KeyframeGraph old;
  old.map_id = 1;
  mapper_.FollowGraph(old);
  EXPECT_EQ(mapper_.Objects().map_id, 2);
}

TEST_F(ObjectMapperTest, ObjectsOfAMapThatWasLostComeBackWhenItIsJoined) {
  FeedTable(0, 3);
  const MapObject table = mapper_.Objects().objects.at(0);
  KeyframeGraph graph;
  graph.map_id = 1;
  graph.revision = 7;
  graph.reason = RevisionReason::kLost;
  mapper_.FollowGraph(graph);
  EXPECT_TRUE(mapper_.Objects().objects.empty());
  // Its keyframes are listed again, all of them a metre to the side.
  graph = GraphOf(3, Eigen::Translation3d(0.0, 1.0, 0.0) * Rigid3d::Identity(), 8);
  graph.map_id = 1;
  mapper_.FollowGraph(graph);
  const ObjectMap joined = mapper_.Objects();
  ASSERT_EQ(joined.objects.size(), 1u);
  EXPECT_EQ(joined.objects[0].id, table.id);
  EXPECT_NEAR(joined.objects[0].position_m.y(), table.position_m.y() + 1.0, 1e-6);
}

TEST_F(ObjectMapperTest, AResetOrALoadedMapForgetsObjectsOfMapsThatWereLost) {
  int map_id = 0;
  for (const RevisionReason reason : {RevisionReason::kReset, RevisionReason::kLoad}) {
    for (int i = 3 * map_id; i < 3 * map_id + 3; ++i) {
      Input input = MakeInput(scene_, i, Along(i), {{table_, 1, kTable}});
      input.tracked.map_id = map_id;
      Feed(mapper_, input);
    }
    EXPECT_EQ(mapper_.Objects().objects.size(), 1u);
    KeyframeGraph graph;
    graph.map_id = ++map_id;
    graph.reason = reason;
    mapper_.FollowGraph(graph);
    graph = GraphOf(6, Rigid3d::Identity(), 1);
    graph.map_id = map_id;
    mapper_.FollowGraph(graph);
    EXPECT_TRUE(mapper_.Objects().objects.empty());
  }
}

TEST_F(ObjectMapperTest, ResetForgetsObjects) {
  FeedTable(0, 3);
  mapper_.Reset();
  EXPECT_TRUE(mapper_.Objects().objects.empty());
  FeedTable(3, 6);
  EXPECT_EQ(mapper_.Objects().objects.size(), 1u);
}

TEST_F(ObjectMapperTest, CandidatesThatAreNotSeenAgainAreForgotten) {
  FeedTable(0, 2);
  Feed(mapper_, MakeInput(scene_, 100, Along(0), {}));  // 20 s later
  FeedTable(101, 103);
  EXPECT_TRUE(mapper_.Objects().objects.empty());  // two and two images are not four of one object
}

TEST_F(ObjectMapperTest, WhatDoesNotFitIsRefusedInOneLineAndChangesNothing) {
  FeedTable(0, 3);
  const auto message = [&](const Input& input) {
    return MessageOf<InputError>([&] { Feed(mapper_, input); });
  };
  const Input good = MakeInput(scene_, 3, Along(3), {{table_, 1, kTable}});
  Input bad = good;
  bad.tracks.stamp = At(4);
  ExpectOneLineWith(message(bad), {"tracks of", "image of"});
  bad = good;
  bad.tracked.status = TrackingStatus::kLost;
  ExpectOneLineWith(message(bad), {"no pose"});
  bad = good;
  bad.tracked.T_keyframe_camera.translation().x() = std::numeric_limits<double>::quiet_NaN();
  ExpectOneLineWith(message(bad), {"no pose"});
  bad = good;
  bad.tracked.map_id = -1;
  ExpectOneLineWith(message(bad), {"map -1"});
  bad = good;
  ++bad.tracks.vocabulary_hash;
  ExpectOneLineWith(message(bad), {"label set"});
  bad = good;
  bad.tracks.tracks[0].detection.label = 200;
  ExpectOneLineWith(message(bad), {"200"});
  bad = good;
  bad.tracks.tracks[0].detection.box.x = std::numeric_limits<float>::quiet_NaN();
  ExpectOneLineWith(message(bad), {"box"});
  bad = good;
  bad.tracks.image_size = {640, 480};
  ExpectOneLineWith(message(bad), {"image size"});
  bad = good;
  bad.image.depth_m = cv::Mat();
  ExpectOneLineWith(message(bad), {"depth"});
  bad = MakeInput(scene_, 1, Along(1), {{table_, 1, kTable}});
  ExpectOneLineWith(message(bad), {"stamp", "not later"});
  EXPECT_EQ(mapper_.Objects().objects.at(0).observations, 3);
  Feed(mapper_, good);
  EXPECT_EQ(mapper_.Objects().objects.at(0).observations, 4);
}

TEST_F(ObjectMapperTest, OffTheImageThereIsNothingToMap) {
  Input input = MakeInput(scene_, 0, Along(0), {{table_, 1, kTable}});
  for (const cv::Rect2f& box : {cv::Rect2f(-500, -500, 10, 10), cv::Rect2f(5000, 20, 30, 30)}) {
    input.tracks.tracks[0].detection.box = box;
    input.tracks.stamp.ns += 1, input.image.stamp.ns += 1, input.tracked.stamp.ns += 1;
    EXPECT_NO_THROW(Feed(mapper_, input));
  }
  EXPECT_TRUE(mapper_.Objects().objects.empty());
}

TEST_F(ObjectMapperTest, TheSameInputGivesTheSameMap) {
  ObjectMapper again = MakeMapper();
  for (int i = 0; i < 5; ++i) {
    const Input input = MakeInput(scene_, i, Along(i), {{table_, 1, kTable}, {crate_, 2, kBox}});
    Feed(mapper_, input);
    Feed(again, input);
  }
  const ObjectMap a = mapper_.Objects(), b = again.Objects();
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].position_m, b.objects[i].position_m);
    EXPECT_EQ(a.objects[i].footprint_m, b.objects[i].footprint_m);
  }
}

TEST(ObjectMapperOptionsTest, WhatIsWrongIsNamed) {
  ObjectMappingOptions options;
  options.mapper.ignored_classes = "person,unicorn";
  ExpectOneLineWith(MessageOf<ConfigError>([&] { MakeMapper(options); }),
                    {"ignored_classes", "unicorn"});
  options = {};
  options.points.max_depth_m = -1.0;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { MakeMapper(options); }), {"max_depth_m"});
  options = {};
  options.mapper.ignored_classes = "";
  EXPECT_NO_THROW(MakeMapper(options));
}

}  // namespace
}  // namespace semantic_slam
