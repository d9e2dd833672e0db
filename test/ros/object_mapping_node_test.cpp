// Drives object_mapping_node, as a node and as a nodelet (object_mapping_node.test,
// object_mapping_nodelet.test), over real topics with furniture of which every pixel is known.

#include "semantic_slam_ros/object_mapping_node.h"

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/Query.h>
#include <semantic_slam/SaveMap.h>
#include <semantic_slam/SemanticObjectArray.h>
#include <semantic_slam/TrackedObjectArray.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include "ros/ros_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/object_conversions.h"
#include "semantic_slam_ros/tracking_conversions.h"
#include "testing/box_scene.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"
#include "testing/temporary_folder.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::BoxScene;
using semantic_slam::KeyframeGraph;
using semantic_slam::LabelVocabulary;
using semantic_slam::ObjectTrack;
using semantic_slam::ObjectTracks;
using semantic_slam::TrackedImage;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;
using ObjectArrayMsg = semantic_slam::SemanticObjectArray;
using ObjectMsg = semantic_slam::SemanticObject;

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 20.0;

class ObjectMappingNodeTest : public testing::Test {
 protected:
  ObjectMappingNodeTest() {
    table_ = scene_.AddTable({2.6, 0.0}, {0.7, 1.1, 0.75}, 0.2);
    crate_ = scene_.AddCrate({1.7, 1.1}, {0.4, 0.3, 0.3}, 0.5);
    view_ = scene_.Render(T_map_camera_, *semantic_slam::SmallCamera(), Stamp{1});
  }

  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return objects_.connected() && markers_.connected() &&
                 tracks_pub_.getNumSubscribers() > 0 && colour_pub_.getNumSubscribers() > 0 &&
                 depth_pub_.getNumSubscribers() > 0 && info_pub_.getNumSubscribers() > 0 &&
                 state_pub_.getNumSubscribers() > 0 && graph_pub_.getNumSubscribers() > 0 &&
                 diagnostics_.last();
        },
        kLimitS))
        << "the node did not connect; is it running?";
    // Each test begins in a map of its own.
    ++map_id_;
    SendGraph(Rigid3d::Identity());
    ASSERT_TRUE(
        SpinUntil([&] { return objects_.last() && objects_.last()->map_id == map_id_; }, kLimitS));
  }

  static Stamp NextStamp() {  // they go on from test to test
    static std::int64_t ns = 1'000'000'000'000;
    return Stamp{ns += 100'000'000};
  }

  // One keyframe, where the camera is, moved by `motion`.
  void SendGraph(const Rigid3d& motion) {
    KeyframeGraph graph;
    graph.map_id = map_id_;
    graph.revision = ++revision_;
    graph.keyframes.emplace_back();
    graph.keyframes[0].id = map_id_;
    graph.keyframes[0].stamp = NextStamp();
    graph.keyframes[0].T_map_keyframe = motion * T_map_camera_;
    graph_pub_.publish(ToKeyframeArray(graph, "map"));
  }

  TrackedImage Tracked(Stamp stamp) const {
    TrackedImage image;
    image.stamp = stamp;
    image.status = semantic_slam::TrackingStatus::kTracking;
    image.map_id = map_id_;
    image.keyframe_id = map_id_;
    image.T_map_camera = image.T_odom_camera = T_map_camera_;
    return image;
  }

  ObjectTracks Tracks(Stamp stamp) const {
    ObjectTracks tracks{stamp, vocabulary_.hash(), view_.objects.size(), {}};
    const auto add = [&](semantic_slam::TrackId id, const char* name, int object) {
      ObjectTrack track;
      track.id = id;
      track.state = semantic_slam::TrackState::kConfirmed;
      track.detection = {*vocabulary_.Find(name), 0.8f, BoxScene::VisibleBox(view_, object)};
      track.hits = 2;
      tracks.tracks.push_back(track);
    };
    add(1, "table", table_);
    add(2, "box", crate_);
    return tracks;
  }

  void SendImages(Stamp stamp) {
    const std_msgs::Header header = MakeHeader(stamp, kCameraFrame);
    info_pub_.publish(ToCameraInfo(semantic_slam::SmallIntrinsics(), header));
    colour_pub_.publish(ToImage(view_.image.colour, "bgr8", header));
    depth_pub_.publish(ToImage(view_.image.depth_m, "32FC1", header));
  }
  void Send(const ObjectTracks& tracks) {
    tracks_pub_.publish(ToTrackedObjectArray(tracks, kCameraFrame));
  }
  void Send(const TrackedImage& image) {
    state_pub_.publish(ToTrackingState(image, "map", kCameraFrame));
  }
  void SendAll(Stamp stamp) {
    SendImages(stamp);
    Send(Tracked(stamp));
    Send(Tracks(stamp));
    SpinUntil([] { return false; }, 0.1);  // or the next would push it out of a queue
  }

  // Sends images until the map has both objects. A node that has just come up may miss some.
  void Map() {
    for (int attempt = 0; attempt < 50 && Count() < 2; ++attempt) SendAll(NextStamp());
    ASSERT_TRUE(SpinUntil([&] { return Count() == 2; }, kLimitS)) << Count() << " objects";
  }

  std::size_t Count() const { return objects_.last() ? objects_.last()->objects.size() : 0; }

  int WaitForDrops(const std::string& cause, int at_least) {
    int value = 0;
    SpinUntil(
        [&] {
          const std::string text = DiagnosticValue(*diagnostics_.last(), "dropped: " + cause);
          if (!text.empty()) value = std::stoi(text);
          return value >= at_least;
        },
        at_least > 0 ? kLimitS : 1.5);
    return value;
  }

  static int map_id_;
  static std::uint64_t revision_;
  const LabelVocabulary vocabulary_ =
      LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  const Rigid3d T_map_camera_ = semantic_slam::LookAt({0.2, 0.0, 1.3}, {2.4, 0.2, 0.4});
  BoxScene scene_;
  int table_, crate_;
  BoxScene::View view_;
  ros::NodeHandle nh_;
  Listener<ObjectArrayMsg> objects_{nh_, "objects"};
  Listener<MarkerArray> markers_{nh_, "object_markers"};
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
  ros::Publisher colour_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
  ros::Publisher depth_pub_ = nh_.advertise<sensor_msgs::Image>("depth_registered/image_raw", 10);
  ros::Publisher info_pub_ = nh_.advertise<sensor_msgs::CameraInfo>("rgb/camera_info", 10);
  ros::Publisher tracks_pub_ =
      nh_.advertise<semantic_slam::TrackedObjectArray>("tracked_objects", 10);
  ros::Publisher state_pub_ = nh_.advertise<semantic_slam::TrackingState>("tracking_state", 10);
  ros::Publisher graph_pub_ = nh_.advertise<semantic_slam::KeyframeArray>("keyframes", 10, true);
};

int ObjectMappingNodeTest::map_id_ = 0;
std::uint64_t ObjectMappingNodeTest::revision_ = 0;

TEST_F(ObjectMappingNodeTest, MapsObjectsWhereTheyStand) {
  Map();
  const ObjectArrayMsg& map = *objects_.last();
  EXPECT_EQ(map.header.frame_id, "map");
  EXPECT_FALSE(map.header.stamp.isZero());
  EXPECT_EQ(map.map_id, map_id_);
  EXPECT_EQ(map.revision, revision_);
  EXPECT_EQ(map.label_set_hash, vocabulary_.hash());
  // The core's tests say how exact it is; here nothing but the way through the topics can go wrong.
  const bool table_first = map.objects[0].labels.at(0) == *vocabulary_.Find("table");
  const ObjectMsg& table = map.objects[table_first ? 0 : 1];
  EXPECT_EQ(table.labels.at(0), *vocabulary_.Find("table"));
  EXPECT_NEAR(table.box_pose.position.x, 2.6, 0.05);
  EXPECT_NEAR(table.box_pose.position.y, 0.0, 0.05);
  EXPECT_NEAR(table.max_height, 0.75, 0.02);
  EXPECT_EQ(table.hollow, ObjectMsg::HOLLOW_FULL);
  EXPECT_GE(table.footprint.points.size(), 4u);
  EXPECT_GE(table.observations, 3u);
  const ObjectMsg& crate = map.objects[table_first ? 1 : 0];
  EXPECT_EQ(crate.labels.at(0), *vocabulary_.Find("box"));
  EXPECT_NEAR(crate.box_pose.position.y, 1.1, 0.05);
  EXPECT_EQ(crate.hollow, ObjectMsg::HOLLOW_NO);
}

TEST_F(ObjectMappingNodeTest, WhoComesLateGetsTheMap) {
  Map();
  Listener<ObjectArrayMsg> late(nh_, "objects");
  Listener<MarkerArray> late_markers(nh_, "object_markers");
  EXPECT_TRUE(SpinUntil([&] { return late.last() && late_markers.last(); }, kLimitS));
  EXPECT_EQ(late.last()->objects.size(), 2u);
}

TEST_F(ObjectMappingNodeTest, DrawsObjectsAndTakesThemAway) {
  Map();
  const auto shown = [&] {
    std::size_t count = 0;
    for (const Marker& marker : markers_.last()->markers) count += marker.action == Marker::ADD;
    return count;
  };
  ASSERT_TRUE(SpinUntil([&] { return markers_.last() && shown() == 6; }, kLimitS));
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("object_mapping/reset", reset));
  EXPECT_TRUE(reset.response.success);
  ASSERT_TRUE(SpinUntil([&] { return Count() == 0 && shown() == 0; }, kLimitS));
  EXPECT_EQ(markers_.last()->markers.size(), 6u);
}

TEST_F(ObjectMappingNodeTest, FollowsTheKeyframesAndForgetsAnotherMap) {
  Map();
  const double before = objects_.last()->objects[0].position.y;
  SendGraph(Rigid3d(Eigen::Translation3d(0.0, 0.5, 0.0)));
  EXPECT_TRUE(SpinUntil([&] { return objects_.last()->revision == revision_; }, kLimitS));
  EXPECT_NEAR(objects_.last()->objects.at(0).position.y, before + 0.5, 1e-6);
  ++map_id_;
  SendGraph(Rigid3d::Identity());
  EXPECT_TRUE(SpinUntil([&] { return Count() == 0; }, kLimitS));
}

TEST_F(ObjectMappingNodeTest, AnswersWhatIsWhere) {
  Map();
  semantic_slam::Query query;
  ASSERT_TRUE(ros::service::call("object_mapping/query", query));
  EXPECT_TRUE(query.response.success);
  EXPECT_EQ(query.response.objects.size(), 2u);
  EXPECT_EQ(query.response.header.frame_id, "map");
  query.request.class_name = "table";
  ASSERT_TRUE(ros::service::call("object_mapping/query", query));
  ASSERT_EQ(query.response.objects.size(), 1u);
  query.request.box_min.x = 1.5, query.request.box_min.y = 0.9, query.request.box_min.z = 0.0;
  query.request.box_max.x = 1.9, query.request.box_max.y = 1.3, query.request.box_max.z = 1.0;
  ASSERT_TRUE(ros::service::call("object_mapping/query", query));
  EXPECT_TRUE(query.response.success);
  EXPECT_TRUE(query.response.objects.empty());
  query.request.class_name = "";
  ASSERT_TRUE(ros::service::call("object_mapping/query", query));
  EXPECT_EQ(query.response.objects.size(), 1u);
  query.request.box_max.x = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(ros::service::call("object_mapping/query", query));
  EXPECT_FALSE(query.response.success);
  query = semantic_slam::Query();
  query.request.class_name = "unicorn";
  ASSERT_TRUE(ros::service::call("object_mapping/query", query));
  EXPECT_FALSE(query.response.success);
  EXPECT_NE(query.response.message.find("unicorn"), std::string::npos);
}

TEST_F(ObjectMappingNodeTest, DropsAndCountsWhatCannotBeUsedAndLives) {
  Map();
  const int bad_before = WaitForDrops("bad_tracked_objects", 0);
  std::vector<ObjectTracks> bad;
  for (int i = 0; i < 4; ++i) bad.push_back(Tracks(NextStamp()));
  ++bad[0].vocabulary_hash;
  bad[1].tracks[0].detection.label = 200;
  bad[2].tracks[0].detection.box.x = std::numeric_limits<float>::quiet_NaN();
  bad[3].image_size = {640, 480};
  for (const ObjectTracks& tracks : bad) {
    SendImages(tracks.stamp);
    Send(Tracked(tracks.stamp));
    Send(tracks);
    SpinUntil([] { return false; }, 0.3);
  }
  EXPECT_GE(WaitForDrops("bad_tracked_objects", bad_before + 4), bad_before + 4);

  TrackedImage lost = Tracked(NextStamp());
  lost.status = semantic_slam::TrackingStatus::kLost;
  SendImages(lost.stamp);
  Send(lost);
  Send(Tracks(lost.stamp));
  EXPECT_GE(WaitForDrops("not_tracked", 1), 1);
  const Stamp unknown = NextStamp();  // no image of that stamp is tracked
  SendImages(unknown);
  Send(Tracks(unknown));
  SpinUntil([] { return false; }, 0.3);
  Send(Tracked(NextStamp()));
  EXPECT_GE(WaitForDrops("no_pose", 1), 1);
  Send(Tracks(Stamp()));
  EXPECT_GE(WaitForDrops("bad_stamp", 1), 1);
  Send(Tracks(NextStamp()));  // its images never come
  SendAll(NextStamp());
  EXPECT_GE(WaitForDrops("no_images", 1), 1);

  // Boxes off the image are no fault.
  ObjectTracks off = Tracks(NextStamp());
  for (ObjectTrack& track : off.tracks) track.detection.box.x += 5000.0f;
  SendImages(off.stamp);
  Send(Tracked(off.stamp));
  Send(off);

  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("object_mapping/reset", reset));
  ASSERT_TRUE(SpinUntil([&] { return Count() == 0; }, kLimitS));
  Map();
  EXPECT_EQ(WaitForDrops("bad_tracked_objects", 0), bad_before + 4);
}

TEST_F(ObjectMappingNodeTest, SavesAndPauses) {
  Map();
  const semantic_slam::TemporaryFolder folder;
  semantic_slam::SaveMap save;
  ASSERT_TRUE(ros::service::call("object_mapping/save_map", save));
  EXPECT_FALSE(save.response.success) << "the path is empty, and there is no ~output_directory";
  save.request.path = folder / "map";
  ASSERT_TRUE(ros::service::call("object_mapping/save_map", save));
  EXPECT_TRUE(save.response.success) << save.response.message;
  EXPECT_TRUE(std::filesystem::exists(folder / "map/objects.json"));
  save.request.path = "/proc/nowhere";
  ASSERT_TRUE(ros::service::call("object_mapping/save_map", save));
  EXPECT_FALSE(save.response.success);

  std_srvs::SetBool pause;
  pause.request.data = true;
  ASSERT_TRUE(ros::service::call("object_mapping/pause", pause));
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("object_mapping/reset", reset));
  ASSERT_TRUE(SpinUntil([&] { return Count() == 0; }, kLimitS));
  for (int i = 0; i < 6; ++i) SendAll(NextStamp());
  EXPECT_FALSE(SpinUntil([&] { return Count() > 0; }, 1.0));
  pause.request.data = false;
  ASSERT_TRUE(ros::service::call("object_mapping/pause", pause));
  Map();
}

TEST_F(ObjectMappingNodeTest, WritesTheMapOnShutdown) {
  const semantic_slam::TemporaryFolder folder;
  ros::param::set("~saving/labels", SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  ros::param::set("~saving/output_directory", folder / "run");
  { const ObjectMappingNode node(ros::NodeHandle("saving"), ros::NodeHandle("~saving")); }
  EXPECT_TRUE(std::filesystem::exists(folder / "run/objects.json"));
}

TEST_F(ObjectMappingNodeTest, RefusesParametersThatCannotBe) {
  const auto error_of = [](const std::string& name) {
    return semantic_slam::MessageOf<semantic_slam::ConfigError>(
        [&] { ObjectMappingNode(ros::NodeHandle(name), ros::NodeHandle("~" + name)); });
  };
  semantic_slam::ExpectOneLineWith(error_of("unset"), {"unset/labels is empty"});
  ros::param::set("~bad/labels", SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  ros::param::set("~bad/mapper/ignored_classes", "unicorn");
  semantic_slam::ExpectOneLineWith(error_of("bad"), {"ignored_classes", "unicorn"});
  ros::param::set("~bad/mapper/ignored_classes", "");
  ros::param::set("~bad/map_frame", "/");
  semantic_slam::ExpectOneLineWith(error_of("bad"), {"map_frame"});
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "object_mapping_node_test");
  return RUN_ALL_TESTS();
}
