#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <semantic_slam/LabelSet.h>
#include <sensor_msgs/Image.h>

#include "ros/ros_testing.h"
#include "semantic_slam_ros/conversions.h"

// What the tests of nodes that look at colour images share.

namespace semantic_slam_ros {

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 20.0;

// Gives a node of this process its private parameters.
inline void SetParameters(const std::string& node, const std::string& card) {
  ros::param::set("~" + node + "/card", card);
  ros::param::set("~" + node + "/labels", SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
}

// A node of this process, its topics in the namespace `name`.
template <typename Node>
std::unique_ptr<Node> MakeNode(const std::string& name) {
  return std::make_unique<Node>(ros::NodeHandle(name), ros::NodeHandle("~" + name));
}

// A test of a running node that takes rgb/image_raw and answers each
// image with an `Answer` on `topic`. Stamps go on from test to test.
template <typename Answer>
class ColourNodeTest : public testing::Test {
 protected:
  explicit ColourNodeTest(const std::string& topic) : answers_(nh_, topic) {}

  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] { return answers_.connected() && image_pub_.getNumSubscribers() > 0; }, kLimitS))
        << "the node did not connect; is it running?";
  }

  static Stamp NextStamp() {
    static std::int64_t ns = 1'000'000'000'000;
    return Stamp{ns += 100'000'000};
  }

  static sensor_msgs::ImagePtr Message(const cv::Mat& bgr, Stamp stamp) {
    return ToImage(ColourImage{bgr, semantic_slam::ColourOrder::kBgr},
                   MakeHeader(stamp, kCameraFrame));
  }

  // Sends an image and waits for what the node says of it. One that has just come up may miss an
  // image: it is sent again, a little later.
  boost::shared_ptr<const Answer> Ask(const cv::Mat& bgr) {
    for (int attempt = 0; attempt < 10; ++attempt) {
      const Stamp stamp = NextStamp();
      image_pub_.publish(Message(bgr, stamp));
      const auto answered = [&] {
        return answers_.last() && ToStamp(answers_.last()->header.stamp) == stamp;
      };
      if (SpinUntil(answered, 2.0)) return answers_.last();
    }
    ADD_FAILURE() << "no answer to an image";
    return boost::make_shared<Answer>();
  }

  // The count of a cause on /diagnostics once it is at least `at_least`, or as it stays.
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

  // Images of many faults; the node must live and count each.
  void ExpectBadImagesAreDroppedAndCounted(const cv::Mat& good) {
    const int before = WaitForDrops("bad_image", 0);
    std::vector<sensor_msgs::ImagePtr> bad;
    for (int i = 0; i < 4; ++i) bad.push_back(Message(good, NextStamp()));
    bad[0]->data.resize(100);
    bad[1]->encoding = "yuv422";
    bad[2]->width = bad[2]->height = 0;
    bad[3]->step = 1;
    for (const auto& image : bad) {
      image_pub_.publish(image);
      SpinUntil([] { return false; }, 0.2);  // or the next would push it out of the queue
    }
    EXPECT_GE(WaitForDrops("bad_image", before + 4), before + 4);
    image_pub_.publish(Message(good, Stamp()));
    EXPECT_GE(WaitForDrops("bad_stamp", 1), 1);
    const sensor_msgs::ImagePtr old = Message(good, Stamp{NextStamp().ns - 500'000'000});
    Ask(good);
    image_pub_.publish(old);
    EXPECT_GE(WaitForDrops("out_of_order", 1), 1);
  }

  // A listener that comes late gets the vocabulary.
  void ExpectLabelsAreLatched(std::uint64_t hash, std::size_t count) {
    Listener<semantic_slam::LabelSet> labels(nh_, "labels");
    ASSERT_TRUE(SpinUntil([&] { return labels.last() != nullptr; }, kLimitS));
    EXPECT_EQ(labels.last()->hash, hash);
    EXPECT_EQ(labels.last()->labels.size(), count);
  }

  // While somebody listens, a picture of the image's size and stamp comes with every answer.
  void ExpectOverlay(const std::string& topic, const cv::Mat& image) {
    Listener<sensor_msgs::Image> overlay(nh_, topic);
    ASSERT_TRUE(SpinUntil([&] { return overlay.connected(); }, kLimitS));
    ASSERT_TRUE(SpinUntil(
        [&] {
          Ask(image);
          return overlay.last() != nullptr;
        },
        kLimitS));
    EXPECT_EQ(overlay.last()->width, static_cast<std::uint32_t>(image.cols));
    EXPECT_EQ(overlay.last()->height, static_cast<std::uint32_t>(image.rows));
    EXPECT_EQ(overlay.last()->header.frame_id, kCameraFrame);
    EXPECT_FALSE(overlay.last()->header.stamp.isZero());
  }

  ros::NodeHandle nh_;
  Listener<Answer> answers_;
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
  ros::Publisher image_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
};

}  // namespace semantic_slam_ros
