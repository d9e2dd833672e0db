#include "semantic_slam/segmentation/segmenter.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

const cv::Scalar kRed(0, 0, 255), kGreen(0, 255, 0), kBlue(255, 0, 0);  // BGR
constexpr Stamp kStamp{123};

// Quarters: red, green, blue, grey.
cv::Mat FourColours(cv::Size size) {
  cv::Mat image(size, CV_8UC3, cv::Scalar::all(128));
  const int w = size.width / 2, h = size.height / 2;
  image(cv::Rect(0, 0, w, h)) = kRed;
  image(cv::Rect(w, 0, w, h)) = kGreen;
  image(cv::Rect(0, h, w, h)) = kBlue;
  return image;
}

LabelId LabelAt(const Segmentation& segmentation, double x, double y) {
  return segmentation.labels[0].at<LabelId>(static_cast<int>(y * segmentation.size().height),
                                            static_cast<int>(x * segmentation.size().width));
}

std::string ErrorOf(const Model& model) {
  return MessageOf<ConfigError>([&] { Segmenter(model, Vocabulary(), {}); });
}

TEST(SegmenterTest, LabelsEveryPixelAtTheImagesSize) {
  Segmenter segmenter(ColourSegmenter(), Vocabulary(), {});
  for (const cv::Size size : {cv::Size(640, 480), cv::Size(320, 240), cv::Size(400, 100)}) {
    const Segmentation found = segmenter.Segment(FourColours(size), ColourOrder::kBgr, kStamp);
    EXPECT_EQ(found.stamp, kStamp);
    EXPECT_EQ(found.size(), size);
    EXPECT_NO_THROW(CheckSegmentation(found, Vocabulary()));
    EXPECT_EQ(LabelAt(found, 0.25, 0.25), LabelOf("chair"));
    EXPECT_EQ(LabelAt(found, 0.75, 0.25), LabelOf("plant"));
    EXPECT_EQ(LabelAt(found, 0.25, 0.75), LabelOf("tv"));
    EXPECT_EQ(LabelAt(found, 0.75, 0.75), LabelOf("wall"));
    EXPECT_EQ(LabelAt(found, 0.0, 0.0), LabelOf("chair"));
    EXPECT_EQ(LabelAt(found, 0.999, 0.999), LabelOf("wall"));
  }
}

TEST(SegmenterTest, ConfidencesAreThoseOfTheSoftmax) {
  Segmenter segmenter(ColourSegmenter(), Vocabulary(), {});
  const cv::Mat grey(48, 64, CV_8UC3, cv::Scalar::all(0));
  const Segmentation found = segmenter.Segment(grey, ColourOrder::kBgr, kStamp);
  // Black: scores -5, -5, -5 and 0.
  const double wall = 1.0 / (1.0 + 3.0 * std::exp(-5.0));
  EXPECT_EQ(found.confidences[0].at<std::uint8_t>(10, 10), std::floor(255.0 * wall));
  EXPECT_EQ(found.labels[1].at<LabelId>(10, 10), LabelOf("chair")) << "the lowest id of three";
  EXPECT_EQ(found.confidences[1].at<std::uint8_t>(10, 10),
            std::floor(255.0 * wall * std::exp(-5.0)));
}

TEST(SegmenterTest, TakesEitherChannelOrder) {
  Segmenter segmenter(ColourSegmenter(), Vocabulary(), {});
  const cv::Mat red(24, 32, CV_8UC3, kRed);
  EXPECT_EQ(LabelAt(segmenter.Segment(red, ColourOrder::kBgr, kStamp), 0.5, 0.5), LabelOf("chair"));
  EXPECT_EQ(LabelAt(segmenter.Segment(red, ColourOrder::kRgb, kStamp), 0.5, 0.5), LabelOf("tv"));
}

TEST(SegmenterTest, AResultIsItsOwn) {
  Segmenter segmenter(ColourSegmenter(), Vocabulary(), {});
  const cv::Mat red(24, 32, CV_8UC3, kRed), blue(24, 32, CV_8UC3, kBlue);
  const Segmentation first = segmenter.Segment(red, ColourOrder::kBgr, kStamp);
  segmenter.Segment(blue, ColourOrder::kBgr, kStamp);
  EXPECT_EQ(LabelAt(first, 0.5, 0.5), LabelOf("chair")) << "overwritten by the next image";
}

TEST(SegmenterTest, RefusesImagesThatAreNone) {
  Segmenter segmenter(ColourSegmenter(), Vocabulary(), {});
  EXPECT_THROW(segmenter.Segment({}, ColourOrder::kBgr, kStamp), InputError);
  EXPECT_THROW(segmenter.Segment(cv::Mat(4, 4, CV_8UC1), ColourOrder::kBgr, kStamp), InputError);
}

TEST(SegmenterTest, RefusesANetworkThatDoesNotFitItsCard) {
  Model model = ColourSegmenter();
  model.classes.push_back("yellow");
  EXPECT_EQ(ErrorOf(model),
            model.card.path +
                ": the network gives 1 x 4 x 24 x 32, expected 1 x 5 x h x w scores "
                "of the 5 classes in colour_segmenter.names");
  ExpectOneLineWith(ErrorOf(BlockDetector()),
                    {"block_detector.yaml: head/type is not segmentation"});
  model = BlockDetector();
  model.card.head.type = HeadType::kSegmentation;
  ExpectOneLineWith(ErrorOf(model), {"the network gives 48 x 7, expected 1 x 2 x h x w scores"});
}

// On a real image with a real network: byte for byte the same twice, and floor, table and people
// where they are.
TEST(SegmenterTest, RepeatsItselfOnAPhoto) {
  const auto models = SharedData("models");
  SEMANTIC_SLAM_SKIP_WITHOUT(models, "the models folder");
  const Model model = LoadModel(
      SEMANTIC_SLAM_SOURCE_DIR "/config/cards/deeplabv3p_mnv2_ade20k32_320x240.yaml", *models);
  const cv::Mat photo = cv::imread(*models + "/photos_coco8/000000000036.jpg");
  ASSERT_FALSE(photo.empty());
  const Segmentation a =
      Segmenter(model, Vocabulary(), {}).Segment(photo, ColourOrder::kBgr, kStamp);
  const Segmentation b =
      Segmenter(model, Vocabulary(), {}).Segment(photo, ColourOrder::kBgr, kStamp);
  for (int i = 0; i < kTopLabels; ++i) {
    EXPECT_EQ(cv::norm(a.labels[i], b.labels[i], cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(a.confidences[i], b.confidences[i], cv::NORM_INF), 0.0);
  }
  // photos_coco8/000000000036.txt: a woman with an umbrella; her box's middle is at (0.67, 0.62).
  EXPECT_EQ(LabelAt(a, 0.67, 0.62), LabelOf("person"));
}

}  // namespace
}  // namespace semantic_slam
