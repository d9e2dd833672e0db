#include "semantic_slam_ros/segmentation_conversions.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <boost/make_shared.hpp>
#include <boost/weak_ptr.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::InputError;
using semantic_slam::kTopLabels;
using semantic_slam::LabelVocabulary;
using semantic_slam::MessageOf;
using semantic_slam::Segmentation;
using semantic_slam::SemanticCloud;
using semantic_slam::SemanticPoint;
using semantic_slam::SmallVocabulary;
using sensor_msgs::PointCloud2;
using ImageMsg = semantic_slam::SemanticImage;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// 3 x 2 pixels; every plane differs, and rows are part of a wider image.
Segmentation SomeSegmentation() {
  Segmentation segmentation;
  segmentation.stamp = Stamp{1305031453359684001};
  segmentation.vocabulary_hash = SmallVocabulary().hash();
  for (int i = 0; i < kTopLabels; ++i) {
    const cv::Mat wide(2, 5, CV_8UC1, cv::Scalar(i + 1));
    segmentation.labels[i] = wide(cv::Rect(1, 0, 3, 2));
    segmentation.confidences[i] = cv::Mat(2, 3, CV_8UC1, cv::Scalar(100 - 10 * i));
  }
  segmentation.labels[0].at<std::uint8_t>(1, 2) = 9;
  return segmentation;
}

std::string ImageError(const ImageMsg& msg) {
  return MessageOf<InputError>(
      [&] { ToSegmentation(boost::make_shared<const ImageMsg>(msg), SmallVocabulary()); });
}

TEST(LabelSetTest, ListsTheVocabulary) {
  const LabelVocabulary vocabulary = SmallVocabulary();
  const semantic_slam::LabelSet msg = ToLabelSet(vocabulary, Stamp{7});
  EXPECT_EQ(ToStamp(msg.header.stamp), Stamp{7});
  EXPECT_EQ(msg.hash, vocabulary.hash());
  ASSERT_EQ(msg.labels.size(), vocabulary.classes().size());
  EXPECT_EQ(msg.labels[3].id, 3);
  EXPECT_EQ(msg.labels[3].name, "chair");
  EXPECT_EQ(msg.labels[3].colour.r, 1.0f);
  EXPECT_EQ(msg.labels[3].colour.g, 0.0f);
  EXPECT_EQ(msg.labels[3].colour.a, 1.0f);
  EXPECT_TRUE(msg.labels[3].movable);
  EXPECT_FALSE(msg.labels[3].hollow);
  EXPECT_TRUE(msg.labels[4].hollow);
}

TEST(SemanticImageTest, ReadsBackWhatItWrites) {
  const Segmentation written = SomeSegmentation();
  const semantic_slam::SemanticImageConstPtr msg = ToSemanticImage(written, "camera");
  EXPECT_EQ(msg->header.frame_id, "camera");
  EXPECT_EQ(msg->width, 3u);
  EXPECT_EQ(msg->height, 2u);
  EXPECT_EQ(msg->labels[5], 9) << "plane 0, row 1, column 2";
  EXPECT_EQ(msg->labels[6], 2) << "plane 1";
  const Segmentation read = ToSegmentation(msg, SmallVocabulary());
  EXPECT_EQ(read.stamp, written.stamp);
  EXPECT_EQ(read.vocabulary_hash, written.vocabulary_hash);
  for (int i = 0; i < kTopLabels; ++i) {
    EXPECT_EQ(cv::norm(read.labels[i], written.labels[i], cv::NORM_L1), 0.0);
    EXPECT_EQ(cv::norm(read.confidences[i], written.confidences[i], cv::NORM_L1), 0.0);
  }
}

TEST(SemanticImageTest, PlanesAreTheMessagesAndKeepItAlive) {
  semantic_slam::SemanticImageConstPtr msg = ToSemanticImage(SomeSegmentation(), "camera");
  const boost::weak_ptr<const ImageMsg> watched(msg);
  Segmentation segmentation = ToSegmentation(msg, SmallVocabulary());
  EXPECT_EQ(segmentation.labels[1].data, msg->labels.data() + 6);
  EXPECT_EQ(segmentation.confidences[2].data, msg->confidences.data() + 12);
  msg.reset();
  EXPECT_FALSE(watched.expired());
  EXPECT_EQ(segmentation.labels[0].at<std::uint8_t>(1, 2), 9);
  segmentation = Segmentation();
  EXPECT_TRUE(watched.expired());
}

TEST(SemanticImageTest, RefusesWhatIsMalformed) {
  const ImageMsg good = *ToSemanticImage(SomeSegmentation(), "camera");
  ImageMsg msg = good;
  msg.width = 0;
  EXPECT_EQ(ImageError(msg), "semantic image: size is 0 x 2");
  msg = good;
  msg.height = 4000000000u;
  EXPECT_EQ(ImageError(msg), "semantic image: size is 3 x 4000000000");
  msg = good;
  msg.labels.pop_back();
  EXPECT_EQ(ImageError(msg),
            "semantic image: 3 x 2 px have 17 labels and 18 confidences, expected 18");
  msg = good;
  msg.confidences.resize(36);
  EXPECT_EQ(ImageError(msg),
            "semantic image: 3 x 2 px have 18 labels and 36 confidences, expected 18");
  msg = good;
  msg.label_set_hash = 5;
  semantic_slam::ExpectOneLineWith(ImageError(msg), {"another label set", "hash 5"});
  msg = good;
  msg.labels[13] = 8;
  EXPECT_EQ(ImageError(msg), "segmentation: label id 8 at pixel (1, 0) is not in the vocabulary");
}

SemanticCloud SomeCloud() {
  SemanticCloud cloud;
  cloud.stamp = Stamp{20};
  cloud.vocabulary_hash = SmallVocabulary().hash();
  cloud.points = {{{1.0f, 2.0f, 3.0f}, {10, 20, 30}, {4, 3, 1}, {0.5f, 0.25f, 0.125f}},
                  {{-1.0f, 0.5f, 4.0f}, {255, 0, 1}, {9, 0, 0}, {1.0f, 0.0f, 0.0f}}};
  return cloud;
}

std::string CloudError(const PointCloud2& msg) {
  return MessageOf<InputError>([&] { ToSemanticCloud(msg, SmallVocabulary()); });
}

void ExpectEqual(const SemanticPoint& a, const SemanticPoint& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.rgb, b.rgb);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.confidences, b.confidences);
}

TEST(SemanticCloudTest, HasTheDocumentedFields) {
  const PointCloud2 msg = *ToPointCloud2(SomeCloud(), "camera");
  std::string names;
  for (const auto& field : msg.fields) names += field.name + " ";
  EXPECT_EQ(names, "x y z rgb label1 label2 label3 confidence1 confidence2 confidence3 ");
  const sensor_msgs::PointCloud2ConstIterator<float> z(msg, "z"), confidence2(msg, "confidence2");
  const sensor_msgs::PointCloud2ConstIterator<std::uint8_t> red(msg, "r"), blue(msg, "b"),
      label3(msg, "label3");
  EXPECT_EQ(*z, 3.0f);
  EXPECT_EQ(*red, 10);
  EXPECT_EQ(*blue, 30);
  EXPECT_EQ(*label3, 1);
  EXPECT_EQ(*confidence2, 0.25f);
  EXPECT_EQ(msg.header.frame_id, "camera");
}

TEST(SemanticCloudTest, ReadsBackWhatItWrites) {
  const SemanticCloud written = SomeCloud();
  const SemanticCloud read = ToSemanticCloud(*ToPointCloud2(written, "camera"), SmallVocabulary());
  EXPECT_EQ(read.stamp, written.stamp);
  EXPECT_EQ(read.vocabulary_hash, written.vocabulary_hash);
  ASSERT_EQ(read.points.size(), 2u);
  for (int i = 0; i < 2; ++i) ExpectEqual(read.points[i], written.points[i]);
}

// Another sender's layout: other offsets and order, a gap at the end of points and of rows.
TEST(SemanticCloudTest, ReadsFieldsWhereverTheyLie) {
  const SemanticCloud cloud = SomeCloud();
  const PointCloud2 packed = *ToPointCloud2(cloud, "camera");
  PointCloud2 msg = packed;
  constexpr std::uint32_t kShift = 8;
  msg.point_step = packed.point_step + 2 * kShift;
  msg.width = 1, msg.height = 2;
  msg.row_step = msg.point_step + 4;
  std::reverse(msg.fields.begin(), msg.fields.end());
  for (auto& field : msg.fields) field.offset += kShift;
  msg.data.assign(2 * msg.row_step, 0xff);
  for (int i = 0; i < 2; ++i) {
    std::memcpy(msg.data.data() + i * msg.row_step + kShift,
                packed.data.data() + i * packed.point_step, packed.point_step);
  }
  const SemanticCloud read = ToSemanticCloud(msg, SmallVocabulary());
  ASSERT_EQ(read.points.size(), 2u);
  for (int i = 0; i < 2; ++i) ExpectEqual(read.points[i], cloud.points[i]);
}

TEST(SemanticCloudTest, AnEmptyCloudIsEmpty) {
  SemanticCloud empty = SomeCloud();
  empty.points.clear();
  EXPECT_TRUE(ToSemanticCloud(*ToPointCloud2(empty, "camera"), SmallVocabulary()).points.empty());
  EXPECT_TRUE(ToSemanticCloud(PointCloud2(), SmallVocabulary()).points.empty());
}

TEST(SemanticCloudTest, SkipsPointsThatAreNotFinite) {
  SemanticCloud cloud = SomeCloud();
  cloud.points[0].position.z() = kNan;
  cloud.points[0].labels = {200, 200, 200};  // whatever an invalid point says
  const SemanticCloud read = ToSemanticCloud(*ToPointCloud2(cloud, "camera"), SmallVocabulary());
  ASSERT_EQ(read.points.size(), 1u);
  ExpectEqual(read.points[0], cloud.points[1]);
}

TEST(SemanticCloudTest, RefusesFieldsThatAreMissingOrDoNotFit) {
  const PointCloud2 good = *ToPointCloud2(SomeCloud(), "camera");
  for (std::size_t i = 0; i < good.fields.size(); ++i) {
    PointCloud2 msg = good;
    msg.fields.erase(msg.fields.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(CloudError(msg), "semantic cloud: has no field " + good.fields[i].name);
    msg = good;
    msg.fields[i].datatype = sensor_msgs::PointField::FLOAT64;
    semantic_slam::ExpectOneLineWith(CloudError(msg), {good.fields[i].name.c_str(), "datatype 8"});
    msg = good;
    msg.fields[i].offset = 32;
    EXPECT_EQ(CloudError(msg), "semantic cloud: field " + good.fields[i].name +
                                   " at offset 32 does not fit into points of 32 bytes");
  }
}

TEST(SemanticCloudTest, RefusesSizesThatDoNotFit) {
  const PointCloud2 good = *ToPointCloud2(SomeCloud(), "camera");
  PointCloud2 msg = good;
  msg.data.pop_back();
  EXPECT_EQ(CloudError(msg), "semantic cloud: has 63 bytes, expected 64");
  msg = good;
  msg.row_step = 63;
  EXPECT_EQ(CloudError(msg), "semantic cloud: row_step is 63, expected at least 64");
  msg = good;
  msg.width = msg.height = 0xffffffff;
  EXPECT_NE(CloudError(msg), "");
  msg = good;
  msg.is_bigendian = 1;
  EXPECT_EQ(CloudError(msg), "semantic cloud: big-endian is not supported");
}

TEST(SemanticCloudTest, RefusesLabelsAndConfidencesThatAreNone) {
  const auto error_with = [](auto change) {
    SemanticCloud cloud = SomeCloud();
    change(cloud.points[1]);
    return CloudError(*ToPointCloud2(cloud, "camera"));
  };
  EXPECT_EQ(error_with([](SemanticPoint& point) { point.labels[2] = 8; }),
            "semantic cloud: label id 8 is not in the vocabulary");
  EXPECT_EQ(error_with([](SemanticPoint& point) { point.confidences[1] = -0.5f; }),
            "semantic cloud: confidence is -0.500000, expected 0 to 1");
  EXPECT_NE(error_with([](SemanticPoint& point) { point.confidences[1] = kNan; }), "");
  EXPECT_EQ(error_with([](SemanticPoint& point) { point.confidences[1] = 0.25f; }),
            "semantic cloud: confidences of a point sum up to 1.250000, expected at most 1");
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
