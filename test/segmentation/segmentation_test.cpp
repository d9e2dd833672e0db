#include "semantic_slam/segmentation/segmentation.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

Segmentation Good() {
  Segmentation segmentation;
  segmentation.vocabulary_hash = Vocabulary().hash();
  for (int i = 0; i < kTopLabels; ++i) {
    segmentation.labels[i] = cv::Mat(3, 4, CV_8UC1, cv::Scalar(i));
    segmentation.confidences[i] = cv::Mat(3, 4, CV_8UC1, cv::Scalar(80 - i));
  }
  return segmentation;
}

std::string ErrorOf(const Segmentation& segmentation) {
  return MessageOf<InputError>([&] { CheckSegmentation(segmentation, Vocabulary()); });
}

TEST(ToByteTest, RoundsDown) {
  EXPECT_EQ(ToByte(0.0f), 0);
  EXPECT_EQ(ToByte(0.5f), 127);
  EXPECT_EQ(ToByte(0.999f), 254);
  EXPECT_EQ(ToByte(1.0f), 255);
}

TEST(SureSegmentationTest, IsCompleteAndSure) {
  const cv::Mat labels(3, 4, CV_8UC1, cv::Scalar(5));
  const Segmentation sure = SureSegmentation(labels, Stamp{7}, Vocabulary().hash());
  EXPECT_EQ(ErrorOf(sure), "");
  EXPECT_EQ(sure.stamp, Stamp{7});
  EXPECT_EQ(sure.labels[0].data, labels.data);
  EXPECT_EQ(sure.confidences[0].at<std::uint8_t>(2, 3), 255);
  EXPECT_EQ(sure.confidences[1].at<std::uint8_t>(2, 3), 0);
}

TEST(CheckSegmentationTest, TakesAGoodOne) {
  EXPECT_EQ(ErrorOf(Good()), "");
}

TEST(CheckSegmentationTest, RefusesAnotherVocabulary) {
  Segmentation segmentation = Good();
  segmentation.vocabulary_hash = 5;
  EXPECT_EQ(ErrorOf(segmentation), "segmentation: made with another label set, hash 5, expected " +
                                       std::to_string(Vocabulary().hash()));
}

TEST(CheckSegmentationTest, RefusesMissingAndMissizedPlanes) {
  Segmentation segmentation = Good();
  segmentation.labels[0] = cv::Mat();
  EXPECT_EQ(ErrorOf(segmentation), "segmentation: has no pixels");
  segmentation = Good();
  segmentation.labels[2] = cv::Mat(4, 4, CV_8UC1, cv::Scalar(0));
  EXPECT_EQ(ErrorOf(segmentation),
            "segmentation: label plane 2 is CV_8UC1 of 4 x 4 px, expected CV_8UC1 of 4 x 3");
  segmentation = Good();
  segmentation.confidences[1] = cv::Mat(3, 4, CV_32FC1, cv::Scalar(0));
  EXPECT_EQ(ErrorOf(segmentation),
            "segmentation: confidence plane 1 is CV_32FC1 of 4 x 3 px, expected CV_8UC1 of 4 x 3");
}

TEST(CheckSegmentationTest, NamesAPixelOfAnUnknownId) {
  Segmentation segmentation = Good();
  segmentation.labels[1].at<LabelId>(2, 1) = 200;
  EXPECT_EQ(ErrorOf(segmentation),
            "segmentation: label id 200 at pixel (1, 2) is not in the vocabulary");
}

}  // namespace
}  // namespace semantic_slam
