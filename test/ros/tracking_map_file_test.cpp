// tracking_node with ~map_file, which is there before the node is.

#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <semantic_slam/TrackingState.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "ros/child_process.h"
#include "ros/ros_testing.h"
#include "semantic_slam/localization/visual_localization.h"
#include "semantic_slam_ros/conversions.h"
#include "testing/room_sequence.h"
#include "testing/temporary_folder.h"
#include "testing/textured_room.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::CameraIntrinsics;
using semantic_slam::RgbdImage;
using semantic_slam::TrackedImage;
using StateMsg = semantic_slam::TrackingState;

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 20.0;
constexpr int kMappedImages = 10;

class TrackingMapFileTest : public testing::Test {
 protected:
  TrackingMapFileTest() : map_file_(folder_ / "room.map") {
    broadcaster_.sendTransform(
        ToTransformStamped(Stamp(), "base_link", kCameraFrame, Rigid3d::Identity()));
    const auto source = semantic_slam::MakeRoomSequence(1.0);
    while (auto image = source->Next()) images_.push_back(std::move(*image));
    KeepMap();
  }

  // The map of the first images, made without any node.
  void KeepMap() {
    semantic_slam::VisualLocalization localization(
        semantic_slam::LocalizationOptions(),
        std::make_shared<const semantic_slam::CameraModel>(intrinsics_),
        semantic_slam::MappingMode::kInline);
    for (int i = 0; i < kMappedImages; ++i) mapped_.push_back(localization.Track(images_[i]));
    localization.SaveMap(map_file_);
  }

  void StartNode(const std::string& more) {
    node_.emplace(std::vector<std::string>{SEMANTIC_SLAM_PROGRAM_DIR "/tracking_node",
                                           "__name:=tracking", "_map_file:=" + map_file_, more});
    ASSERT_TRUE(SpinUntil(
        [&] {
          return states_.connected() && colour_pub_.getNumSubscribers() > 0 &&
                 depth_pub_.getNumSubscribers() > 0 && info_pub_.getNumSubscribers() > 0;
        },
        kLimitS));
  }

  // Sends the image, a little later each time, until `done`; whether it came to that.
  template <typename Done>
  bool SendUntil(int image, const CameraIntrinsics& intrinsics, Done done) {
    for (int attempt = 0; attempt < 20 && !done(); ++attempt) {
      const RgbdImage& sent = images_[image];
      stamp_ = Stamp{sent.stamp.ns + 1'000'000'000 + 1'000'000 * attempt};
      const std_msgs::Header header = MakeHeader(*stamp_, kCameraFrame);
      info_pub_.publish(ToCameraInfo(intrinsics, header));
      colour_pub_.publish(ToImage(ColourImage{sent.colour, sent.order}, header));
      depth_pub_.publish(ToImage(sent.depth_m, "32FC1", header));
      SpinUntil(done, 1.0);
    }
    return done();
  }

  const semantic_slam::TemporaryFolder folder_;
  const std::string map_file_;
  const CameraIntrinsics intrinsics_ = semantic_slam::Freiburg1Camera().intrinsics;
  std::vector<RgbdImage> images_;
  std::vector<TrackedImage> mapped_;
  std::optional<Stamp> stamp_;  // of the image sent last

  ros::NodeHandle nh_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  Listener<StateMsg> states_{nh_, "tracking_state"};
  ros::Publisher colour_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
  ros::Publisher depth_pub_ = nh_.advertise<sensor_msgs::Image>("depth_registered/image_raw", 10);
  ros::Publisher info_pub_ = nh_.advertise<sensor_msgs::CameraInfo>("rgb/camera_info", 10, true);
  std::optional<ChildProcess> node_;
};

TEST_F(TrackingMapFileTest, TheNodeBeginsInTheMap) {
  StartNode("_mapping:=false");
  const int image = kMappedImages / 2;
  ASSERT_TRUE(SendUntil(image, intrinsics_, [&] { return states_.count() > 0; }));
  const StateMsg state = *states_.last();
  ASSERT_EQ(state.state, StateMsg::STATE_TRACKING);
  EXPECT_LE(state.keyframe_id, mapped_.back().keyframe_id);
  const Rigid3d moved = mapped_[image].T_map_camera.inverse() * ToRigid(state.T_map_camera);
  // The same image in the same map; adjusted since, by less than depth's noise of a centimetre.
  EXPECT_LT(moved.translation().norm(), 0.02);
}

TEST_F(TrackingMapFileTest, TheMapOfAnotherCameraEndsTheNode) {
  StartNode("_mapping:=false");
  CameraIntrinsics other = intrinsics_;
  other.fx_px += 20.0;
  EXPECT_TRUE(SendUntil(0, other, [&] { return !node_->Running(); }));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tracking_map_file_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
