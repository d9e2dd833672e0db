// Drives semantic_cloud_node, as a node and as a nodelet (semantic_cloud_node.test,
// semantic_cloud_nodelet.test), over real topics with images of the textured room.

#include "semantic_slam_ros/semantic_cloud_node.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>

#include "ros/ros_testing.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "testing/textured_room.h"
#include "testing/tiny_networks.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::CloudBuilder;
using semantic_slam::LabelOf;
using semantic_slam::RgbdImage;
using semantic_slam::Segmentation;
using semantic_slam::SemanticCloud;
using semantic_slam::Vocabulary;

constexpr char kCameraFrame[] = "test_camera_optical_frame";
constexpr double kLimitS = 20.0;

class SemanticCloudNodeTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const semantic_slam::TexturedRoom room;
    Rigid3d T_world_camera = Rigid3d::Identity();
    T_world_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // looks along x
    T_world_camera.translation() << -1.0, 0.0, 1.3;
    image_ = new RgbdImage(room.Render(T_world_camera, Stamp{1}));
  }
  static void TearDownTestSuite() { delete image_; }

  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return clouds_.connected() && colour_pub_.getNumSubscribers() > 0 &&
                 depth_pub_.getNumSubscribers() > 0 && info_pub_.getNumSubscribers() > 0 &&
                 semantic_pub_.getNumSubscribers() > 0;
        },
        kLimitS))
        << "the node did not connect; is it running?";
    info_pub_.publish(ToCameraInfo(semantic_slam::Freiburg1Camera().intrinsics,
                                   MakeHeader(NextStamp(), kCameraFrame)));
  }

  // Stamps go on from test to test.
  static Stamp NextStamp() {
    static std::int64_t ns = 1'000'000'000'000;
    return Stamp{ns += 100'000'000};
  }

  // The image as it is at `stamp`, depth with colour.
  static RgbdImage At(Stamp stamp) {
    RgbdImage image = *image_;
    image.stamp = image.depth_stamp = stamp;
    return image;
  }

  // Upper half wall, lower half table.
  static Segmentation Labels(const RgbdImage& image) {
    Segmentation segmentation;
    segmentation.stamp = image.stamp;
    segmentation.vocabulary_hash = Vocabulary().hash();
    for (int i = 0; i < semantic_slam::kTopLabels; ++i) {
      segmentation.labels[i] = cv::Mat::zeros(image.colour.size(), CV_8UC1);
      segmentation.confidences[i] = cv::Mat::zeros(image.colour.size(), CV_8UC1);
    }
    segmentation.labels[0].setTo(LabelOf("wall"));
    segmentation.labels[0]
        .rowRange(image.colour.rows / 2, image.colour.rows)
        .setTo(LabelOf("table"));
    segmentation.confidences[0].setTo(204);
    return segmentation;
  }

  void Send(const RgbdImage& image, const char* depth_encoding = "32FC1") {
    colour_pub_.publish(
        ToImage(ColourImage{image.colour, image.order}, MakeHeader(image.stamp, kCameraFrame)));
    cv::Mat depth = image.depth_m;
    if (std::string(depth_encoding) == "16UC1") {
      cv::Mat known = depth.clone();
      cv::patchNaNs(known, 0.0);
      known.convertTo(depth, CV_16U, 1000.0);
    }
    depth_pub_.publish(ToImage(depth, depth_encoding, MakeHeader(image.stamp, kCameraFrame)));
  }

  bool WaitForCloud(Stamp stamp, double limit_s = 2.0) {
    return SpinUntil(
        [&] { return clouds_.last() && ToStamp(clouds_.last()->header.stamp) == stamp; }, limit_s);
  }

  // Sends images and labels until there is a cloud of them: a node that has just come up may miss
  // some.
  SemanticCloud Ask(const char* depth_encoding = "32FC1", Stamp* stamp = nullptr) {
    for (int attempt = 0; attempt < 10; ++attempt) {
      const RgbdImage image = At(NextStamp());
      Send(image, depth_encoding);
      semantic_pub_.publish(ToSemanticImage(Labels(image), kCameraFrame));
      if (!WaitForCloud(image.stamp)) continue;
      if (stamp != nullptr) *stamp = image.stamp;
      return ToSemanticCloud(*clouds_.last(), Vocabulary());
    }
    ADD_FAILURE() << "no cloud of an image";
    return {};
  }

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

  static RgbdImage* image_;
  ros::NodeHandle nh_;
  Listener<sensor_msgs::PointCloud2> clouds_{nh_, "semantic_cloud"};
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
  ros::Publisher colour_pub_ = nh_.advertise<sensor_msgs::Image>("rgb/image_raw", 10);
  ros::Publisher depth_pub_ = nh_.advertise<sensor_msgs::Image>("depth_registered/image_raw", 10);
  ros::Publisher info_pub_ = nh_.advertise<sensor_msgs::CameraInfo>("rgb/camera_info", 10, true);
  ros::Publisher semantic_pub_ = nh_.advertise<semantic_slam::SemanticImage>("semantic_image", 10);
};

RgbdImage* SemanticCloudNodeTest::image_ = nullptr;

TEST_F(SemanticCloudNodeTest, IsTheCloudOfTheImageInTheImagesFrame) {
  Stamp stamp;
  const SemanticCloud cloud = Ask("32FC1", &stamp);
  EXPECT_EQ(clouds_.last()->header.frame_id, kCameraFrame);
  const CloudBuilder builder({}, std::make_shared<const semantic_slam::CameraModel>(
                                     semantic_slam::Freiburg1Camera().intrinsics));
  const SemanticCloud expected = builder.Build(At(stamp), Labels(At(stamp)));
  ASSERT_GT(expected.points.size(), 10000u);
  ASSERT_EQ(cloud.points.size(), expected.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); i += 1000) {
    EXPECT_EQ(cloud.points[i].position, expected.points[i].position);
    EXPECT_EQ(cloud.points[i].rgb, expected.points[i].rgb);
    EXPECT_EQ(cloud.points[i].labels, expected.points[i].labels);
    EXPECT_EQ(cloud.points[i].confidences, expected.points[i].confidences);
  }
}

TEST_F(SemanticCloudNodeTest, TakesDepthInMillimetresToo) {
  const SemanticCloud metres = Ask("32FC1"), millimetres = Ask("16UC1");
  ASSERT_GT(millimetres.points.size(), 10000u);
  // Rounding to a millimetre may move a pixel over a limit.
  EXPECT_NEAR(static_cast<double>(millimetres.points.size()) / metres.points.size(), 1.0, 0.01);
}

TEST_F(SemanticCloudNodeTest, JoinsLabelsThatComeLateOrSoon) {
  Ask();
  std::vector<RgbdImage> images;
  for (int i = 0; i < 8; ++i) images.push_back(At(NextStamp()));
  for (int i = 0; i < 6; ++i) Send(images[i]);
  semantic_pub_.publish(ToSemanticImage(Labels(images[1]), kCameraFrame));
  EXPECT_TRUE(WaitForCloud(images[1].stamp, kLimitS));
  semantic_pub_.publish(ToSemanticImage(Labels(images[6]), kCameraFrame));
  SpinUntil([] { return false; }, 0.2);
  Send(images[6]);
  Send(images[7]);
  EXPECT_TRUE(WaitForCloud(images[6].stamp, kLimitS));
}

TEST_F(SemanticCloudNodeTest, AnImageWithoutDepthGivesAnEmptyCloud) {
  Ask();
  RgbdImage image = At(NextStamp());
  image.depth_m =
      cv::Mat(image.depth_m.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  Send(image);
  semantic_pub_.publish(ToSemanticImage(Labels(image), kCameraFrame));
  ASSERT_TRUE(WaitForCloud(image.stamp, kLimitS));
  EXPECT_EQ(clouds_.last()->width, 0u);
}

TEST_F(SemanticCloudNodeTest, DropsAndCountsBadLabelsAndLives) {
  Ask();
  const int before = WaitForDrops("bad_semantic_image", 0);
  for (int fault = 0; fault < 4; ++fault) {
    const RgbdImage image = At(NextStamp());
    Send(image);
    const auto msg = ToSemanticImage(Labels(image), kCameraFrame);
    if (fault == 0) msg->label_set_hash ^= 1;
    if (fault == 1) msg->labels[1000] = 200;
    if (fault == 2) msg->labels.resize(10);
    if (fault == 3) msg->width = msg->height = 0;
    semantic_pub_.publish(msg);
    SpinUntil([] { return false; }, 0.2);  // or the next would push it out of the queue
  }
  EXPECT_GE(WaitForDrops("bad_semantic_image", before + 4), before + 4);

  // Labels of another size than the image, labels of no image, and labels without a stamp.
  const RgbdImage image = At(NextStamp());
  Send(image);
  RgbdImage small = image;
  small.colour = image.colour(cv::Rect(0, 0, 100, 100));
  semantic_pub_.publish(ToSemanticImage(Labels(small), kCameraFrame));
  EXPECT_GE(WaitForDrops("bad_image", 1), 1);
  for (int i = 0; i < 7; ++i) {
    semantic_pub_.publish(ToSemanticImage(Labels(At(NextStamp())), kCameraFrame));
    SpinUntil([] { return false; }, 0.2);
  }
  EXPECT_GE(WaitForDrops("no_images", 1), 1);
  const auto unstamped = ToSemanticImage(Labels(image), kCameraFrame);
  unstamped->header.stamp = ros::Time();
  semantic_pub_.publish(unstamped);
  EXPECT_GE(WaitForDrops("bad_stamp", 1), 1);
  EXPECT_GT(Ask().points.size(), 10000u);
}

TEST_F(SemanticCloudNodeTest, GoesOnAfterAJumpBackInTime) {
  Stamp now;
  Ask("32FC1", &now);
  // As when a bag starts over: everything ten minutes earlier, and then on from there.
  const std::int64_t ten_minutes_ns = 600'000'000'000;
  bool came = false;
  for (int i = 0; i < 20 && !came; ++i) {
    const RgbdImage image = At(Stamp{now.ns - ten_minutes_ns + 100'000'000 * i});
    Send(image);
    semantic_pub_.publish(ToSemanticImage(Labels(image), kCameraFrame));
    came = WaitForCloud(image.stamp, 0.5);
  }
  EXPECT_TRUE(came);
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "semantic_cloud_node_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
