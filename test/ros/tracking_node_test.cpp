// Drives tracking, as a node and as a nodelet (tracking_node.test, tracking_nodelet.test), over real
// topics with images of the textured room.

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include <Eigen/Cholesky>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/LoadMap.h>
#include <semantic_slam/SaveMap.h>
#include <semantic_slam/SemanticImage.h>
#include <semantic_slam/TrackingState.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include "ros/ros_testing.h"
#include "semantic_slam/segmentation/segmentation.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "testing/expect_error.h"
#include "testing/room_sequence.h"
#include "testing/temporary_folder.h"
#include "testing/textured_room.h"

namespace semantic_slam_ros {
namespace {

using diagnostic_msgs::DiagnosticArray;
using semantic_slam::ExpectOneLineWith;
using semantic_slam::RgbdImage;
using semantic_slam::Trajectory;
using StateMsg = semantic_slam::TrackingState;

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 20.0;
constexpr double kSequenceS = 1.0;

// The camera 10 cm ahead of the base, looking ahead.
Rigid3d BaseFromCamera() {
  Rigid3d T_base_camera = Rigid3d::Identity();
  T_base_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T_base_camera.translation() << 0.1, 0.0, 0.0;
  return T_base_camera;
}

class TrackingNodeTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    images_ = new std::vector<RgbdImage>;
    const auto source = semantic_slam::MakeRoomSequence(kSequenceS);
    while (auto image = source->Next()) images_->push_back(std::move(*image));
    poses_ = new Trajectory(semantic_slam::RoomSequencePoses(kSequenceS));
  }
  static void TearDownTestSuite() {
    delete images_;
    delete poses_;
  }

  TrackingNodeTest() : tf_listener_(tf_buffer_, nh_) {
    static tf2_ros::StaticTransformBroadcaster broadcaster;
    broadcaster.sendTransform(
        ToTransformStamped(Stamp(), "base_link", kCameraFrame, BaseFromCamera()));
  }

  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return states_.connected() && keyframes_.connected() && odometry_.connected() &&
                 colour_pub_.getNumSubscribers() > 0 && depth_pub_.getNumSubscribers() > 0 &&
                 info_pub_.getNumSubscribers() > 0;
        },
        kLimitS))
        << "tracking did not connect; is it running?";
    // Each test begins in an empty map.
    std_srvs::Trigger trigger;
    ASSERT_TRUE(ros::service::call("tracking/reset", trigger));
    info_pub_.publish(ToCameraInfo(semantic_slam::Freiburg1Camera().intrinsics,
                                   MakeHeader(Now(), kCameraFrame)));
  }

  void TearDown() override { SetMapping(true); }

  static void SetMapping(bool on) {
    std_srvs::SetBool request;
    request.request.data = on;
    ASSERT_TRUE(ros::service::call("tracking/set_mapping", request));
    EXPECT_TRUE(request.response.success);
  }

  // Stamps go on from test to test: time on a robot only jumps when the test says so.
  static Stamp Now() { return Stamp{images_->front().stamp.ns + shift_ns_}; }
  static void Advance(double seconds) { shift_ns_ += static_cast<std::int64_t>(seconds * 1e9); }

  std_msgs::Header HeaderOf(Stamp stamp) const {
    return MakeHeader(HeaderStamp(stamp), kCameraFrame);
  }

  Stamp HeaderStamp(Stamp stamp) const { return Stamp{stamp.ns + shift_ns_}; }

  // Depth at colour's stamp, as a RealSense sends it: then a pair is certain as soon as it is there.
  void Send(const RgbdImage& image) {
    colour_pub_.publish(ToImage(ColourImage{image.colour, image.order}, HeaderOf(image.stamp)));
    depth_pub_.publish(ToImage(image.depth_m, "32FC1", HeaderOf(image.stamp)));
  }

  // Sends the image and waits for what tracking says of it. A node that has just come up, or has
  // just been reset, may miss images: those are sent again, a little later.
  StateMsg Track(const RgbdImage& image) {
    for (int attempt = 0; attempt < 20; ++attempt) {
      const ros::Time stamp = HeaderOf(image.stamp).stamp;
      Send(image);
      if (SpinUntil([&] { return states_.last() && states_.last()->header.stamp == stamp; }, 2.0)) {
        return *states_.last();
      }
      Advance(0.001);
    }
    ADD_FAILURE() << "no TrackingState for the image at " << ToString(image.stamp);
    return StateMsg();
  }

  std::vector<StateMsg> TrackSequence(std::size_t count) {
    std::vector<StateMsg> states;
    for (std::size_t i = 0; i < count; ++i) states.push_back(Track((*images_)[i]));
    return states;
  }

  // The count under `key` on /diagnostics once it is at least `at_least`, or as it stays.
  int WaitForDiagnostic(const std::string& key, int at_least) {
    int value = 0;
    SpinUntil(
        [&] {
          if (!diagnostics_.last()) return false;
          const std::string text = DiagnosticValue(*diagnostics_.last(), key);
          if (!text.empty()) value = std::stoi(text);
          return value >= at_least;
        },
        5.0);
    return value;
  }

  static std::vector<RgbdImage>* images_;
  static Trajectory* poses_;
  static std::int64_t shift_ns_;

  ros::NodeHandle nh_;
  tf2_ros::Buffer tf_buffer_;
  tf2_ros::TransformListener tf_listener_;
  Listener<StateMsg> states_{nh_, "tracking_state"};
  Listener<semantic_slam::KeyframeArray> keyframes_{nh_, "keyframes"};
  Listener<nav_msgs::Odometry> odometry_{nh_, "odometry"};
  Listener<DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
  ros::Publisher colour_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
  ros::Publisher depth_pub_ = nh_.advertise<sensor_msgs::Image>("depth_registered/image_raw", 10);
  ros::Publisher info_pub_ = nh_.advertise<sensor_msgs::CameraInfo>("rgb/camera_info", 10, true);
};

std::vector<RgbdImage>* TrackingNodeTest::images_ = nullptr;
Trajectory* TrackingNodeTest::poses_ = nullptr;
std::int64_t TrackingNodeTest::shift_ns_ = 0;

TEST_F(TrackingNodeTest, FollowsTheCameraAtTheImagesStamps) {
  const std::size_t count = images_->size();
  const std::vector<StateMsg> states = TrackSequence(count);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(states[i].state, StateMsg::STATE_TRACKING) << "image " << i;
    EXPECT_EQ(states[i].child_frame_id, kCameraFrame);
    EXPECT_EQ(states[i].header.frame_id, "map");
  }
  const Rigid3d moved = ToRigid(states.front().T_map_camera).inverse() *
                        ToRigid(states.back().T_map_camera);
  const Rigid3d truth = poses_->front().pose.inverse() * poses_->back().pose;
  // 2 cm: the rendered depth is noisy by about 1 cm at 2 m; hundreds of points average that out.
  EXPECT_LT((moved.inverse() * truth).translation().norm(), 0.02);
  EXPECT_GT(truth.translation().norm(), 0.05) << "the camera must move for this to say anything";
  Advance(10.0);
}

TEST_F(TrackingNodeTest, StartsUprightWithoutAnImu) {
  const Rigid3d T_map_camera = ToRigid(Track(images_->front()).T_map_camera);
  const Eigen::Vector3d up_camera = T_map_camera.linear().row(2);
  const Eigen::Vector3d true_up_camera = poses_->front().pose.linear().row(2);
  // 2 degrees: one image, and depth noise of a centimetre across a surface of half a metre.
  EXPECT_LT(std::acos(up_camera.dot(true_up_camera)), 2.0 * M_PI / 180.0);
  EXPECT_GT(std::acos(-true_up_camera.y()), 4.0 * M_PI / 180.0) << "level must not do as well";
  // The base begins at the origin.
  EXPECT_LT((T_map_camera * BaseFromCamera().inverse()).translation().norm(), 1e-9);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, ChainsMapOdomAndBaseAtTheImagesStamp) {
  const StateMsg state = TrackSequence(10).back();
  const ros::Time stamp = state.header.stamp;
  ASSERT_TRUE(SpinUntil([&] { return tf_buffer_.canTransform("map", kCameraFrame, stamp); }, 5.0));
  const Rigid3d T_map_camera =
      ToRigid(tf_buffer_.lookupTransform("map", kCameraFrame, stamp).transform);
  EXPECT_TRUE(T_map_camera.isApprox(ToRigid(state.T_map_camera), 1e-6));
  const Rigid3d T_odom_base = ToRigid(tf_buffer_.lookupTransform("odom", "base_link", stamp).transform);
  ASSERT_TRUE(SpinUntil([&] { return odometry_.last() && odometry_.last()->header.stamp == stamp; }, 5.0));
  EXPECT_EQ(odometry_.last()->header.frame_id, "odom");
  EXPECT_EQ(odometry_.last()->child_frame_id, "base_link");
  EXPECT_TRUE(ToRigid(odometry_.last()->pose.pose).isApprox(T_odom_base, 1e-6));
  Advance(10.0);
}

TEST_F(TrackingNodeTest, LatchesTheKeyframeGraph) {
  const StateMsg state = Track(images_->front());
  // State and graph come on two connections, in any order.
  ASSERT_TRUE(SpinUntil(
      [&] {
        return keyframes_.last() && keyframes_.last()->map_id == state.map_id &&
               !keyframes_.last()->keyframes.empty();
      },
      5.0));
  Listener<semantic_slam::KeyframeArray> late(nh_, "keyframes");
  ASSERT_TRUE(SpinUntil([&] { return late.last() && !late.last()->keyframes.empty(); }, 5.0));
  const auto& keyframes = late.last()->keyframes;
  EXPECT_EQ(late.last()->map_id, state.map_id);
  EXPECT_EQ(keyframes.back().id, state.keyframe_id);
  EXPECT_EQ(keyframes.back().stamp, state.header.stamp);
  EXPECT_EQ(keyframes.front().parent_id, semantic_slam::KeyframePose::NO_PARENT);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, DropsAndCountsBadImagesAndLives) {
  TrackSequence(3);
  const int before = WaitForDiagnostic("dropped: bad_image", 0);
  const Stamp stamp = (*images_)[3].stamp;
  const auto colour = ToImage(ColourImage{(*images_)[3].colour, (*images_)[3].order}, HeaderOf(stamp));
  // One of each kind, each with a stamp of its own: depth of another size, depth in an encoding
  // nobody knows, a message cut short, an empty one.
  const cv::Mat small(10, 10, CV_32FC1, cv::Scalar(1.0));
  std::vector<sensor_msgs::ImagePtr> depths{ToImage(small, "32FC1", HeaderOf(stamp)),
                                            ToImage((*images_)[3].depth_m, "32FC1", HeaderOf(stamp)),
                                            ToImage((*images_)[3].depth_m, "32FC1", HeaderOf(stamp)),
                                            boost::make_shared<sensor_msgs::Image>()};
  depths[1]->encoding = "yuv422";
  depths[2]->data.resize(1000);
  depths[3]->encoding = "32FC1";
  for (const sensor_msgs::ImagePtr& depth : depths) {
    sensor_msgs::Image sent = *colour;
    sent.header = depth->header = HeaderOf(stamp);
    colour_pub_.publish(sent);
    depth_pub_.publish(depth);
    SpinUntil([] { return false; }, 0.2);
    Advance(0.04);
  }
  EXPECT_GE(WaitForDiagnostic("dropped: bad_image", before + 4), before + 4);
  sensor_msgs::Image unstamped = *colour;
  unstamped.header.stamp = ros::Time();
  colour_pub_.publish(unstamped);
  EXPECT_GE(WaitForDiagnostic("dropped: bad_stamp", 1), 1);
  EXPECT_EQ(Track((*images_)[4]).state, StateMsg::STATE_TRACKING);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, KeepsItsCalibrationWhenABadOneComes) {
  const StateMsg before = TrackSequence(2).back();
  const int count = WaitForDiagnostic("dropped: bad_camera_info", 0);
  sensor_msgs::CameraInfo uncalibrated;
  uncalibrated.header = MakeHeader(Now(), kCameraFrame);
  info_pub_.publish(uncalibrated);
  EXPECT_GE(WaitForDiagnostic("dropped: bad_camera_info", count + 1), count + 1);
  const StateMsg after = Track((*images_)[2]);
  EXPECT_EQ(after.state, StateMsg::STATE_TRACKING);
  EXPECT_EQ(after.map_id, before.map_id);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, ANewCalibrationStartsANewMapAndGoesOnWithTheIds) {
  const StateMsg before = TrackSequence(3).back();
  ASSERT_TRUE(SpinUntil([&] { return keyframes_.last() != nullptr; }, kLimitS));
  const std::uint64_t revision = keyframes_.last()->revision;
  const cv::Rect middle(40, 20, 560, 440);  // what a driver's region of interest leaves
  semantic_slam::CameraIntrinsics intrinsics = semantic_slam::Freiburg1Camera().intrinsics;
  intrinsics.width_px = middle.width, intrinsics.height_px = middle.height;
  intrinsics.cx_px -= middle.x, intrinsics.cy_px -= middle.y;
  info_pub_.publish(ToCameraInfo(intrinsics, MakeHeader(Now(), kCameraFrame)));
  StateMsg after;
  for (int i = 3; i < 6; ++i) {
    RgbdImage image = (*images_)[i];
    image.colour = image.colour(middle).clone();
    image.depth_m = image.depth_m(middle).clone();
    after = Track(image);
    EXPECT_EQ(after.state, StateMsg::STATE_TRACKING) << "image " << i;
  }
  EXPECT_GT(after.map_id, before.map_id);
  EXPECT_GT(after.keyframe_id, before.keyframe_id) << "ids are never used again";
  EXPECT_TRUE(SpinUntil([&] { return keyframes_.last()->map_id == after.map_id; }, kLimitS));
  EXPECT_GT(keyframes_.last()->revision, revision);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, DropsAndCountsImagesOutOfOrder) {
  const StateMsg before = TrackSequence(3).back();
  const int count = WaitForDiagnostic("dropped: out_of_order", 0);
  Send((*images_)[1]);
  EXPECT_GE(WaitForDiagnostic("dropped: out_of_order", count + 2), count + 2) << "colour and depth";
  EXPECT_EQ(Track((*images_)[3]).map_id, before.map_id);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, StartsANewMapWhenTimeJumpsBack) {
  const StateMsg before = TrackSequence(3).back();
  Advance(-60.0);
  Send((*images_)[0]);
  Send((*images_)[1]);
  const StateMsg after = Track((*images_)[2]);
  EXPECT_EQ(after.state, StateMsg::STATE_TRACKING);
  EXPECT_GT(after.map_id, before.map_id);
  EXPECT_GT(after.keyframe_id, before.keyframe_id) << "ids are never used again";
  Advance(10.0);
}

TEST_F(TrackingNodeTest, KeepsItsMapWhenAStrayImageComes) {
  const StateMsg before = TrackSequence(3).back();
  const int count = WaitForDiagnostic("dropped: out_of_order", 0);
  Advance(-60.0);
  Send((*images_)[1]);
  Advance(60.0);
  EXPECT_EQ(Track((*images_)[3]).map_id, before.map_id);
  EXPECT_GE(WaitForDiagnostic("dropped: out_of_order", count + 2), count + 2) << "colour and depth";
  Advance(10.0);
}

TEST_F(TrackingNodeTest, PausesAndGoesOn) {
  TrackSequence(2);
  std_srvs::SetBool pause;
  pause.request.data = true;
  ASSERT_TRUE(ros::service::call("tracking/pause", pause));
  EXPECT_TRUE(pause.response.success);
  states_.Forget();
  Send((*images_)[2]);
  EXPECT_FALSE(SpinUntil([&] { return states_.count() > 0; }, 1.0));
  pause.request.data = false;
  ASSERT_TRUE(ros::service::call("tracking/pause", pause));
  EXPECT_EQ(Track((*images_)[3]).state, StateMsg::STATE_TRACKING);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, GoesOnWithTheMapThatItSaved) {
  const std::vector<StateMsg> before = TrackSequence(10);
  const semantic_slam::TemporaryFolder folder;
  semantic_slam::SaveMap save;
  save.request.path = folder.path();
  ASSERT_TRUE(ros::service::call("tracking/save_map", save));
  EXPECT_TRUE(save.response.success) << save.response.message;
  EXPECT_EQ(save.response.message, "the map is in " + folder / "localization.map");
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("tracking/reset", reset));
  Advance(1.0);
  Track(images_->back());  // another map, which begins elsewhere

  for (const std::string& path : {folder.path(), folder / "localization.map"}) {
    semantic_slam::LoadMap load;
    load.request.path = path;
    ASSERT_TRUE(ros::service::call("tracking/load_map", load));
    EXPECT_TRUE(load.response.success) << load.response.message;
    ExpectOneLineWith(load.response.message, {"localization.map", "loaded"});
    Advance(2.0);
    const StateMsg after = Track((*images_)[5]);
    ASSERT_EQ(after.state, StateMsg::STATE_TRACKING);
    EXPECT_GT(after.map_id, before[5].map_id);
    EXPECT_GT(after.keyframe_id, before.back().keyframe_id) << "ids are never used again";
    const Rigid3d moved = ToRigid(before[5].T_map_camera).inverse() * ToRigid(after.T_map_camera);
    EXPECT_LT(moved.translation().norm(), 0.02);  // the noise of depth, as above
  }
  Advance(10.0);
}

TEST_F(TrackingNodeTest, RefusesAMapThatIsNoneAndGoesOn) {
  const StateMsg before = TrackSequence(3).back();
  semantic_slam::LoadMap load;
  ASSERT_TRUE(ros::service::call("tracking/load_map", load));
  EXPECT_FALSE(load.response.success);
  EXPECT_EQ(load.response.message, "path is empty, and the node has no ~output_directory");
  load.request.path = "/nowhere";
  ASSERT_TRUE(ros::service::call("tracking/load_map", load));
  EXPECT_FALSE(load.response.success);
  EXPECT_EQ(load.response.message, "cannot open /nowhere");
  const StateMsg after = Track((*images_)[3]);
  EXPECT_EQ(after.state, StateMsg::STATE_TRACKING);
  EXPECT_EQ(after.map_id, before.map_id);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, OnlyLocalizesWhenTold) {
  const StateMsg before = TrackSequence(6).back();
  SetMapping(false);
  const std::size_t count = images_->size();
  for (std::size_t i = 6; i < count; ++i) {
    const StateMsg state = Track((*images_)[i]);
    EXPECT_EQ(state.state, StateMsg::STATE_TRACKING) << i;
    EXPECT_LE(state.keyframe_id, before.keyframe_id) << i;
  }
  // What would make it forget the map does not.
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("tracking/reset", reset));
  EXPECT_TRUE(reset.response.success);
  ExpectOneLineWith(reset.response.message, {"mapping is off", "the map stays"});
  Advance(2.0);
  const StateMsg found = Track((*images_)[3]);
  EXPECT_EQ(found.state, StateMsg::STATE_TRACKING);
  EXPECT_EQ(found.map_id, before.map_id);
  Advance(10.0);
}

// Of a message, row by row.
Eigen::Matrix<double, 6, 6> MatrixOf(const boost::array<double, 36>& covariance) {
  return Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(covariance.data());
}

void ExpectCovariance(const boost::array<double, 36>& msg) {
  const auto covariance = MatrixOf(msg);
  ASSERT_TRUE(covariance.allFinite()) << covariance;
  EXPECT_TRUE(covariance.isApprox(covariance.transpose(), 1e-9)) << covariance;
  const Eigen::LLT<Eigen::Matrix<double, 6, 6>> factors(covariance);
  EXPECT_EQ(factors.info(), Eigen::Success) << "not positive definite:\n" << covariance;
}

TEST_F(TrackingNodeTest, TellsHowSureTheOdometryIs) {
  const StateMsg state = TrackSequence(10).back();
  ASSERT_TRUE(SpinUntil(
      [&] { return odometry_.last() && odometry_.last()->header.stamp == state.header.stamp; }, 5.0));
  const nav_msgs::Odometry odometry = *odometry_.last();
  ExpectCovariance(odometry.pose.covariance);
  ExpectCovariance(odometry.twist.covariance);
  // 1 px at 2 m is 4 mm, and hundreds of features are in view.
  const auto pose = MatrixOf(odometry.pose.covariance);
  EXPECT_GT(pose(0, 0), 1e-6) << "1 mm is the least";
  EXPECT_LT((pose.topLeftCorner<3, 3>().trace()), 4e-4);
  // A difference of two such poses, 1/30 s apart.
  EXPECT_GT(MatrixOf(odometry.twist.covariance)(0, 0), 2e-6 * 900.0);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, TakesSemanticImagesAndCountsThoseItCannotUse) {
  ros::Publisher publisher = nh_.advertise<semantic_slam::SemanticImage>("semantic_image", 10);
  ASSERT_TRUE(SpinUntil([&] { return publisher.getNumSubscribers() > 0; }, kLimitS));
  const auto vocabulary =
      semantic_slam::LabelVocabulary::Load(std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/labels.yaml");
  const auto labels_of = [&](std::size_t image, cv::Size size) {
    const cv::Mat floor(size, CV_8UC1, cv::Scalar::all(2));
    return ToSemanticImage(
        semantic_slam::SureSegmentation(floor, HeaderStamp((*images_)[image].stamp), vocabulary.hash()),
        kCameraFrame);
  };
  const cv::Size size(640, 480);
  TrackSequence(4);
  const int bad = WaitForDiagnostic("dropped: bad_semantic_image", 0);
  const int disordered = WaitForDiagnostic("dropped: semantic_image_out_of_order", 0);
  const int late = WaitForDiagnostic("dropped: semantic_image_late", 0);

  publisher.publish(labels_of(2, size));
  SpinUntil([] { return false; }, 0.2);
  EXPECT_EQ(Track((*images_)[4]).state, StateMsg::STATE_TRACKING);
  publisher.publish(labels_of(1, size));               // out of order
  publisher.publish(labels_of(3, cv::Size(320, 240)));  // of another size
  semantic_slam::SemanticImagePtr foreign = labels_of(3, size);
  foreign->label_set_hash += 1;
  publisher.publish(foreign);
  SpinUntil([] { return false; }, 0.2);
  EXPECT_EQ(Track((*images_)[5]).state, StateMsg::STATE_TRACKING);
  EXPECT_GE(WaitForDiagnostic("dropped: bad_semantic_image", bad + 2), bad + 2);
  EXPECT_EQ(WaitForDiagnostic("dropped: semantic_image_out_of_order", disordered + 1), disordered + 1);

  const semantic_slam::SemanticImagePtr old = labels_of(4, size);
  Advance(1.0);
  Track((*images_)[6]);
  publisher.publish(old);
  SpinUntil([] { return false; }, 0.2);
  Track((*images_)[7]);
  EXPECT_GE(WaitForDiagnostic("dropped: semantic_image_late", late + 1), late + 1);
  Advance(10.0);
}

TEST_F(TrackingNodeTest, RefusesToSaveWhatItDidNotRecord) {
  semantic_slam::SaveMap save;
  ASSERT_TRUE(ros::service::call("tracking/save_trajectory", save));
  EXPECT_FALSE(save.response.success);
  EXPECT_EQ(save.response.message, "path is empty, and the node has no ~output_directory");
  save.request.path = "/tmp/unused";
  ASSERT_TRUE(ros::service::call("tracking/save_trajectory", save));
  EXPECT_FALSE(save.response.success);
  EXPECT_EQ(save.response.message, "nothing was recorded: start the node with ~output_directory");
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "tracking_node_test");
  return RUN_ALL_TESTS();
}
