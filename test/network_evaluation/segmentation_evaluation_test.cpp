#include "semantic_slam/network_evaluation/segmentation_evaluation.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/network_evaluation/model_classes.h"
#include "semantic_slam/network_evaluation/segmentation_score.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

const cv::Size kSize(64, 48);
const cv::Rect kLeft(0, 0, 32, 48);
const cv::Scalar kRed(0, 0, 255), kGreen(0, 255, 0);  // BGR; the network says chair and plant

class SegmentationEvaluationTest : public ::testing::Test {
 protected:
  // Red on the left, green on the right, with those true labels.
  LabelledImage Write(const std::string& name, LabelId left, LabelId right) {
    cv::Mat colour(kSize, CV_8UC3, kGreen);
    colour(kLeft) = kRed;
    cv::Mat labels(kSize, CV_8UC1, cv::Scalar(right));
    labels(kLeft) = left;
    cv::imwrite(folder_ / (name + "_colour.png"), colour);
    cv::imwrite(folder_ / (name + ".png"), labels);
    return {folder_ / (name + "_colour.png"), folder_ / (name + ".png")};
  }

  TemporaryFolder folder_;
  const Model model_ = ColourSegmenter();
  const ClassList classes_ = ClassesOfModel(model_, Vocabulary());
  Segmenter segmenter_{model_, Vocabulary(), {}};
};

TEST_F(SegmentationEvaluationTest, CountsWhatTheNetworkLabelsRight) {
  const std::vector<LabelledImage> images{
      Write("right", LabelOf("chair"), LabelOf("plant")),
      Write("half", LabelOf("chair"), LabelOf("tv")),
      Write("none", LabelOf("desk"), LabelOf("desk"))};  // that the network does not know
  std::vector<std::size_t> heard;
  const SegmentationEvaluation evaluation = EvaluateSegmentation(
      images, classes_, segmenter_, [&](std::size_t done) { heard.push_back(done); });
  EXPECT_EQ(heard, (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(evaluation.timing.count, 3);
  ASSERT_EQ(evaluation.image_accuracies.size(), 3u);
  EXPECT_EQ(evaluation.image_accuracies[0], 1.0);
  EXPECT_EQ(evaluation.image_accuracies[1], 0.5);
  EXPECT_TRUE(std::isnan(evaluation.image_accuracies[2]));
  const SegmentationScore score = ScoreSegmentation(evaluation.confusion);
  EXPECT_EQ(score.pixels, 2 * kSize.area());
  EXPECT_EQ(score.pixel_accuracy, 0.75);
}

TEST_F(SegmentationEvaluationTest, ExamplesShowTheClassesLabels) {
  ClassList classes = classes_;
  classes.of_label[LabelOf("plant")] = classes.of_label[LabelOf("chair")];  // merged
  const SegmentationExample example =
      MakeExample(Write("image", LabelOf("desk"), LabelOf("plant")), classes, segmenter_);
  EXPECT_EQ(example.truth.labels[0].at<LabelId>(20, 10), kUnknownLabel);
  EXPECT_EQ(example.truth.labels[0].at<LabelId>(20, 50), LabelOf("chair"));
  EXPECT_EQ(example.predicted.labels[0].at<LabelId>(20, 50), LabelOf("chair"));
  EXPECT_NO_THROW(CheckSegmentation(example.truth, Vocabulary()));
  EXPECT_NO_THROW(CheckSegmentation(example.predicted, Vocabulary()));
}

TEST_F(SegmentationEvaluationTest, RefusesLabelsOfAnotherSize) {
  LabelledImage image = Write("image", LabelOf("chair"), LabelOf("plant"));
  cv::imwrite(image.labels_path, cv::Mat(10, 10, CV_8UC1, cv::Scalar(5)));
  const std::string error = MessageOf<InputError>(
      [&] { EvaluateSegmentation({image}, classes_, segmenter_, [](std::size_t) {}); });
  ExpectOneLineWith(error, {"image.png", "10 x 10"});
}

}  // namespace
}  // namespace semantic_slam
