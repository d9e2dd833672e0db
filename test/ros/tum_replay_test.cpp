// Plays three seconds of a bag through launch/tum_replay.launch, the complete system, and looks at every
// output topic that docs/ros_api.md lists: on the rendered room with tiny networks, and on fr1_desk with
// real ones where they are at hand.

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <nlohmann/json.hpp>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <semantic_slam/SemanticGrid.h>
#include <semantic_slam/SemanticObjectArray.h>
#include <topic_tools/shape_shifter.h>

#include "ros/child_process.h"
#include "ros/ros_testing.h"
#include "semantic_slam_ros/tum_bag.h"
#include "testing/room_sequence.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::TemporaryFolder;
using StateMsg = semantic_slam::TrackingState;

constexpr double kPlayedS = 3.0;

// Every topic in a table "Published topics" of docs/ros_api.md, absolute; not of the nodes that fly a
// drone.
std::set<std::string> DocumentedTopics() {
  std::ifstream file(SEMANTIC_SLAM_SOURCE_DIR "/docs/ros_api.md");
  const std::regex row("^\\| `/?([a-z_/]+)` \\| [a-z0-9_]+/[A-Z].*");  // name and type
  std::set<std::string> topics;
  bool is_started = false, in_table = false;
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, 3, "## ") == 0) {
      is_started = line != "## simulator_node" && line != "## waypoint_controller_node";
    }
    if (line.compare(0, 2, "##") == 0) in_table = is_started && line == "### Published topics";
    std::smatch match;
    if (in_table && std::regex_match(line, match, row)) topics.insert("/" + match[1].str());
  }
  return topics;
}

struct Networks {
  std::string segmentation_card;
  std::string detection_card;
};

struct Played {
  std::string folder;
  semantic_slam::CameraConfig camera;
  std::string camera_config;
  Networks networks;
};

// Plays the bag and leaves the results in `results`. Returns how many pairs of images the bag has.
std::size_t Play(const Played& played, const TemporaryFolder& out) {
  TumBagOptions options;
  options.camera = played.camera;
  options.duration_s = kPlayedS;
  const TumBagReport bag = WriteTumBag(played.folder, out / "three_seconds.bag", options);
  // At half speed, with room in the queue: what is tested is the graph, not this machine.
  ChildProcess launch({"roslaunch", "semantic_slam", "tum_replay.launch",
                 "bag:=" + (out / "three_seconds.bag"), "camera_config:=" + played.camera_config,
                 "segmentation_card:=" + played.networks.segmentation_card,
                 "detection_card:=" + played.networks.detection_card,
                 "output:=" + (out / "results"), "rate:=0.5", "queue_size:=200"});
  SpinUntil([&] { return !launch.Running(); }, 120.0);
  EXPECT_FALSE(launch.Running()) << "the launch file did not end with the bag";
  return bag.depth;
}

void ExpectResults(const TemporaryFolder& out) {
  for (const char* name :
       {"trajectory.txt", "trajectory_live.txt", "keyframe_trajectory.txt", "timing.csv",
        "groundtruth.txt", "summary.json", "trajectory.png", "semantic_map.ot", "semantic_map.bt",
        "semantic_map.ply", "map_top.png", "objects.json", "grid.pgm", "grid.yaml", "semantic_grid.png"}) {
    EXPECT_TRUE(std::filesystem::exists(out / (std::string("results/") + name))) << name;
  }
  std::ifstream file(out / "results/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary["lost"], 0);
  EXPECT_EQ(summary["gravity"], "up from the imu");
  // 3 cm: three seconds of hand-held motion; a wrong frame or a wrong stamp costs more than that.
  EXPECT_LT(summary["trajectory_error"]["ate_rmse_m"].get<double>(), 0.03);
}

void ReplayAndCheck(const Played& played) {
  TemporaryFolder out;
  ros::NodeHandle nh;
  Listener<StateMsg> states(nh, "/tracking_state");
  Listener<semantic_slam::KeyframeArray> keyframes(nh, "/keyframes");
  Listener<nav_msgs::Odometry> odometry(nh, "/odometry");
  Listener<nav_msgs::Path> path(nh, "/path");
  Listener<sensor_msgs::PointCloud2> map_points(nh, "/map_points");
  Listener<sensor_msgs::PointCloud2> occupied_cells(nh, "/occupied_cells");
  Listener<semantic_slam::SemanticObjectArray> objects(nh, "/objects");
  Listener<semantic_slam::SemanticGrid> grid(nh, "/semantic_grid");
  std::map<std::string, std::unique_ptr<Listener<topic_tools::ShapeShifter>>> documented;
  for (const std::string& topic : DocumentedTopics()) {
    documented[topic] = std::make_unique<Listener<topic_tools::ShapeShifter>>(nh, topic);
  }
  ASSERT_GT(documented.size(), 25u) << "docs/ros_api.md is not read as it should be";

  const std::size_t pairs = Play(played, out);

  for (const auto& [topic, listener] : documented) EXPECT_GT(listener->count(), 0) << topic;
  ASSERT_TRUE(states.last() && keyframes.last() && odometry.last() && path.last() &&
              map_points.last() && occupied_cells.last() && objects.last() && grid.last());
  // The bag may end before its last images are through.
  EXPECT_GT(states.count(), 0.9 * static_cast<double>(pairs) - 5.0);
  EXPECT_EQ(states.last()->state, StateMsg::STATE_TRACKING);
  EXPECT_EQ(states.last()->child_frame_id, "openni_rgb_optical_frame");
  EXPECT_EQ(odometry.last()->header.frame_id, "odom");
  EXPECT_EQ(path.last()->header.frame_id, "map");
  EXPECT_GT(path.last()->poses.size(), 5u);
  EXPECT_GT(map_points.last()->width, 100u);
  EXPECT_GT(occupied_cells.last()->width, 100u);
  EXPECT_EQ(occupied_cells.last()->header.frame_id, "map");
  EXPECT_FALSE(keyframes.last()->keyframes.empty());
  EXPECT_EQ(grid.last()->label_set_hash, objects.last()->label_set_hash);
  EXPECT_GT(grid.last()->info.width, 10u);
  ExpectResults(out);
}

TEST(TumReplayTest, RenderedRoom) {
  TemporaryFolder room;
  semantic_slam::WriteRoomSequence(room / "room", kPlayedS);
  ReplayAndCheck({room / "room", semantic_slam::Freiburg1Camera(), room / "room/camera.yaml",
                  {semantic_slam::TinyNetworkCard("colour_segmenter"),
                   semantic_slam::TinyNetworkCard("block_detector")}});
}

TEST(TumReplayTest, Freiburg1Desk) {
  const auto desk = semantic_slam::SharedData(semantic_slam::kFreiburg1Desk);
  SEMANTIC_SLAM_SKIP_WITHOUT(desk, semantic_slam::kFreiburg1Desk);
  const auto models = semantic_slam::SharedData("models");
  SEMANTIC_SLAM_SKIP_WITHOUT(models, "models");
  const std::string config = SEMANTIC_SLAM_SOURCE_DIR "/config/";
  ReplayAndCheck({*desk, semantic_slam::LoadCameraConfig(config + "tum_freiburg1.yaml"),
                  config + "tum_freiburg1.yaml",
                  {config + "cards/deeplabv3p_mnv2_ade20k32_320x240.yaml",
                   config + "cards/yolov8n_coco_320x256.yaml"}});
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tum_replay_test");
  return RUN_ALL_TESTS();
}
