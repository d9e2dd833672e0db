#include "semantic_slam_ros/colour_input.h"

#include <vector>

#include <gtest/gtest.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <boost/make_shared.hpp>

#include <opencv2/imgcodecs.hpp>

#include "ros/ros_testing.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::ConfigError;
using semantic_slam::MessageOf;
using semantic_slam::Stamp;

constexpr double kLimitS = 10.0;

class ColourInputTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(SpinUntil([&] { return pub_.getNumSubscribers() == 1; }, kLimitS));
  }

  static sensor_msgs::ImagePtr ImageAt(Stamp stamp) {
    return ToImage(cv::Mat(2, 3, CV_8UC3, cv::Scalar(1, 2, 3)), "bgr8",
                   MakeHeader(stamp, "/camera"));
  }

  // Publishes images at those times [0.1 s]. Returns the stamps that were handed out.
  std::vector<std::int64_t> Send(const std::vector<int>& times) {
    constexpr std::int64_t kTenthNs = 100'000'000;
    received_.clear();
    for (const int time : times) pub_.publish(ImageAt(Stamp{time * kTenthNs}));
    // Messages inside one process come in order at the next spin; half a second is for a busy
    // machine.
    SpinUntil([] { return false; }, 0.5);
    std::vector<std::int64_t> stamps;
    for (const ColourMessage& message : received_) stamps.push_back(message.stamp.ns / kTenthNs);
    return stamps;
  }

  ros::NodeHandle nh_;
  DropCounter drops_;
  std::vector<ColourMessage> received_;
  ColourInput input_{
      nh_, {}, drops_, [this](ColourMessage message) { received_.push_back(std::move(message)); }};
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 100);
};

TEST_F(ColourInputTest, HandsOutImagesAsTheyCame) {
  const sensor_msgs::ImagePtr image = ImageAt(Stamp::FromSeconds(1.0));
  pub_.publish(image);
  ASSERT_TRUE(SpinUntil([&] { return !received_.empty(); }, kLimitS));
  EXPECT_EQ(received_[0].stamp, Stamp::FromSeconds(1.0));
  EXPECT_EQ(received_[0].frame_id, "camera");
  EXPECT_EQ(received_[0].timeline, 0);
  EXPECT_EQ(received_[0].Decode().pixels.data, image->data.data()) << "no copy";
}

TEST_F(ColourInputTest, CountsImagesWithoutStampOrOutOfOrder) {
  EXPECT_EQ(Send({50, 0, 50, 45, 51}), (std::vector<std::int64_t>{50, 51}));
  EXPECT_EQ(drops_.counts()["bad_stamp"], 1u);
  EXPECT_EQ(drops_.counts()["out_of_order"], 2u);
}

TEST_F(ColourInputTest, AStrayOldImageBeginsNothing) {
  EXPECT_EQ(Send({1000, 100, 101, 1001, 102, 1002}), (std::vector<std::int64_t>{1000, 1001, 1002}));
  EXPECT_EQ(received_.back().timeline, 0);
  EXPECT_EQ(drops_.counts()["out_of_order"], 3u);
}

TEST_F(ColourInputTest, ThreeOldImagesInARowBeginANewTimeline) {
  EXPECT_EQ(Send({1000, 100, 101, 102, 103}), (std::vector<std::int64_t>{1000, 102, 103}));
  EXPECT_EQ(received_[0].timeline, 0);
  EXPECT_EQ(received_[1].timeline, 1);
  EXPECT_EQ(received_[2].timeline, 1);
}

TEST_F(ColourInputTest, StartsOverWhenAsked) {
  EXPECT_EQ(Send({1000}), (std::vector<std::int64_t>{1000}));
  input_.StartOver();
  EXPECT_EQ(Send({100}), (std::vector<std::int64_t>{100}));
  EXPECT_EQ(received_[0].timeline, 1);
}

TEST_F(ColourInputTest, ThrowsImagesAwayWhilePaused) {
  input_.SetPaused(true);
  EXPECT_TRUE(Send({10, 20}).empty());
  EXPECT_TRUE(drops_.counts().empty());
  input_.SetPaused(false);
  EXPECT_EQ(Send({30}), (std::vector<std::int64_t>{30}));
}

TEST(ColourInputTransportTest, ReadsCompressedImages) {
  ros::NodeHandle nh("compressed");
  DropCounter drops;
  std::vector<ColourMessage> received;
  ColourInputOptions options;
  options.image_transport = "compressed";
  const ColourInput input(nh, options, drops,
                          [&](ColourMessage message) { received.push_back(std::move(message)); });
  const auto pub = nh.advertise<sensor_msgs::CompressedImage>("rgb/image_raw/compressed", 10);
  ASSERT_TRUE(SpinUntil([&] { return pub.getNumSubscribers() == 1; }, kLimitS));
  sensor_msgs::CompressedImage msg;
  msg.header = MakeHeader(Stamp::FromSeconds(1.0), "camera");
  msg.format = "png";
  cv::imencode(".png", cv::Mat(4, 6, CV_8UC3, cv::Scalar(9, 8, 7)), msg.data);
  pub.publish(msg);
  ASSERT_TRUE(SpinUntil([&] { return !received.empty(); }, kLimitS));
  EXPECT_EQ(received[0].Decode().pixels.at<cv::Vec3b>(3, 5), cv::Vec3b(9, 8, 7));
}

TEST(ColourInputTransportTest, RefusesAnUnknownTransport) {
  ColourInputOptions options;
  options.image_transport = "theora";
  DropCounter drops;
  EXPECT_EQ(MessageOf<ConfigError>([&] {
              ColourInput(ros::NodeHandle(), options, drops, [](const ColourMessage&) {});
            }),
            "~image_transport = theora, but must be raw or compressed");
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "colour_input_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
