#include "semantic_slam/segmentation/segmentation_overlay.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dnn/label_drawing.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

// Left half chair, right half wall.
Segmentation Halves(cv::Size size) {
  Segmentation segmentation;
  segmentation.vocabulary_hash = Vocabulary().hash();
  for (int i = 0; i < kTopLabels; ++i) {
    segmentation.labels[i] = cv::Mat(size, CV_8UC1, cv::Scalar(LabelOf("wall")));
    segmentation.confidences[i] = cv::Mat(size, CV_8UC1, cv::Scalar(80));
  }
  segmentation.labels[0].colRange(0, size.width / 2).setTo(LabelOf("chair"));
  return segmentation;
}

TEST(DrawSegmentationTest, TintsEachPixelWithItsLabelsColour) {
  const cv::Size size(320, 240);
  const cv::Mat image(size, CV_8UC3, cv::Scalar::all(100));
  for (const ColourOrder order : {ColourOrder::kRgb, ColourOrder::kBgr}) {
    const cv::Mat picture = DrawSegmentation(image, order, Halves(size), Vocabulary());
    EXPECT_EQ(picture.size(), size);
    for (const auto& [u, name] : {std::pair{10, "chair"}, std::pair{300, "wall"}}) {
      const cv::Scalar colour = ColourOf(Vocabulary()[LabelOf(name)], order);
      for (int i = 0; i < 3; ++i) {
        // Two roundings to whole grey levels.
        EXPECT_NEAR(picture.at<cv::Vec3b>(10, u)[i], 0.6 * colour[i] + 0.4 * 100.0, 1.0) << name;
      }
    }
  }
  EXPECT_EQ(image.at<cv::Vec3b>(10, 10), cv::Vec3b::all(100)) << "the image is not drawn on";
}

TEST(DrawSegmentationTest, NamesWhatCanBeSeen) {
  const cv::Size size(320, 240);
  Segmentation segmentation = Halves(size);
  segmentation.labels[0].at<LabelId>(0, 0) = LabelOf("person");  // one pixel is not worth a name
  const cv::Mat picture = DrawSegmentation(cv::Mat(size, CV_8UC3, cv::Scalar::all(0)),
                                           ColourOrder::kRgb, segmentation, Vocabulary());
  // Of equal areas the lower id first: wall, then chair, then nothing. A tag's lowest row is plain.
  const auto colour_at = [&](int u) { return picture.at<cv::Vec3b>(size.height - 1, u); };
  const auto colour_of = [](const char* name) {
    const auto rgb = Vocabulary()[LabelOf(name)].rgb;
    return cv::Vec3b(rgb[0], rgb[1], rgb[2]);
  };
  EXPECT_EQ(colour_at(0), colour_of("wall"));
  EXPECT_EQ(colour_at(TagWidthPx("wall")), colour_of("chair"));
  const cv::Vec3b beyond = colour_at(TagWidthPx("wall") + TagWidthPx("chair"));
  EXPECT_NE(beyond, colour_of("person"));
}

TEST(DrawSegmentationTest, ALegendThatDoesNotFitIsCut) {
  const cv::Size size(40, 30);
  Segmentation segmentation = Halves(size);
  for (int u = 0; u < size.width; ++u) {
    segmentation.labels[0].col(u).setTo(u);  // forty labels
  }
  EXPECT_EQ(DrawSegmentation(cv::Mat(size, CV_8UC3, cv::Scalar::all(0)), ColourOrder::kRgb,
                             segmentation, Vocabulary())
                .size(),
            size);
}

TEST(DrawSegmentationTest, RefusesWhatDoesNotFitTogether) {
  const Segmentation segmentation = Halves({32, 24});
  const auto draw = [&](const cv::Mat& image) {
    DrawSegmentation(image, ColourOrder::kRgb, segmentation, Vocabulary());
  };
  EXPECT_THROW(draw(cv::Mat(24, 33, CV_8UC3)), InputError);
  EXPECT_THROW(draw(cv::Mat(24, 32, CV_8UC1)), InputError);
  EXPECT_THROW(draw(cv::Mat()), InputError);
  EXPECT_THROW(DrawSegmentation(cv::Mat(24, 32, CV_8UC3), ColourOrder::kRgb, {}, Vocabulary()),
               InputError);
}

}  // namespace
}  // namespace semantic_slam
