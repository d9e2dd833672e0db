// Drives object_tracking_node, as a node and as a nodelet (object_tracking_node.test,
// object_tracking_nodelet.test), over real topics.

#include "semantic_slam_ros/object_tracking_node.h"

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <semantic_slam/DetectionArray.h>
#include <semantic_slam/TrackedObjectArray.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/Trigger.h>
#include <opencv2/imgproc.hpp>

#include "ros/ros_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/object_conversions.h"
#include "testing/expect_error.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::DetectedBox;
using semantic_slam::DetectionArray;
using semantic_slam::LabelVocabulary;
using semantic_slam::TrackedObject;
using semantic_slam::TrackedObjectArray;

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 20.0;
const cv::Size kSize(320, 240);

class ObjectTrackingNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return tracks_.connected() && image_pub_.getNumSubscribers() > 0 &&
                 detections_pub_.getNumSubscribers() > 0 && diagnostics_.last();
        },
        kLimitS))
        << "the node did not connect; is it running?";
    Reset();
  }

  static void Reset() {
    std_srvs::Trigger reset;
    ASSERT_TRUE(ros::service::call("object_tracking/reset", reset));
    EXPECT_TRUE(reset.response.success);
  }

  // Stamps go on from test to test.
  static Stamp NextStamp() {
    static std::int64_t ns = 1'000'000'000'000;
    return Stamp{ns += 100'000'000};
  }

  // A smooth random picture, moved to the left.
  static cv::Mat Picture(int shift_px) {
    cv::Mat wide(15, 30, CV_8UC3);
    cv::RNG(1).fill(wide, cv::RNG::UNIFORM, 0, 255);
    cv::resize(wide, wide, {480, 240}, 0, 0, cv::INTER_CUBIC);
    return wide(cv::Rect(shift_px, 0, kSize.width, kSize.height)).clone();
  }

  void SendImage(Stamp stamp, const cv::Mat& picture = Picture(0)) {
    image_pub_.publish(ToImage(ColourImage{picture, semantic_slam::ColourOrder::kBgr},
                               MakeHeader(stamp, kCameraFrame)));
  }

  DetectionArray Found(Stamp stamp, const std::vector<cv::Rect2f>& boxes) const {
    semantic_slam::Detections detections{stamp, vocabulary_.hash(), kSize, {}};
    for (const cv::Rect2f& box : boxes) {
      detections.boxes.push_back({*vocabulary_.Find("chair"), 0.9f, box});
    }
    return ToDetectionArray(detections, kCameraFrame);
  }

  // Sends an image with boxes and waits for its tracks. A node that has just come up may miss one.
  TrackedObjectArray Track(const std::vector<cv::Rect2f>& boxes,
                           const cv::Mat& picture = Picture(0)) {
    const Stamp stamp = NextStamp();
    for (int attempt = 0; attempt < 10; ++attempt) {
      SendImage(stamp, picture);
      detections_pub_.publish(Found(stamp, boxes));
      const auto answered = [&] {
        return tracks_.last() && ToStamp(tracks_.last()->header.stamp) == stamp;
      };
      if (SpinUntil(answered, 2.0)) return *tracks_.last();
    }
    ADD_FAILURE() << "no answer to detections";
    return {};
  }

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

  const LabelVocabulary vocabulary_ =
      LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  const cv::Rect2f kBox{100, 80, 40, 60};
  ros::NodeHandle nh_;
  Listener<TrackedObjectArray> tracks_{nh_, "tracked_objects"};
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
  ros::Publisher image_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
  ros::Publisher detections_pub_ = nh_.advertise<DetectionArray>("detections", 10);
};

TEST_F(ObjectTrackingNodeTest, KeepsTheIdOfWhatMoves) {
  const TrackedObjectArray first = Track({kBox});
  EXPECT_EQ(first.header.frame_id, kCameraFrame);
  EXPECT_EQ(first.label_set_hash, vocabulary_.hash());
  ASSERT_EQ(first.objects.size(), 1u);
  EXPECT_EQ(first.objects[0].state, TrackedObject::STATE_CONFIRMED);
  for (int i = 1; i < 5; ++i) {
    const TrackedObjectArray next = Track({kBox + cv::Point2f(5.0f * i, 0.0f)});
    ASSERT_EQ(next.objects.size(), 1u);
    EXPECT_EQ(next.objects[0].id, first.objects[0].id);
    EXPECT_EQ(next.objects[0].hits, i + 1u);
  }
  const TrackedObjectArray lost = Track({});
  ASSERT_EQ(lost.objects.size(), 1u);
  EXPECT_EQ(lost.objects[0].state, TrackedObject::STATE_LOST);
}

TEST_F(ObjectTrackingNodeTest, TheCamerasMotionIsSeenInTheImages) {
  const TrackedObjectArray first = Track({kBox}, Picture(0));
  // The picture moves by more than half of the box's width.
  const TrackedObjectArray second = Track({kBox - cv::Point2f(36.0f, 0.0f)}, Picture(36));
  ASSERT_EQ(second.objects.size(), 1u);
  EXPECT_EQ(second.objects[0].id, first.objects.at(0).id);
}

TEST_F(ObjectTrackingNodeTest, ResetEndsTracksAndIdsGoOn) {
  const TrackedObjectArray first = Track({kBox});
  Reset();
  const TrackedObjectArray second = Track({kBox});
  ASSERT_EQ(second.objects.size(), 1u);
  EXPECT_GT(second.objects[0].id, first.objects.at(0).id);
}

TEST_F(ObjectTrackingNodeTest, DropsAndCountsWhatIsMalformedAndLives) {
  const TrackedObjectArray first = Track({kBox});
  const int before = WaitForDrops("bad_detections", 0);
  std::vector<DetectionArray> bad;
  for (int i = 0; i < 5; ++i) bad.push_back(Found(NextStamp(), {kBox}));
  ++bad[0].label_set_hash;
  bad[1].detections[0].label = 200;
  bad[2].detections[0].x_max = std::numeric_limits<float>::quiet_NaN();
  bad[3].detections[0].confidence = 7.0f;
  bad[4].height = 1000;
  for (const DetectionArray& msg : bad) {
    SendImage(ToStamp(msg.header.stamp));
    detections_pub_.publish(msg);
    SpinUntil([] { return false; }, 0.2);  // or the next would push it out of the queue
  }
  EXPECT_GE(WaitForDrops("bad_detections", before + 5), before + 5);
  detections_pub_.publish(Found(Stamp(), {kBox}));
  EXPECT_GE(WaitForDrops("bad_stamp", 1), 1);
  // Off the image, and none at all: no fault.
  Track({{-500, -500, 10, 10}});
  const TrackedObjectArray last = Track({kBox});
  ASSERT_EQ(last.objects.size(), 1u);
  EXPECT_EQ(last.objects[0].id, first.objects.at(0).id);
}

TEST_F(ObjectTrackingNodeTest, AMalformedImageCostsTheCompensationOnly) {
  Track({kBox});
  const int before = WaitForDrops("bad_image", 0);
  const Stamp stamp = NextStamp();
  const auto cut = ToImage(ColourImage{Picture(0), semantic_slam::ColourOrder::kBgr},
                           MakeHeader(stamp, kCameraFrame));
  cut->data.resize(100);
  image_pub_.publish(cut);
  detections_pub_.publish(Found(stamp, {kBox}));
  EXPECT_TRUE(SpinUntil(
      [&] { return tracks_.last() && ToStamp(tracks_.last()->header.stamp) == stamp; }, kLimitS));
  EXPECT_GT(WaitForDrops("bad_image", before + 1), before);
}

TEST_F(ObjectTrackingNodeTest, DetectionsWhoseImageNeverComesAreCounted) {
  Track({kBox});
  const int before = WaitForDrops("no_image", 0);
  for (int i = 0; i < 3; ++i) detections_pub_.publish(Found(NextStamp(), {kBox}));
  Track({kBox});
  EXPECT_GE(WaitForDrops("no_image", before + 3), before + 3);
}

TEST_F(ObjectTrackingNodeTest, RefusesParametersThatCannotBe) {
  const auto error_of = [](const std::string& name) {
    return semantic_slam::MessageOf<semantic_slam::ConfigError>(
        [&] { ObjectTrackingNode(ros::NodeHandle(name), ros::NodeHandle("~" + name)); });
  };
  semantic_slam::ExpectOneLineWith(error_of("unset"), {"unset/labels is empty"});
  ros::param::set("~bad/labels", SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  ros::param::set("~bad/tracker/low_confidence", 0.9);
  semantic_slam::ExpectOneLineWith(error_of("bad"), {"tracker/low_confidence = 0.9"});
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "object_tracking_node_test");
  return RUN_ALL_TESTS();
}
