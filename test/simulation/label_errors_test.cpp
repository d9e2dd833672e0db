#include "semantic_slam/simulation/label_errors.h"

#include <cmath>

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr int kColumns = 20, kRows = 15, kCellPx = 8;

const LabelVocabulary& Vocabulary() {
  static const LabelVocabulary vocabulary =
      LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  return vocabulary;
}

// A chess board of chairs and tables, each an instance.
struct Board {
  cv::Mat labels = cv::Mat(kRows * kCellPx, kColumns* kCellPx, CV_8UC1);
  cv::Mat instances = cv::Mat(kRows * kCellPx, kColumns* kCellPx, CV_16UC1);

  Board() {
    const LabelId chair = *Vocabulary().Find("chair"), table = *Vocabulary().Find("table");
    for (int i = 0; i < kRows * kColumns; ++i) {
      const int column = i % kColumns, row = i / kColumns;
      const cv::Rect cell(column * kCellPx, row * kCellPx, kCellPx, kCellPx);
      labels(cell).setTo((column + row) % 2 == 0 ? chair : table);
      instances(cell).setTo(i + 1);
    }
  }
};

LabelErrorOptions WithoutErrors() {
  LabelErrorOptions options;
  options.confusion_probability = 0.0;
  options.unknown_probability = 0.0;
  options.border_wobble_px = 0.0;
  return options;
}

double ShareOf(const cv::Mat& mask) {
  return cv::countNonZero(mask) / static_cast<double>(mask.total());
}

bool SamePixels(const Segmentation& a, const Segmentation& b) {
  for (int i = 0; i < kTopLabels; ++i) {
    if (cv::norm(a.labels[i], b.labels[i], cv::NORM_INF) != 0.0) return false;
    if (cv::norm(a.confidences[i], b.confidences[i], cv::NORM_INF) != 0.0) return false;
  }
  return true;
}

TEST(LabelErrorsTest, WithoutErrorsTheFirstLabelIsTheTruth) {
  const Board board;
  const LabelErrors errors(WithoutErrors(), Vocabulary());
  const Segmentation seen = errors.Apply(board.labels, board.instances, Stamp{5});
  EXPECT_EQ(seen.stamp, Stamp{5});
  EXPECT_EQ(cv::norm(seen.labels[0], board.labels, cv::NORM_INF), 0.0);
}

TEST(LabelErrorsTest, GivesASegmentationWithPlausibleConfidences) {
  const Board board;
  LabelErrorOptions options;
  options.confusion_probability = 0.5;
  const Segmentation seen =
      LabelErrors(options, Vocabulary()).Apply(board.labels, board.instances, Stamp{5});
  EXPECT_NO_THROW(CheckSegmentation(seen, Vocabulary()));
  const auto& [first, second, third] = seen.confidences;
  EXPECT_EQ(cv::countNonZero(first < second), 0);
  EXPECT_EQ(cv::countNonZero(second < third), 0);
  cv::Mat sum;
  cv::add(first, second, sum, cv::noArray(), CV_16U);
  cv::add(sum, third, sum, cv::noArray(), CV_16U);
  EXPECT_EQ(cv::countNonZero(sum > 255), 0);
  EXPECT_EQ(cv::countNonZero((seen.labels[0] == seen.labels[1]) & (second > 0)), 0);
}

TEST(LabelErrorsTest, ThingsAreConfusedAtTheStatedRates) {
  const Board board;
  LabelErrorOptions options = WithoutErrors();
  options.confusion_probability = 0.2;
  options.unknown_probability = 0.1;
  const LabelErrors errors(options, Vocabulary());
  double confused = 0.0, unknown = 0.0;
  constexpr int kImages = 20;
  for (int i = 0; i < kImages; ++i) {
    const Stamp stamp = Stamp::FromSeconds(10.0 * i);
    const cv::Mat seen = errors.Apply(board.labels, board.instances, stamp).labels[0];
    const cv::Mat is_unknown = seen == kUnknownLabel;
    unknown += ShareOf(is_unknown) / kImages;
    confused += ShareOf((seen != board.labels) & ~is_unknown) / kImages;
  }
  // Four standard deviations of a share of 6000 independent things.
  EXPECT_NEAR(confused, 0.9 * 0.2, 4.0 * std::sqrt(0.2 * 0.8 / 6000));
  EXPECT_NEAR(unknown, 0.1, 4.0 * std::sqrt(0.1 * 0.9 / 6000));
}

TEST(LabelErrorsTest, AThingIsMistakenAsAWholeForASimilarClass) {
  const Board board;
  LabelErrorOptions options = WithoutErrors();
  options.confusion_probability = 1.0;
  const cv::Mat seen =
      LabelErrors(options, Vocabulary()).Apply(board.labels, board.instances, Stamp{5}).labels[0];
  const SimilarLabels similar(Vocabulary());
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const cv::Rect cell(column * kCellPx, row * kCellPx, kCellPx, kCellPx);
      const LabelId taken_for = seen.at<LabelId>(cell.tl());
      const auto& may_be = similar.Of(board.labels.at<LabelId>(cell.tl()));
      EXPECT_NE(std::find(may_be.begin(), may_be.end(), taken_for), may_be.end());
      EXPECT_EQ(cv::countNonZero(seen(cell) != taken_for), 0);
    }
  }
}

TEST(LabelErrorsTest, AMistakeLastsForAPeriod) {
  const Board board;
  LabelErrorOptions options = WithoutErrors();
  options.confusion_probability = 0.3;
  options.period_s = 1.0;
  const LabelErrors errors(options, Vocabulary());
  const auto seen_at = [&](double seconds) {
    return errors.Apply(board.labels, board.instances, Stamp::FromSeconds(seconds)).labels[0];
  };
  const cv::Mat now = seen_at(7.0);
  // A tenth of the things begin another period in a tenth of it, and of those less than half
  // change.
  EXPECT_LT(ShareOf(now != seen_at(7.1)), 0.1);
  EXPECT_GT(ShareOf(now != seen_at(9.0)), 0.2);
}

TEST(LabelErrorsTest, BordersWobbleAndInsidesDoNot) {
  cv::Mat labels(120, 160, CV_8UC1, cv::Scalar(*Vocabulary().Find("wall")));
  cv::Mat instances(120, 160, CV_16UC1, cv::Scalar(1));
  labels.colRange(80, 160).setTo(*Vocabulary().Find("sofa"));
  instances.colRange(80, 160).setTo(2);
  LabelErrorOptions options = WithoutErrors();
  options.border_wobble_px = 2.0;
  const LabelErrors errors(options, Vocabulary());
  const Segmentation seen = errors.Apply(labels, instances, Stamp{1});
  const cv::Mat wrong = seen.labels[0] != labels;
  EXPECT_GT(cv::countNonZero(wrong), 20);
  // 10 px: five standard deviations.
  EXPECT_EQ(cv::countNonZero(wrong.colRange(0, 70)), 0);
  EXPECT_EQ(cv::countNonZero(wrong.colRange(90, 160)), 0);
  EXPECT_EQ(cv::countNonZero(wrong & (seen.labels[1] != labels)), 0)
      << "what is really there comes second";
  const Segmentation later = errors.Apply(labels, instances, Stamp{2});
  EXPECT_GT(cv::countNonZero(seen.labels[0] != later.labels[0]), 0);
}

TEST(LabelErrorsTest, SameSeedSameBytesAnotherSeedOthers) {
  const Board board;
  LabelErrorOptions options;
  const Segmentation once =
      LabelErrors(options, Vocabulary()).Apply(board.labels, board.instances, Stamp{5});
  const Segmentation again =
      LabelErrors(options, Vocabulary()).Apply(board.labels, board.instances, Stamp{5});
  options.seed = 2;
  const Segmentation other =
      LabelErrors(options, Vocabulary()).Apply(board.labels, board.instances, Stamp{5});
  EXPECT_TRUE(SamePixels(once, again));
  EXPECT_FALSE(SamePixels(once, other));
}

TEST(LabelErrorsTest, WhereThereIsNothingNothingIsKnown) {
  const cv::Mat nothing8 = cv::Mat::zeros(20, 30, CV_8UC1);
  const cv::Mat nothing16 = cv::Mat::zeros(20, 30, CV_16UC1);
  const Segmentation seen =
      LabelErrors(LabelErrorOptions(), Vocabulary()).Apply(nothing8, nothing16, Stamp{5});
  EXPECT_EQ(cv::countNonZero(seen.labels[0]), 0);
}

TEST(LabelErrorsTest, RefusesOptionsOutOfRange) {
  LabelErrorOptions options;
  options.unknown_probability = 1.2;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { LabelErrors(options, Vocabulary()); }),
                    {"unknown_probability = 1.2"});
}

}  // namespace
}  // namespace semantic_slam
