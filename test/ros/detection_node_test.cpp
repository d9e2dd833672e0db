// Drives detection, as a node and as a nodelet (detection_node.test, detection_nodelet.test), over
// real topics with a network that finds blocks; and a node in this process with a real one.

#include "semantic_slam_ros/detection_node.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "ros/colour_node_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/object_conversions.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/tiny_networks.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::DetectedBox;
using semantic_slam::DetectionArray;
using semantic_slam::Detections;
using semantic_slam::LabelOf;
using semantic_slam::Vocabulary;

// Grey, with a red block in one cell of the network's grid, 80 px wide.
cv::Mat RedBlock() {
  cv::Mat image(480, 640, CV_8UC3, cv::Scalar::all(90));
  image(cv::Rect(160, 240, 80, 80)) = cv::Scalar(0, 0, 255);
  return image;
}

class DetectionNodeTest : public ColourNodeTest<DetectionArray> {
 protected:
  DetectionNodeTest() : ColourNodeTest("detections") {}
};

TEST_F(DetectionNodeTest, FindsObjectsAtTheImagesStamp) {
  const auto msg = Ask(RedBlock());
  EXPECT_EQ(msg->header.frame_id, kCameraFrame);
  const Detections found = ToDetections(*msg, Vocabulary());
  EXPECT_EQ(found.image_size, cv::Size(640, 480));
  ASSERT_EQ(found.boxes.size(), 1u);
  EXPECT_EQ(found.boxes[0].label, LabelOf("chair"));
  EXPECT_NEAR(found.boxes[0].box.x, 159.5f, 1e-3);  // [px], single precision
  EXPECT_NEAR(found.boxes[0].box.br().y, 319.5f, 1e-3);
}

TEST_F(DetectionNodeTest, SaysSoWhenItFindsNothing) {
  EXPECT_TRUE(Ask(cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90)))->detections.empty());
}

TEST_F(DetectionNodeTest, LatchesTheLabels) {
  ExpectLabelsAreLatched(Vocabulary().hash(), Vocabulary().classes().size());
}

TEST_F(DetectionNodeTest, DrawsForThoseWhoLook) {
  ExpectOverlay("detection_overlay", RedBlock());
}

TEST_F(DetectionNodeTest, DropsAndCountsBadImagesAndLives) {
  ExpectBadImagesAreDroppedAndCounted(RedBlock());
  EXPECT_EQ(Ask(RedBlock())->detections.size(), 1u);
}

TEST_F(DetectionNodeTest, RefusesACardThatIsNotThere) {
  const auto error_of = [](const std::string& name) {
    return semantic_slam::MessageOf<semantic_slam::ConfigError>(
        [&] { MakeNode<DetectionNode>(name); });
  };
  SetParameters("bad", "");
  semantic_slam::ExpectOneLineWith(error_of("bad"),
                                   {"bad/card is empty, but must name a model card"});
  SetParameters("bad", semantic_slam::TinyNetworkCard("colour_segmenter"));
  semantic_slam::ExpectOneLineWith(error_of("bad"),
                                   {"colour_segmenter.yaml: head/type is neither"});
}

TEST_F(DetectionNodeTest, RunsARealNetwork) {
  const auto models = semantic_slam::SharedData("models");
  SEMANTIC_SLAM_SKIP_WITHOUT(models, "the models folder");
  SetParameters("real", SEMANTIC_SLAM_SOURCE_DIR "/config/cards/yolov8n_coco_320x256.yaml");
  ros::param::set("~real/models", *models);
  const auto node = MakeNode<DetectionNode>("real");
  Listener<DetectionArray> answers(nh_, "real/detections");
  ros::Publisher images = nh_.advertise<sensor_msgs::Image>("real/rgb/image_raw", 10);
  ASSERT_TRUE(
      SpinUntil([&] { return answers.connected() && images.getNumSubscribers() > 0; }, kLimitS));
  const cv::Mat photo = cv::imread(*models + "/photos_coco8/000000000036.jpg");
  ASSERT_FALSE(photo.empty());
  images.publish(Message(photo, NextStamp()));
  ASSERT_TRUE(SpinUntil([&] { return answers.last() != nullptr; }, kLimitS));
  const Detections found = ToDetections(*answers.last(), Vocabulary());
  EXPECT_TRUE(std::any_of(found.boxes.begin(), found.boxes.end(), [](const DetectedBox& box) {
    return box.label == LabelOf("person");
  })) << "a woman with an umbrella";
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "detection_node_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
