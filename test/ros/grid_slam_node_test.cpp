// Drives grid_slam, as a node and as a nodelet (grid_slam_node.test, grid_slam_nodelet.test), over
// real topics with images of the textured room and the poses they were rendered at.

#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/SaveMap.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include "ros/ros_testing.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/grid_conversions.h"
#include "semantic_slam_ros/tracking_conversions.h"
#include "testing/small_room.h"
#include "testing/temporary_folder.h"
#include "testing/textured_room.h"

namespace semantic_slam_ros {
namespace {

using nav_msgs::OccupancyGrid;
using semantic_slam::KeyframeGraph;
using semantic_slam::OccupancyMap;
using semantic_slam::RgbdImage;
using semantic_slam::TexturedRoom;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 15.0;
constexpr double kHeightM = 2.05;  // the band is above everything in the room but its walls
constexpr double kPitchRad = 0.1;

// A camera near the middle of the room, turned to the left from +x and tilted down a little.
Rigid3d CameraAt(double yaw_rad) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  Rigid3d T = Rigid3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T.linear() = AngleAxisd(yaw_rad, Vector3d::UnitZ()) * T.linear() *
               AngleAxisd(-kPitchRad, Vector3d::UnitX());
  T.translation() << 0.1, 0.2, kHeightM;
  return T;
}

class GridSlamNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return scans_.connected() && maps_.connected() && diagnostics_.last() &&
                 colour_pub_.getNumSubscribers() > 0 && depth_pub_.getNumSubscribers() > 0 &&
                 info_pub_.getNumSubscribers() > 0 && state_pub_.getNumSubscribers() > 0 &&
                 keyframes_pub_.getNumSubscribers() > 0;
        },
        kLimitS))
        << "grid_slam did not connect; is it running?";
    info_pub_.publish(
        ToCameraInfo(semantic_slam::SmallIntrinsics(), MakeHeader(NextStamp(), kCameraFrame)));
    ++map_id_;  // each test begins in an empty map
  }

  static Stamp NextStamp() {
    static std::int64_t ns = 1'000'000'000'000;
    return Stamp{ns += 200'000'000};
  }

  TrackedImage TrackedAt(Stamp stamp, const Rigid3d& T_map_camera) const {
    TrackedImage image;
    image.stamp = stamp;
    image.status = TrackingStatus::kTracking;
    image.map_id = map_id_;
    image.keyframe_id = 10 * map_id_;
    image.T_map_camera = T_map_camera;
    image.T_keyframe_camera = CameraAt(0.0).inverse() * T_map_camera;
    return image;
  }

  void SendState(const TrackedImage& image) {
    state_pub_.publish(ToTrackingState(image, "map", kCameraFrame));
  }
  void SendImages(Stamp stamp, const RgbdImage& image) { SendImages(stamp, image, image.depth_m); }
  void SendImages(Stamp stamp, const RgbdImage& image, const cv::Mat& depth_m) {
    const std_msgs::Header header = MakeHeader(stamp, kCameraFrame);
    colour_pub_.publish(ToImage(ColourImage{image.colour, image.order}, header));
    depth_pub_.publish(ToImage(depth_m, "32FC1", header));
  }

  // Sends what the camera sees, with its pose, and waits for the scan. A node that has just come up
  // may miss an image: it is sent again, a little later.
  boost::shared_ptr<const sensor_msgs::LaserScan> Scan(const Rigid3d& T_map_camera) {
    for (int attempt = 0; attempt < 10; ++attempt) {
      const Stamp stamp = NextStamp();
      SendImages(stamp, semantic_slam::SmallRoomImage(T_map_camera, stamp));
      SendState(TrackedAt(stamp, T_map_camera));
      const auto answered = [&] {
        return scans_.last() && ToStamp(scans_.last()->header.stamp) == stamp;
      };
      if (SpinUntil(answered, 2.0)) return scans_.last();
    }
    ADD_FAILURE() << "no scan of an image";
    return boost::make_shared<sensor_msgs::LaserScan>();
  }

  // The first map that `accept` likes.
  template <typename Accept>
  OccupancyMap WaitForMap(Accept&& accept) {
    const bool found =
        SpinUntil([&] { return maps_.last() && accept(ToOccupancyMap(*maps_.last())); }, kLimitS);
    EXPECT_TRUE(found) << "no such map came";
    return maps_.last() ? ToOccupancyMap(*maps_.last()) : OccupancyMap();
  }

  // The map after the camera has turned around.
  OccupancyMap MapOfRoom() {
    for (int i = 0; i < 8; ++i) Scan(CameraAt(i * M_PI / 4));
    return WaitForMap([](const OccupancyMap& map) { return map.width > 95 && map.height > 75; });
  }

  void SendKeyframe(const Rigid3d& T_map_keyframe, std::uint64_t revision) {
    KeyframeGraph graph;
    graph.map_id = map_id_;
    graph.revision = revision;
    graph.keyframes.resize(1);
    graph.keyframes[0].id = 10 * map_id_;
    graph.keyframes[0].stamp = NextStamp();
    graph.keyframes[0].T_map_keyframe = T_map_keyframe;
    keyframes_pub_.publish(ToKeyframeArray(graph, "map"));
  }

  int Drops(const std::string& cause) const {
    if (!diagnostics_.last()) return 0;
    const std::string text = DiagnosticValue(*diagnostics_.last(), "dropped: " + cause);
    return text.empty() ? 0 : std::stoi(text);
  }
  ::testing::AssertionResult GrowsTo(const std::string& cause, int count) {
    if (SpinUntil([&] { return Drops(cause) >= count; }, 5.0)) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << cause << " is " << Drops(cause) << ", not " << count;
  }

  static int map_id_;

  ros::NodeHandle nh_;
  tf2_ros::Buffer tf_buffer_;
  tf2_ros::TransformListener tf_listener_{tf_buffer_, nh_};
  Listener<sensor_msgs::LaserScan> scans_{nh_, "scan"};
  Listener<OccupancyGrid> maps_{nh_, "map"};
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
  ros::Publisher colour_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
  ros::Publisher depth_pub_ = nh_.advertise<sensor_msgs::Image>("depth_registered/image_raw", 10);
  ros::Publisher info_pub_ = nh_.advertise<sensor_msgs::CameraInfo>("rgb/camera_info", 10, true);
  ros::Publisher state_pub_ = nh_.advertise<semantic_slam::TrackingState>("tracking_state", 10);
  ros::Publisher keyframes_pub_ = nh_.advertise<semantic_slam::KeyframeArray>("keyframes", 10);
};

int GridSlamNodeTest::map_id_ = 0;

TEST_F(GridSlamNodeTest, ScansTheWallInALevelFrameAtTheImagesStamp) {
  const auto scan = Scan(CameraAt(0.0));
  EXPECT_EQ(scan->header.frame_id, "camera_level");
  ASSERT_GT(scan->ranges.size(), 100u);
  // Straight ahead the wall at x = 2.5 m is 2.4 m away; half a degree to the side as good as that.
  EXPECT_NEAR(scan->ranges[scan->ranges.size() / 2], 2.4, 0.02);
  EXPECT_NEAR(scan->angle_min, -scan->angle_max, 1e-5);
  const ros::Time stamp = scan->header.stamp;
  ASSERT_TRUE(
      SpinUntil([&] { return tf_buffer_.canTransform(kCameraFrame, "camera_level", stamp); }, 5.0));
  const Rigid3d T_camera_level =
      ToRigid(tf_buffer_.lookupTransform(kCameraFrame, "camera_level", stamp).transform);
  const Rigid3d T_map_level = CameraAt(0.0) * T_camera_level;
  // Nothing but the camera's place and yaw, which is 0; messages hold rounded quaternions.
  EXPECT_TRUE(T_map_level.linear().isIdentity(1e-6));
  EXPECT_LT((T_map_level.translation() - CameraAt(0.0).translation()).norm(), 1e-6);
}

TEST_F(GridSlamNodeTest, LatchesTheFloorPlan) {
  const OccupancyMap map = MapOfRoom();
  // 5 m by 4 m in cells of 5 cm, and a cell or two for the walls at either side.
  EXPECT_LT(map.width, 106);
  EXPECT_LT(map.height, 86);
  EXPECT_NEAR(map.origin_m.x(), -TexturedRoom::kLengthM / 2, 0.151);
  EXPECT_NEAR(map.origin_m.y(), -TexturedRoom::kWidthM / 2, 0.151);
  EXPECT_EQ(maps_.last()->header.frame_id, "map");
  EXPECT_FALSE(maps_.last()->header.stamp.isZero());
  Listener<OccupancyGrid> late(nh_, "map");
  Listener<nav_msgs::MapMetaData> metadata(nh_, "map_metadata");
  ASSERT_TRUE(SpinUntil([&] { return late.last() && metadata.last(); }, kLimitS));
  EXPECT_EQ(late.last()->data, maps_.last()->data);
  EXPECT_EQ(metadata.last()->width, late.last()->info.width);
}

TEST_F(GridSlamNodeTest, MovesTheFloorPlanWithTheKeyframes) {
  const OccupancyMap before = MapOfRoom();
  SendKeyframe(CameraAt(0.0), 1);
  Rigid3d moved = CameraAt(0.0);
  moved.translation().x() += 1.0;
  SendKeyframe(moved, 2);
  const OccupancyMap after = WaitForMap([&](const OccupancyMap& map) {
    return std::abs(map.origin_m.x() - before.origin_m.x() - 1.0) < 1e-3;
  });
  EXPECT_EQ(after.width, before.width) << "moved by whole cells";
  EXPECT_EQ(after.height, before.height);
}

TEST_F(GridSlamNodeTest, ForgetsTheOldMapWithANewOne) {
  MapOfRoom();
  ++map_id_;
  Scan(CameraAt(0.0));
  WaitForMap([](const OccupancyMap& map) { return map.width > 0 && map.width < 60; });
}

TEST_F(GridSlamNodeTest, DropsAndCountsWhatItCannotUse) {
  Scan(CameraAt(0.0));
  const RgbdImage image = semantic_slam::SmallRoomImage(CameraAt(0.3), Stamp{1});
  const int no_pose = Drops("no_pose"), not_tracked = Drops("not_tracked");
  const int bad_image = Drops("bad_image"), nothing_seen = Drops("nothing_seen");
  // No TrackingState ever comes for the first, and the camera is lost at the second.
  SendImages(NextStamp(), image);
  TrackedImage lost = TrackedAt(NextStamp(), CameraAt(0.3));
  lost.status = TrackingStatus::kLost;
  SendImages(lost.stamp, image);
  SpinUntil([] { return false; }, 0.3);  // depth and colour must have become a pair
  SendState(lost);
  EXPECT_TRUE(GrowsTo("no_pose", no_pose + 1));
  EXPECT_TRUE(GrowsTo("not_tracked", not_tracked + 1));
  // Depth of another size, of the calibration's size but without a reading.
  const cv::Mat small(10, 10, CV_32FC1, cv::Scalar(1.0));
  const cv::Mat blind(image.depth_m.size(), CV_32FC1, cv::Scalar(std::nan("")));
  for (const cv::Mat& depth_m : {small, blind}) {
    const TrackedImage tracked = TrackedAt(NextStamp(), CameraAt(0.3));
    SendImages(tracked.stamp, image, depth_m);
    SendState(tracked);
  }
  EXPECT_TRUE(GrowsTo("bad_image", bad_image + 1));
  EXPECT_TRUE(GrowsTo("nothing_seen", nothing_seen + 1));
  // A pose that cannot be.
  const int bad_state = Drops("bad_tracking_state");
  auto broken = ToTrackingState(TrackedAt(NextStamp(), CameraAt(0.0)), "map", kCameraFrame);
  broken.T_map_camera.position.x = std::nan("");
  state_pub_.publish(broken);
  EXPECT_TRUE(GrowsTo("bad_tracking_state", bad_state + 1));
  EXPECT_FALSE(Scan(CameraAt(0.6))->ranges.empty()) << "and lives";
}

TEST_F(GridSlamNodeTest, SavesForMapServer) {
  MapOfRoom();
  const semantic_slam::TemporaryFolder folder;
  semantic_slam::SaveMap save;
  save.request.path = folder / "map";
  ASSERT_TRUE(ros::service::call("grid_slam/save_map", save));
  EXPECT_TRUE(save.response.success) << save.response.message;
  EXPECT_TRUE(std::filesystem::exists(folder / "map/grid.pgm"));
  EXPECT_TRUE(std::filesystem::exists(folder / "map/grid.yaml"));
}

TEST_F(GridSlamNodeTest, ForgetsOnRequest) {
  MapOfRoom();
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("grid_slam/reset", reset));
  EXPECT_TRUE(reset.response.success);
  WaitForMap([](const OccupancyMap& map) { return map.cells.empty(); });
  semantic_slam::SaveMap save;
  save.request.path = "/tmp";
  ASSERT_TRUE(ros::service::call("grid_slam/save_map", save));
  EXPECT_FALSE(save.response.success);
  EXPECT_EQ(save.response.message, "the map is still empty, so there is nothing to write");
}

TEST_F(GridSlamNodeTest, PausesAndGoesOn) {
  Scan(CameraAt(0.0));
  std_srvs::SetBool pause;
  pause.request.data = true;
  ASSERT_TRUE(ros::service::call("grid_slam/pause", pause));
  EXPECT_TRUE(pause.response.success);
  scans_.Forget();
  const TrackedImage tracked = TrackedAt(NextStamp(), CameraAt(0.5));
  SendImages(tracked.stamp, semantic_slam::SmallRoomImage(CameraAt(0.5), tracked.stamp));
  SendState(tracked);
  EXPECT_FALSE(SpinUntil([&] { return scans_.count() > 0; }, 1.0));
  pause.request.data = false;
  ASSERT_TRUE(ros::service::call("grid_slam/pause", pause));
  EXPECT_FALSE(Scan(CameraAt(0.5))->ranges.empty());
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "grid_slam_node_test");
  return RUN_ALL_TESTS();
}
