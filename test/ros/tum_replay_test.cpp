// Plays three seconds of a bag through launch/tum_replay.launch and looks at every output topic that
// docs/ros_api.md lists: on the rendered room, and on fr1_desk where it is at hand.

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <nlohmann/json.hpp>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include "ros/ros_testing.h"
#include "semantic_slam_ros/tum_bag.h"
#include "testing/room_sequence.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::TemporaryFolder;
using StateMsg = semantic_slam::TrackingState;

constexpr double kPlayedS = 3.0;

// roslaunch as a child process; stopped as Ctrl-C would if it is still there at the end.
class Launch {
 public:
  explicit Launch(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ == 0) {
      ::execvp(argv[0], argv.data());
      ::_exit(127);
    }
  }
  ~Launch() {
    if (Running()) ::kill(pid_, SIGINT);
    if (pid_ > 0) ::waitpid(pid_, nullptr, 0);
  }
  bool Running() {
    if (pid_ <= 0) return false;
    if (::waitpid(pid_, nullptr, WNOHANG) == 0) return true;
    pid_ = -1;
    return false;
  }

 private:
  pid_t pid_;
};

void ReplayAndCheck(const std::string& folder, const semantic_slam::CameraConfig& camera,
                    const std::string& camera_config) {
  TemporaryFolder out;
  TumBagOptions options;
  options.camera = camera;
  options.duration_s = kPlayedS;
  const TumBagReport bag = WriteTumBag(folder, out / "three_seconds.bag", options);
  ros::NodeHandle nh;
  Listener<StateMsg> states(nh, "/tracking_state");
  Listener<semantic_slam::KeyframeArray> keyframes(nh, "/keyframes");
  Listener<nav_msgs::Odometry> odometry(nh, "/odometry");
  Listener<nav_msgs::Path> path(nh, "/path");
  Listener<nav_msgs::Path> ground_truth(nh, "/ground_truth_path");
  Listener<sensor_msgs::PointCloud2> map_points(nh, "/map_points");
  Listener<sensor_msgs::Image> debug_image(nh, "/debug_image");
  Listener<tf2_msgs::TFMessage> tf(nh, "/tf");
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics(nh, "/diagnostics");

  // At half speed, with room in the queue: what is tested is the graph, not this machine.
  Launch launch({"roslaunch", "semantic_slam", "tum_replay.launch",
                 "bag:=" + (out / "three_seconds.bag"), "camera_config:=" + camera_config,
                 "output:=" + (out / "results"), "rate:=0.5", "queue_size:=200"});
  SpinUntil([&] { return !launch.Running(); }, 90.0);
  ASSERT_FALSE(launch.Running()) << "the launch file did not end with the bag";

  ASSERT_TRUE(states.last() && keyframes.last() && odometry.last() && path.last() &&
              ground_truth.last() && map_points.last() && debug_image.last() && tf.last() &&
              diagnostics.last());
  // roslaunch tells nobody when the bag is through: the last images may be cut off.
  EXPECT_GT(states.count(), 0.9 * static_cast<double>(bag.depth) - 5.0);
  EXPECT_EQ(states.last()->state, StateMsg::STATE_TRACKING);
  EXPECT_EQ(states.last()->child_frame_id, "openni_rgb_optical_frame");
  EXPECT_EQ(odometry.last()->header.frame_id, "odom");
  EXPECT_EQ(path.last()->header.frame_id, "map");
  EXPECT_GT(path.last()->poses.size(), 5u);
  EXPECT_EQ(ground_truth.last()->header.frame_id, "map");
  EXPECT_EQ(map_points.last()->header.frame_id, "map");
  EXPECT_GT(map_points.last()->width, 100u);
  EXPECT_EQ(debug_image.last()->width, 640u);
  EXPECT_FALSE(keyframes.last()->keyframes.empty());

  for (const char* name : {"trajectory.txt", "trajectory_live.txt", "keyframe_trajectory.txt",
                           "timing.csv", "summary.json", "trajectory.png"}) {
    EXPECT_TRUE(std::filesystem::exists(out / (std::string("results/") + name))) << name;
  }
  std::ifstream file(out / "results/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary["lost"], 0);
  EXPECT_EQ(summary["gravity"], "up from the imu");
  // 3 cm: three seconds of hand-held motion; a wrong frame or a wrong stamp costs more than that.
  EXPECT_LT(summary["trajectory_error"]["ate_rmse_m"].get<double>(), 0.03);
}

TEST(TumReplayTest, RenderedRoom) {
  TemporaryFolder room;
  semantic_slam::WriteRoomSequence(room / "room", kPlayedS);
  ReplayAndCheck(room / "room", semantic_slam::Freiburg1Camera(), room / "room/camera.yaml");
}

TEST(TumReplayTest, Freiburg1Desk) {
  const auto desk = semantic_slam::SharedData(semantic_slam::kFreiburg1Desk);
  SEMANTIC_SLAM_SKIP_WITHOUT(desk, semantic_slam::kFreiburg1Desk);
  const std::string config = SEMANTIC_SLAM_SOURCE_DIR "/config/tum_freiburg1.yaml";
  ReplayAndCheck(*desk, semantic_slam::LoadCameraConfig(config), config);
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tum_replay_test");
  return RUN_ALL_TESTS();
}
