// RgbdInput on topics that this program publishes to itself.

#include "semantic_slam_ros/rgbd_input.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "ros/ros_testing.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {
namespace {

constexpr double kLimitS = 20.0;

Stamp Ms(std::int64_t ms) {
  return {1'000'000'000'000 + ms * 1'000'000};
}

sensor_msgs::ImagePtr Blank(int type, const std::string& encoding, std::int64_t ms) {
  return ToImage(cv::Mat(480, 640, type, cv::Scalar::all(1)), encoding,
                 MakeHeader(Ms(ms), "camera"));
}

class RgbdInputTest : public testing::Test {
 protected:
  RgbdInputTest() {
    RgbdInputOptions options;
    options.camera_config = SEMANTIC_SLAM_SOURCE_DIR "/config/tum_freiburg1.yaml";
    input_ = std::make_unique<RgbdInput>(
        nh_, options, semantic_slam::ImagePairerOptions(), drops_,
        [this](RgbdMessages messages) { pairs_.push_back(std::move(messages)); });
  }

  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] { return colour_pub_.getNumSubscribers() > 0 && depth_pub_.getNumSubscribers() > 0; },
        kLimitS));
  }

  void SendColour(std::int64_t ms) { colour_pub_.publish(Blank(CV_8UC3, "bgr8", ms)); }
  void SendDepth(std::int64_t ms) { depth_pub_.publish(Blank(CV_32FC1, "32FC1", ms)); }

  std::size_t Dropped(const std::string& cause) const {
    const auto counts = drops_.counts();
    const auto found = counts.find(cause);
    return found == counts.end() ? 0 : found->second;
  }

  // An image that is sent twice is out of order the second time: who sees that has seen all before.
  bool WaitForOutOfOrder(std::size_t count) {
    return SpinUntil([&] { return Dropped("out_of_order") == count; }, kLimitS);
  }

  ros::NodeHandle nh_;
  DropCounter drops_;
  std::vector<RgbdMessages> pairs_;
  std::unique_ptr<RgbdInput> input_;
  ros::Publisher colour_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
  ros::Publisher depth_pub_ = nh_.advertise<sensor_msgs::Image>("depth_registered/image_raw", 10);
};

TEST_F(RgbdInputTest, HandsOutAtTheEndWhatWaits) {
  for (const int ms : {0, 33, 33}) {
    SendColour(ms);
    SendDepth(ms + 8);
  }
  ASSERT_TRUE(WaitForOutOfOrder(2));
  ASSERT_EQ(pairs_.size(), 1u) << "the second pair waits: a nearer image may still come";
  EXPECT_EQ(pairs_[0].stamp, Ms(0));
  input_.reset();
  ASSERT_EQ(pairs_.size(), 2u);
  EXPECT_EQ(pairs_[1].stamp, Ms(33));
  EXPECT_EQ(pairs_[1].depth_stamp, Ms(41));
  EXPECT_NO_THROW(pairs_[1].Decode());
}

// What nodelets of one manager gain: publisher and subscriber in one process share the message, and the
// core works on its pixels.
TEST_F(RgbdInputTest, WithinOneProcessImagesAreNeverCopied) {
  const auto colour = Blank(CV_8UC3, "bgr8", 0);
  const auto depth = Blank(CV_32FC1, "32FC1", 1);
  colour_pub_.publish(colour);
  depth_pub_.publish(depth);
  SendColour(33);
  SendDepth(34);
  ASSERT_TRUE(SpinUntil([&] { return !pairs_.empty(); }, kLimitS));
  const semantic_slam::RgbdImage image = pairs_[0].Decode();
  EXPECT_EQ(image.colour.data, colour->data.data());
  EXPECT_EQ(image.depth_m.data, depth->data.data());
}

TEST_F(RgbdInputTest, CountsAtTheEndWhatHasNoPartner) {
  SendColour(0);
  SendColour(0);
  ASSERT_TRUE(WaitForOutOfOrder(1));
  EXPECT_EQ(Dropped("unpaired_colour"), 0u);
  input_.reset();
  EXPECT_EQ(Dropped("unpaired_colour"), 1u);
  EXPECT_TRUE(pairs_.empty());
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rgbd_input_test");
  return RUN_ALL_TESTS();
}
