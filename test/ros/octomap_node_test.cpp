// Drives octomap_node, as a node and as a nodelet (octomap_node.test, octomap_nodelet.test), over
// real topics with clouds of a wall.

#include "semantic_slam_ros/octomap_node.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>

#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <semantic_slam/ClearBox.h>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/LabelSet.h>
#include <semantic_slam/LoadMap.h>
#include <semantic_slam/QueryMap.h>
#include <semantic_slam/SaveMap.h>
#include <semantic_slam/TrackingState.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include "ros/ros_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/tracking_conversions.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::KeyframeGraph;
using semantic_slam::LabelOf;
using semantic_slam::SemanticCloud;
using semantic_slam::TrackedImage;
using semantic_slam::Vocabulary;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 20.0;

class OctomapNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return cells_.connected() && markers_.connected() && cloud_pub_.getNumSubscribers() > 0 &&
                 state_pub_.getNumSubscribers() > 0 && graph_pub_.getNumSubscribers() > 0;
        },
        kLimitS))
        << "the node did not connect; is it running?";
    // Each test begins in a map of its own.
    ++map_id_;
    SendGraph(0.0);
    SpinUntil([] { return false; }, 0.3);
    cells_.Forget();
    markers_.Forget();
  }

  // Stamps go on from test to test.
  static Stamp NextStamp() {
    static std::int64_t ns = 1'000'000'000'000;
    return Stamp{ns += 100'000'000};
  }

  // One keyframe, at (x, 0, 1), that looks along the map's x.
  void SendGraph(double x) {
    KeyframeGraph graph;
    graph.map_id = map_id_;
    graph.revision = ++revision_;
    graph.keyframes.emplace_back();
    graph.keyframes[0].id = map_id_;
    graph.keyframes[0].stamp = NextStamp();
    Rigid3d& pose = graph.keyframes[0].T_map_keyframe;
    pose.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    pose.translation() << x, 0.0, 1.0;
    graph_pub_.publish(ToKeyframeArray(graph, "map"));
  }

  TrackedImage Tracked(Stamp stamp) const {
    TrackedImage image;
    image.stamp = stamp;
    image.status = semantic_slam::TrackingStatus::kTracking;
    image.map_id = map_id_;
    image.keyframe_id = map_id_;
    return image;
  }

  // A wall of tables, 2 m ahead.
  static SemanticCloud Wall(Stamp stamp) {
    SemanticCloud cloud;
    cloud.stamp = stamp;
    cloud.vocabulary_hash = Vocabulary().hash();
    const semantic_slam::LabelId table = LabelOf("table");
    for (float x = -0.99f; x < 1.0f; x += 0.03f) {
      for (float y = -0.49f; y < 0.5f; y += 0.03f) {
        cloud.points.push_back({{x, y, 2.02f}, {10, 20, 30}, {table, 0, 0}, {0.8f, 0.0f, 0.0f}});
      }
    }
    return cloud;
  }

  void Send(const SemanticCloud& cloud) { cloud_pub_.publish(ToPointCloud2(cloud, kCameraFrame)); }
  void Send(const TrackedImage& image) {
    state_pub_.publish(ToTrackingState(image, "map", kCameraFrame));
  }

  // Sends clouds until the map shows that it has them.
  void Map() {
    for (int attempt = 0; attempt < 10; ++attempt) {
      const Stamp stamp = NextStamp();
      Send(Tracked(stamp));
      Send(Wall(stamp));
      if (SpinUntil([&] { return CellCount() > 0; }, 2.0)) return;
    }
    ADD_FAILURE() << "no cells of a cloud";
  }

  std::size_t CellCount() const { return cells_.last() ? cells_.last()->width : 0; }

  bool HasCubes() const {
    if (!markers_.last()) return false;
    const auto& markers = markers_.last()->markers;
    return std::any_of(markers.begin(), markers.end(),
                       [](const Marker& marker) { return !marker.points.empty(); });
  }

  // The classes of the newest legend.
  std::set<std::string> LegendNames() const {
    std::set<std::string> names;
    if (!legend_.last()) return names;
    for (const Marker& marker : legend_.last()->markers) names.insert(marker.text);
    return names;
  }

  // The mean x of the cells, in the map.
  double MeanX() const {
    const auto& msg = *cells_.last();
    double sum = 0.0;
    for (std::size_t i = 0; i < msg.width; ++i) {
      float x = 0.0f;
      std::memcpy(&x, msg.data.data() + i * msg.point_step + msg.fields[0].offset, sizeof(x));
      sum += x;
    }
    return sum / msg.width;
  }

  int WaitForDrops(const std::string& cause, int at_least) {
    int value = 0;
    SpinUntil(
        [&] {
          if (!diagnostics_.last()) return false;
          const std::string text = DiagnosticValue(*diagnostics_.last(), "dropped: " + cause);
          if (!text.empty()) value = std::stoi(text);
          return value >= at_least;
        },
        5.0);
    return value;
  }

  static int map_id_;
  static std::uint64_t revision_;
  ros::NodeHandle nh_;
  Listener<sensor_msgs::PointCloud2> cells_{nh_, "occupied_cells"};
  Listener<MarkerArray> markers_{nh_, "occupied_cells_vis_array"};
  Listener<MarkerArray> legend_{nh_, "legend"};
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
  ros::Publisher cloud_pub_ = nh_.advertise<sensor_msgs::PointCloud2>("semantic_cloud", 10);
  ros::Publisher state_pub_ = nh_.advertise<semantic_slam::TrackingState>("tracking_state", 10);
  ros::Publisher graph_pub_ = nh_.advertise<semantic_slam::KeyframeArray>("keyframes", 10, true);
};

int OctomapNodeTest::map_id_ = 0;
std::uint64_t OctomapNodeTest::revision_ = 0;

TEST_F(OctomapNodeTest, MapsTheCloudWhereItsImageWas) {
  Map();
  EXPECT_EQ(cells_.last()->header.frame_id, "map");
  EXPECT_FALSE(cells_.last()->header.stamp.isZero());
  EXPECT_NEAR(CellCount(), 40 * 20, 90);  // of 5 cm; the wall's rim may lie across one more
  EXPECT_NEAR(MeanX(), 2.025, 1e-4);      // a voxel's centre, float
}

TEST_F(OctomapNodeTest, ShowsCubesAndTheirLegend) {
  Map();
  // What was shown of the empty map may still be on its way.
  ASSERT_TRUE(SpinUntil([&] { return HasCubes() && LegendNames().count("table") == 1; }, kLimitS));
  ASSERT_EQ(markers_.last()->markers.size(), 17u);
  std::size_t cubes = 0;
  for (const Marker& marker : markers_.last()->markers) {
    EXPECT_EQ(marker.action == Marker::DELETE, marker.points.empty());
    EXPECT_EQ(marker.points.size(), marker.colors.size());
    cubes += marker.points.size();
  }
  EXPECT_EQ(cubes, CellCount());
  EXPECT_NEAR(markers_.last()->markers[16].scale.x, 0.05, 1e-9);
}

TEST_F(OctomapNodeTest, WhoComesLateGetsTheMapAndTheLabels) {
  Map();
  Listener<sensor_msgs::PointCloud2> late(nh_, "occupied_cells");
  Listener<semantic_slam::LabelSet> labels(nh_, "labels");
  ASSERT_TRUE(SpinUntil([&] { return late.last() && labels.last(); }, kLimitS));
  EXPECT_EQ(late.last()->width, cells_.last()->width);
  EXPECT_EQ(labels.last()->hash, Vocabulary().hash());
}

TEST_F(OctomapNodeTest, FollowsTheKeyframes) {
  Map();
  SendGraph(0.3);
  EXPECT_TRUE(SpinUntil([&] { return std::abs(MeanX() - 2.325) < 1e-3; }, kLimitS)) << MeanX();
}

TEST_F(OctomapNodeTest, TellsWhatIsWhere) {
  Map();
  semantic_slam::QueryMap query;
  query.request.class_name = "table";
  query.request.point.x = 2.02;
  query.request.point.z = 1.0;
  ASSERT_TRUE(ros::service::call("octomap/query", query));
  const auto& found = query.response;
  ASSERT_TRUE(found.success) << found.message;
  EXPECT_EQ(found.header.frame_id, "map");
  ASSERT_EQ(found.classes.size(), 1u);
  EXPECT_EQ(found.classes[0].name, "table");
  EXPECT_EQ(found.classes[0].voxels, CellCount());
  EXPECT_NEAR(found.classes[0].volume, static_cast<double>(CellCount()) * 0.05 * 0.05 * 0.05, 1e-9);
  EXPECT_TRUE(found.found);
  EXPECT_NEAR(found.nearest.x, 2.025, 1e-4);
  EXPECT_EQ(found.state, semantic_slam::QueryMap::Response::OCCUPIED);
  ASSERT_FALSE(found.names.empty());
  EXPECT_EQ(found.names[0], "table");
  EXPECT_NEAR(found.probabilities[0], 0.8, 0.01);

  query.request.class_name = "unicorn";
  ASSERT_TRUE(ros::service::call("octomap/query", query));
  EXPECT_FALSE(query.response.success);
  semantic_slam::ExpectOneLineWith(query.response.message, {"unicorn"});
  query.request.class_name = "";
  query.request.point.x = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(ros::service::call("octomap/query", query));
  EXPECT_FALSE(query.response.success);
}

TEST_F(OctomapNodeTest, ClearsABox) {
  Map();
  const std::size_t before = CellCount();
  semantic_slam::ClearBox clear;
  ASSERT_TRUE(ros::service::call("octomap/clear_box", clear));
  EXPECT_FALSE(clear.response.success);
  clear.request.box_min.y = 0.0;
  clear.request.box_max.x = clear.request.box_max.y = clear.request.box_max.z = 5.0;
  ASSERT_TRUE(ros::service::call("octomap/clear_box", clear));
  EXPECT_TRUE(clear.response.success) << clear.response.message;
  EXPECT_TRUE(SpinUntil([&] { return CellCount() > 0 && CellCount() < before * 2 / 3; }, kLimitS));
}

TEST_F(OctomapNodeTest, ShowsTheMapFromAbove) {
  Listener<nav_msgs::OccupancyGrid> projected(nh_, "projected_map");
  Map();
  const auto occupied = [&] {
    return projected.last()
               ? std::count(projected.last()->data.begin(), projected.last()->data.end(), 100)
               : 0;
  };
  ASSERT_TRUE(SpinUntil([&] { return occupied() > 0; }, kLimitS));
  EXPECT_NEAR(static_cast<double>(occupied()), 40.0, 2.0);  // the wall, 2 m by one voxel
  EXPECT_EQ(projected.last()->header.frame_id, "map");
  EXPECT_FLOAT_EQ(projected.last()->info.resolution, 0.05f);
}

TEST_F(OctomapNodeTest, LoadsWhatItSavedAndRefusesWhatIsNoMap) {
  const semantic_slam::TemporaryFolder folder;
  Map();
  const std::size_t before = CellCount();
  semantic_slam::SaveMap save;
  save.request.path = folder.path();
  ASSERT_TRUE(ros::service::call("octomap/save_map", save));
  ASSERT_TRUE(save.response.success) << save.response.message;

  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("octomap/reset", reset));
  ASSERT_TRUE(SpinUntil([&] { return CellCount() == 0; }, kLimitS));
  semantic_slam::LoadMap load;
  load.request.path = folder.path() + "/semantic_map.bt";
  ASSERT_TRUE(ros::service::call("octomap/load_map", load));
  EXPECT_FALSE(load.response.success);
  semantic_slam::ExpectOneLineWith(load.response.message, {"semantic_map.bt"});
  load.request.path = folder.path();
  ASSERT_TRUE(ros::service::call("octomap/load_map", load));
  ASSERT_TRUE(load.response.success) << load.response.message;
  EXPECT_TRUE(SpinUntil([&] { return CellCount() == before; }, kLimitS));

  // What is cut short is refused, and the map stays.
  std::filesystem::resize_file(folder.path() + "/semantic_map.ot", 2000);
  ASSERT_TRUE(ros::service::call("octomap/load_map", load));
  EXPECT_FALSE(load.response.success);
  semantic_slam::ExpectOneLineWith(load.response.message, {"semantic_map.ot"});
  semantic_slam::QueryMap query;
  ASSERT_TRUE(ros::service::call("octomap/query", query));
  ASSERT_EQ(query.response.classes.size(), 1u);
  EXPECT_EQ(query.response.classes[0].voxels, before);
}

TEST_F(OctomapNodeTest, AnotherMapBeginsEmpty) {
  Map();
  ++map_id_;
  SendGraph(1.0);
  EXPECT_TRUE(SpinUntil([&] { return CellCount() == 0; }, kLimitS));
  Map();
  EXPECT_NEAR(MeanX(), 3.025, 1e-4);
}

TEST_F(OctomapNodeTest, DropsAndCountsWhatCannotBeUsedAndLives) {
  const auto send_pair = [&](const SemanticCloud& cloud) {
    Send(Tracked(cloud.stamp));
    Send(cloud);
    SpinUntil([] { return false; }, 0.2);  // or the next would push it out of the queue
  };
  Map();
  const int bad_before = WaitForDrops("bad_cloud", 0);
  SemanticCloud unknown_label = Wall(NextStamp());
  unknown_label.points[5].labels[0] = 250;
  send_pair(unknown_label);
  SemanticCloud no_probability = Wall(NextStamp());
  no_probability.points[5].confidences[0] = std::numeric_limits<float>::quiet_NaN();
  send_pair(no_probability);
  const Stamp stamp = NextStamp();
  Send(Tracked(stamp));
  const auto cut = ToPointCloud2(Wall(stamp), kCameraFrame);
  cut->data.resize(100);
  cloud_pub_.publish(cut);
  EXPECT_GE(WaitForDrops("bad_cloud", bad_before + 3), bad_before + 3);

  // Empty and all-NaN clouds are no fault.
  SemanticCloud nothing = Wall(NextStamp());
  for (auto& point : nothing.points)
    point.position.setConstant(std::numeric_limits<float>::quiet_NaN());
  send_pair(nothing);
  SemanticCloud empty = Wall(NextStamp());
  empty.points.clear();
  send_pair(empty);

  TrackedImage lost = Tracked(NextStamp());
  lost.status = semantic_slam::TrackingStatus::kLost;
  Send(lost);
  Send(Wall(lost.stamp));
  EXPECT_GE(WaitForDrops("not_tracked", 1), 1);
  TrackedImage elsewhere = Tracked(NextStamp());
  elsewhere.keyframe_id += 1000;
  Send(elsewhere);
  Send(Wall(elsewhere.stamp));
  EXPECT_GE(WaitForDrops("unknown_keyframe", 1), 1);
  Send(Wall(NextStamp()));  // no image of that stamp was tracked
  Send(Tracked(NextStamp()));
  EXPECT_GE(WaitForDrops("no_pose", 1), 1);
  Send(Wall(Stamp()));
  EXPECT_GE(WaitForDrops("bad_stamp", 1), 1);
  semantic_slam::KeyframeArray broken;
  broken.keyframes.resize(1);
  graph_pub_.publish(broken);
  EXPECT_GE(WaitForDrops("bad_keyframes", 1), 1);

  cells_.Forget();
  Map();
  EXPECT_EQ(WaitForDrops("bad_cloud", 0), bad_before + 3);
}

TEST_F(OctomapNodeTest, SavesResetsAndPauses) {
  Map();
  const semantic_slam::TemporaryFolder folder;
  semantic_slam::SaveMap save;
  ASSERT_TRUE(ros::service::call("octomap/save_map", save));
  EXPECT_FALSE(save.response.success) << "the path is empty, and there is no ~output_directory";
  save.request.path = folder / "map";
  ASSERT_TRUE(ros::service::call("octomap/save_map", save));
  EXPECT_TRUE(save.response.success) << save.response.message;
  for (const char* file : {"semantic_map.ot", "semantic_map_colour.ot", "semantic_map.bt",
                           "semantic_map.ply", "map_top.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("map/" + std::string(file)))) << file;
  }
  const auto tree = semantic_slam::ReadSemanticTree(folder / "map/semantic_map.ot", Vocabulary());
  const semantic_slam::SemanticNode* wall = tree->search(2.025, 0.0, 1.0);
  ASSERT_NE(wall, nullptr);
  EXPECT_EQ(wall->labels().label(0), LabelOf("table"));
  save.request.path = "/proc/nowhere";
  ASSERT_TRUE(ros::service::call("octomap/save_map", save));
  EXPECT_FALSE(save.response.success);

  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("octomap/reset", reset));
  EXPECT_TRUE(reset.response.success);
  EXPECT_TRUE(SpinUntil([&] { return CellCount() == 0; }, kLimitS));

  std_srvs::SetBool pause;
  pause.request.data = true;
  ASSERT_TRUE(ros::service::call("octomap/pause", pause));
  const Stamp stamp = NextStamp();
  Send(Tracked(stamp));
  Send(Wall(stamp));
  EXPECT_FALSE(SpinUntil([&] { return CellCount() > 0; }, 1.0));
  pause.request.data = false;
  ASSERT_TRUE(ros::service::call("octomap/pause", pause));
  Map();
}

TEST_F(OctomapNodeTest, WritesTheMapOnShutdown) {
  const semantic_slam::TemporaryFolder folder;
  ros::param::set("~saving/labels", SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  ros::param::set("~saving/output_directory", folder / "run");
  { const OctomapNode node(ros::NodeHandle("saving"), ros::NodeHandle("~saving")); }
  EXPECT_EQ(semantic_slam::ReadSemanticTree(folder / "run/semantic_map.ot", Vocabulary())->size(),
            0u);
}

TEST_F(OctomapNodeTest, RefusesParametersThatCannotBe) {
  const auto error_of = [](const std::string& name) {
    return semantic_slam::MessageOf<semantic_slam::ConfigError>(
        [&] { OctomapNode(ros::NodeHandle(name), ros::NodeHandle("~" + name)); });
  };
  semantic_slam::ExpectOneLineWith(error_of("unset"), {"unset/labels is empty"});
  ros::param::set("~bad/labels", SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  ros::param::set("~bad/colour_mode", "heat");
  semantic_slam::ExpectOneLineWith(error_of("bad"), {"colour_mode = heat", "class, rgb, height"});
  ros::param::set("~bad/colour_mode", "rgb");
  ros::param::set("~bad/map/transient_classes", "unicorn");
  semantic_slam::ExpectOneLineWith(error_of("bad"), {"'unicorn' is not in the vocabulary"});
  ros::param::set("~bad/map/transient_classes", "");
  ros::param::set("~bad/fusion/rule", "mean");
  semantic_slam::ExpectOneLineWith(error_of("bad"), {"rule = mean"});
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "octomap_node_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
