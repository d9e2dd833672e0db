// Stands in for tracking and control, so it holds the simulator's time in its hands.

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosgraph_msgs/Clock.h>
#include <semantic_slam/DetectionArray.h>
#include <semantic_slam/LabelSet.h>
#include <semantic_slam/SemanticImage.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include "ros/ros_testing.h"
#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/control/quadrotor_parameters.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/waypoint_conversions.h"

namespace semantic_slam_ros {
namespace {

using diagnostic_msgs::DiagnosticArray;
using semantic_slam::LabelVocabulary;
using StateMsg = semantic_slam::TrackingState;

constexpr double kLimitS = 60.0;
constexpr double kStillS = 0.5;  // long enough for several images, if nothing held them back

// Tracking and control in one. It outlives the tests: the image that waits at the end of one is
// where the next one goes on.
class Answerer {
 public:
  // The newest image is complete, and nobody has answered to it yet.
  bool Waits() const {
    return colour.last() && depth.last() && odometry.last() &&
           colour.last()->header.stamp == odometry.last()->header.stamp &&
           colour.last()->header.stamp == depth.last()->header.stamp &&
           colour.last()->header.stamp > answered;
  }

  // Answers until an answer brings the next image: then the simulator listens.
  bool Begin() {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kLimitS);
    while (ros::WallTime::now() < end) {
      if (!SpinUntil([&] { return colour.last() && odometry.last(); }, kLimitS)) return false;
      Answer();
      if (SpinUntil([&] { return Waits(); }, 0.2)) return true;
    }
    return false;
  }

  ros::Time stamp() const { return colour.last()->header.stamp; }

  // Level, but for the pitch.
  void Answer(double pitch_rad = 0.0) {
    SendState();
    SendCommand(stamp(), pitch_rad);
  }
  void SendState() {
    answered = stamp();
    StateMsg state;
    state.header.stamp = stamp();
    state.state = StateMsg::STATE_TRACKING;
    states_pub_.publish(state);
  }
  semantic_slam::AttitudeThrust Command(const ros::Time& at, double pitch_rad) const {
    const semantic_slam::AttitudeCommand command{
        semantic_slam::ExpSo3({0.0, pitch_rad, 0.0}), Eigen::Vector3d::Zero(),
        semantic_slam::QuadrotorParameters().hover_thrust_n() / std::cos(pitch_rad)};
    return ToAttitudeThrust(command, ToRigid(odometry.last()->pose.pose).linear(),
                            MakeHeader(ToStamp(at), "base_link"));
  }
  void Send(const semantic_slam::AttitudeThrust& command) { commands_pub_.publish(command); }
  void SendCommand(const ros::Time& at, double pitch_rad) { Send(Command(at, pitch_rad)); }

  // One image on.
  bool Step(double pitch_rad = 0.0) {
    Answer(pitch_rad);
    return SpinUntil([&] { return Waits(); }, kLimitS);
  }

  std::string Diagnostic(const std::string& key) const {
    return diagnostics.last() ? DiagnosticValue(*diagnostics.last(), key) : "";
  }
  // The count under `key` once it is at least `at_least`, or as it stays.
  int WaitForCount(const std::string& key, int at_least) {
    int value = 0;
    SpinUntil(
        [&] {
          const std::string text = Diagnostic(key);
          value = text.empty() ? 0 : std::stoi(text);
          return value >= at_least;
        },
        5.0);
    return value;
  }

  ros::NodeHandle nh;
  tf2_ros::Buffer tf;
  tf2_ros::TransformListener tf_listener{tf, nh};
  ros::Time answered;
  Listener<sensor_msgs::Image> colour{nh, "rgb/image_raw"};
  Listener<sensor_msgs::Image> depth{nh, "depth_registered/image_raw"};
  Listener<sensor_msgs::CameraInfo> info{nh, "rgb/camera_info"};
  Listener<sensor_msgs::Imu> imu{nh, "imu"};
  Listener<nav_msgs::Odometry> odometry{nh, "ground_truth/odometry"};
  Listener<tf2_msgs::TFMessage> truth{nh, "tf_ground_truth"};
  Listener<rosgraph_msgs::Clock> clock{nh, "/clock"};
  Listener<semantic_slam::SemanticImage> semantic{nh, "semantic_image"};
  Listener<semantic_slam::DetectionArray> detections{nh, "detections"};
  Listener<sensor_msgs::Image> semantic_overlay{nh, "semantic_overlay"};
  Listener<sensor_msgs::Image> detection_overlay{nh, "detection_overlay"};
  Listener<semantic_slam::LabelSet> labels{nh, "labels"};
  Listener<DiagnosticArray> diagnostics{nh, "/diagnostics"};

 private:
  ros::Publisher states_pub_ = nh.advertise<StateMsg>("tracking_state", 10);
  ros::Publisher commands_pub_ = nh.advertise<semantic_slam::AttitudeThrust>("attitude_thrust", 10);
};

class SimulatorNodeTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { answerer_ = std::make_unique<Answerer>(); }
  static void TearDownTestSuite() { answerer_.reset(); }

  void SetUp() override {
    ASSERT_TRUE(a().Waits() || a().Begin()) << "the simulator does not answer; is it running?";
  }

  static Answerer& a() { return *answerer_; }

  static std::unique_ptr<Answerer> answerer_;
};

std::unique_ptr<Answerer> SimulatorNodeTest::answerer_;

TEST_F(SimulatorNodeTest, ImagesFollowEachOtherBy33Ms) {
  for (int i = 0; i < 10; ++i) {
    const ros::Time before = a().stamp();
    ASSERT_TRUE(a().Step());
    // A nanosecond of rounding.
    EXPECT_NEAR((a().stamp() - before).toSec(), 1.0 / 30.0, 2e-9);
    EXPECT_EQ(a().clock.last()->clock, a().stamp());
    EXPECT_EQ(a().info.last()->header.stamp, a().stamp());
  }
}

TEST_F(SimulatorNodeTest, AnImageWaitsForTrackingAndControl) {
  const int images = a().colour.count();
  SpinUntil([] { return false; }, kStillS);
  EXPECT_EQ(a().colour.count(), images) << "nobody has answered";
  a().SendState();
  SpinUntil([] { return false; }, kStillS);
  EXPECT_EQ(a().colour.count(), images) << "there is no command yet";
  a().SendCommand(a().stamp(), 0.0);
  EXPECT_TRUE(SpinUntil([&] { return a().Waits(); }, kLimitS));
  EXPECT_EQ(a().Diagnostic("waits for tracking that ran out"), "0");
  EXPECT_EQ(a().Diagnostic("waits for control that ran out"), "0");
}

TEST_F(SimulatorNodeTest, TheDroneFollowsCommands) {
  const Rigid3d start = ToRigid(a().odometry.last()->pose.pose);
  for (int i = 0; i < 15; ++i) ASSERT_TRUE(a().Step(0.1));
  const Rigid3d end = ToRigid(a().odometry.last()->pose.pose);
  // sin(0.1) g for half a second, less the time that tilting takes.
  EXPECT_GT((end.translation() - start.translation()).x(), 0.05);
  EXPECT_NEAR(a().odometry.last()->twist.twist.angular.z, 0.0, 0.02);
  EXPECT_EQ(a().odometry.last()->header.frame_id, "world");
  EXPECT_EQ(a().odometry.last()->child_frame_id, "ground_truth/base_link");
  for (int i = 0; i < 15; ++i) ASSERT_TRUE(a().Step(-0.1));
}

TEST_F(SimulatorNodeTest, DropsAndCountsBadCommandsAndFliesOn) {
  const int before = a().WaitForCount("dropped: bad_command", 0);
  semantic_slam::AttitudeThrust not_finite = a().Command(a().stamp(), 0.0);
  not_finite.thrust = std::numeric_limits<double>::quiet_NaN();
  a().Send(not_finite);
  semantic_slam::AttitudeThrust no_rotation = a().Command(a().stamp(), 0.0);
  no_rotation.orientation.w = no_rotation.orientation.x = 0.0;
  no_rotation.orientation.y = no_rotation.orientation.z = 0.0;
  a().Send(no_rotation);
  a().SendCommand(ros::Time(), 0.0);                       // no stamp
  a().SendCommand(ros::Time(1.0), 0.0);                    // long ago
  a().SendCommand(a().stamp() + ros::Duration(1.0), 0.0);  // of a moment that has not been yet
  ASSERT_TRUE(a().Step());
  EXPECT_GE(a().WaitForCount("dropped: bad_command", before + 5), before + 5);
  const double height_m = a().odometry.last()->pose.pose.position.z;
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(a().Step());
  // 1 cm: it hovers.
  EXPECT_NEAR(a().odometry.last()->pose.pose.position.z, height_m, 0.01);
}

TEST_F(SimulatorNodeTest, TheImuReadsGravityInTheCamerasAxes) {
  const int readings = a().imu.count();
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(a().Step());
  // Of 30 images: one second.
  EXPECT_TRUE(SpinUntil([&] { return a().imu.count() >= readings + 190; }, 5.0)) << a().imu.count();
  const auto& force = a().imu.last()->linear_acceleration;
  EXPECT_NEAR(std::hypot(force.x, force.y, force.z), 9.81, 0.5);
  EXPECT_LT(force.y, -8.0) << "the image's y axis points down";
  EXPECT_EQ(a().imu.last()->header.frame_id, "camera_imu_optical_frame");
}

TEST_F(SimulatorNodeTest, TfKnowsTheMountAndTheTruthApartFromEachOther) {
  ASSERT_TRUE(a().Step());
  ASSERT_TRUE(SpinUntil(
      [&] {
        return a().tf.canTransform("base_link", "camera_color_optical_frame", ros::Time()) &&
               a().tf.canTransform("world", "ground_truth/base_link", a().stamp());
      },
      kLimitS));
  const Rigid3d T_base_camera = ToRigid(
      a().tf.lookupTransform("base_link", "camera_color_optical_frame", ros::Time()).transform);
  EXPECT_NEAR(T_base_camera.translation().x(), 0.1, 1e-9);
  EXPECT_NEAR(T_base_camera.linear()(2, 2), -std::sin(20.0 * M_PI / 180.0), 1e-9) << "looks down";
  EXPECT_FALSE(a().tf.canTransform("world", "base_link", ros::Time()))
      << "the truth must not be in the estimate's tree";
  const Rigid3d T_world_base = ToRigid(a().odometry.last()->pose.pose);
  ASSERT_EQ(a().truth.last()->transforms.size(), 1u);
  const auto& camera = a().truth.last()->transforms.front();
  EXPECT_EQ(camera.child_frame_id, a().colour.last()->header.frame_id);
  EXPECT_TRUE(ToRigid(camera.transform).isApprox(T_world_base * T_base_camera, 1e-6));
}

// Without noise and errors a pixel that is called floor lies on the floor.
TEST_F(SimulatorNodeTest, LabelsAgreeWithDepth) {
  ASSERT_TRUE(a().Step());
  ASSERT_TRUE(SpinUntil(
      [&] { return a().semantic.last() && a().semantic.last()->header.stamp == a().stamp(); },
      kLimitS));
  const auto vocabulary = LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  const auto seen = ToSegmentation(a().semantic.last(), vocabulary);
  const cv::Mat depth_m = ToDepthMetres(a().depth.last());
  const semantic_slam::CameraModel camera(ToIntrinsics(*a().info.last()));
  const Rigid3d T_world_camera = ToRigid(a().truth.last()->transforms.front().transform);
  int floor = 0, table = 0;
  for (int v = 0; v < depth_m.rows; v += 3) {
    for (int u = 0; u < depth_m.cols; u += 3) {
      const Eigen::Vector2f ray = camera.Ray(u, v);
      const double z = depth_m.at<float>(v, u);
      const Eigen::Vector3d p_world = T_world_camera * Eigen::Vector3d(ray.x() * z, ray.y() * z, z);
      const auto label = seen.labels[0].at<std::uint8_t>(v, u);
      if (label == *vocabulary.Find("floor")) {
        ++floor;
        EXPECT_NEAR(p_world.z(), 0.0, 1e-3);  // of rays in floats
      } else if (label == *vocabulary.Find("coffee_table")) {
        ++table;
        EXPECT_NEAR(p_world.x(), 2.8, 0.8);
        EXPECT_LT(p_world.z(), 0.6);
      }
    }
  }
  EXPECT_GT(floor, 1000);
  EXPECT_GT(table, 100);
}

TEST_F(SimulatorNodeTest, BoxesHoldWhatTheLabelsShow) {
  ASSERT_TRUE(a().Step());
  ASSERT_TRUE(SpinUntil(
      [&] {
        return a().semantic.last() && a().semantic.last()->header.stamp == a().stamp() &&
               a().detections.last() && a().detections.last()->header.stamp == a().stamp() &&
               a().labels.last();
      },
      kLimitS));
  const auto vocabulary = LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  EXPECT_EQ(a().labels.last()->hash, vocabulary.hash());
  EXPECT_EQ(a().detections.last()->label_set_hash, vocabulary.hash());
  const semantic_slam::LabelId table = *vocabulary.Find("coffee_table");
  const cv::Mat is_table = ToSegmentation(a().semantic.last(), vocabulary).labels[0] == table;
  std::vector<cv::Point> pixels;
  cv::findNonZero(is_table, pixels);
  ASSERT_FALSE(pixels.empty());
  int boxes = 0;
  for (const auto& detection : a().detections.last()->detections) {
    if (detection.label != table) continue;
    ++boxes;
    for (const cv::Point& pixel : pixels) {
      ASSERT_TRUE(detection.x_min <= pixel.x && pixel.x <= detection.x_max &&
                  detection.y_min <= pixel.y && pixel.y <= detection.y_max);
    }
  }
  EXPECT_EQ(boxes, 1);
}

TEST_F(SimulatorNodeTest, OverlaysShowLabelsAndBoxesInTheImage) {
  ASSERT_TRUE(a().Step());
  for (const auto* overlay : {&a().semantic_overlay, &a().detection_overlay}) {
    ASSERT_TRUE(SpinUntil(
        [&] { return overlay->last() && overlay->last()->header.stamp == a().stamp(); }, kLimitS));
    EXPECT_EQ(overlay->last()->width, a().colour.last()->width);
    EXPECT_EQ(overlay->last()->encoding, a().colour.last()->encoding);
    EXPECT_NE(overlay->last()->data, a().colour.last()->data);
  }
}

TEST_F(SimulatorNodeTest, TimeStandsStillWhilePaused) {
  std_srvs::SetBool pause;
  pause.request.data = true;
  ASSERT_TRUE(ros::service::call("simulator/pause", pause));
  const int images = a().colour.count();
  a().Answer();
  SpinUntil([] { return false; }, kStillS);
  EXPECT_EQ(a().colour.count(), images);
  pause.request.data = false;
  ASSERT_TRUE(ros::service::call("simulator/pause", pause));
  EXPECT_TRUE(SpinUntil([&] { return a().Waits(); }, kLimitS));
}

TEST_F(SimulatorNodeTest, ResetBeginsAnewInTimeAndPlace) {
  for (int i = 0; i < 15; ++i) ASSERT_TRUE(a().Step(0.1));
  const ros::Time before = a().stamp();
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("simulator/reset", reset));
  a().Answer();
  ASSERT_TRUE(SpinUntil([&] { return a().stamp() < before; }, kLimitS));
  a().answered = ros::Time();
  ASSERT_TRUE(a().Begin());
  EXPECT_NEAR(a().odometry.last()->pose.pose.position.x, 0.8, 0.01);
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulator_node_test");
  return RUN_ALL_TESTS();
}
