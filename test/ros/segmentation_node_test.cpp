// Drives segmentation, as a node and as a nodelet (segmentation_node.test,
// segmentation_nodelet.test), over real topics with a network that goes by colour; and a node in
// this process with a real one.

#include "semantic_slam_ros/segmentation_node.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "ros/colour_node_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/tiny_networks.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::LabelId;
using semantic_slam::LabelOf;
using semantic_slam::Segmentation;
using semantic_slam::SemanticImage;
using semantic_slam::Vocabulary;

// Left half red, right half blue.
cv::Mat TwoColours() {
  cv::Mat image(240, 320, CV_8UC3, cv::Scalar(0, 0, 255));
  image.colRange(160, 320).setTo(cv::Scalar(255, 0, 0));
  return image;
}

class SegmentationNodeTest : public ColourNodeTest<SemanticImage> {
 protected:
  SegmentationNodeTest() : ColourNodeTest("semantic_image") {}
};

TEST_F(SegmentationNodeTest, LabelsEveryPixelAtTheImagesStamp) {
  const auto msg = Ask(TwoColours());
  EXPECT_EQ(msg->header.frame_id, kCameraFrame);
  const Segmentation found = ToSegmentation(msg, Vocabulary());
  ASSERT_EQ(found.size(), cv::Size(320, 240));
  EXPECT_EQ(found.labels[0].at<LabelId>(100, 50), LabelOf("chair"));
  EXPECT_EQ(found.labels[0].at<LabelId>(100, 270), LabelOf("tv"));
  EXPECT_GT(found.confidences[0].at<std::uint8_t>(100, 50), 200);
}

TEST_F(SegmentationNodeTest, LatchesTheLabels) {
  ExpectLabelsAreLatched(Vocabulary().hash(), Vocabulary().classes().size());
}

TEST_F(SegmentationNodeTest, DrawsForThoseWhoLook) {
  ExpectOverlay("semantic_overlay", TwoColours());
}

TEST_F(SegmentationNodeTest, DropsAndCountsBadImagesAndLives) {
  ExpectBadImagesAreDroppedAndCounted(TwoColours());
  EXPECT_EQ(Ask(TwoColours())->width, 320u);
}

TEST_F(SegmentationNodeTest, FollowsAnImageOfAnotherSize) {
  EXPECT_EQ(Ask(TwoColours())->width, 320u);
  EXPECT_EQ(Ask(TwoColours()(cv::Rect(0, 0, 200, 100)))->width, 200u);
}

TEST_F(SegmentationNodeTest, KeepsToTheMinimumPeriod) {
  SetParameters("slow", semantic_slam::TinyNetworkCard("colour_segmenter"));
  ros::param::set("~slow/min_period_s", 0.25);
  const auto node = MakeNode<SegmentationNode>("slow");
  Listener<SemanticImage> answers(nh_, "slow/semantic_image");
  ros::Publisher images = nh_.advertise<sensor_msgs::Image>("slow/rgb/image_raw", 10);
  ASSERT_TRUE(
      SpinUntil([&] { return answers.connected() && images.getNumSubscribers() > 0; }, kLimitS));
  // Ten images a second: the first, and every third from there on.
  for (int i = 0; i < 7; ++i) {
    const int before = answers.count();
    images.publish(Message(TwoColours(), NextStamp()));
    const bool expected = i % 3 == 0;
    EXPECT_EQ(SpinUntil([&] { return answers.count() > before; }, expected ? kLimitS : 0.2),
              expected);
  }
}

TEST_F(SegmentationNodeTest, RefusesACardThatIsNotThere) {
  const auto error_of = [](const std::string& name) {
    return semantic_slam::MessageOf<semantic_slam::ConfigError>(
        [&] { MakeNode<SegmentationNode>(name); });
  };
  semantic_slam::ExpectOneLineWith(error_of("unset"), {"unset/labels is empty"});
  SetParameters("bad", "/nowhere/card.yaml");
  EXPECT_EQ(error_of("bad"), "cannot open configuration file /nowhere/card.yaml");
  ros::param::set("~bad/card", "");
  semantic_slam::ExpectOneLineWith(error_of("bad"),
                                   {"bad/card is empty, but must name a model card"});
  SetParameters("bad", semantic_slam::TinyNetworkCard("block_detector"));
  semantic_slam::ExpectOneLineWith(error_of("bad"), {"block_detector.yaml: head/type is not seg"});
}

TEST_F(SegmentationNodeTest, RunsARealNetwork) {
  const auto models = semantic_slam::SharedData("models");
  SEMANTIC_SLAM_SKIP_WITHOUT(models, "the models folder");
  SetParameters("real",
                SEMANTIC_SLAM_SOURCE_DIR "/config/cards/deeplabv3p_mnv2_ade20k32_320x240.yaml");
  ros::param::set("~real/models", *models);
  const auto node = MakeNode<SegmentationNode>("real");
  Listener<SemanticImage> answers(nh_, "real/semantic_image");
  ros::Publisher images = nh_.advertise<sensor_msgs::Image>("real/rgb/image_raw", 10);
  ASSERT_TRUE(
      SpinUntil([&] { return answers.connected() && images.getNumSubscribers() > 0; }, kLimitS));
  const cv::Mat photo = cv::imread(*models + "/photos_coco8/000000000036.jpg");
  ASSERT_FALSE(photo.empty());
  images.publish(Message(photo, NextStamp()));
  ASSERT_TRUE(SpinUntil([&] { return answers.last() != nullptr; }, kLimitS));
  const Segmentation found = ToSegmentation(answers.last(), Vocabulary());
  // A woman with an umbrella, about two thirds to the right.
  EXPECT_EQ(found.labels[0].at<LabelId>(static_cast<int>(0.62 * photo.rows),
                                        static_cast<int>(0.67 * photo.cols)),
            LabelOf("person"));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "segmentation_node_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
