#include "semantic_slam/ground_truth/map_comparison_picture.h"

#include <gtest/gtest.h>

#include "ground_truth/small_run.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

cv::Mat Draw(const RunOutputs& run) {
  const MapEvaluation evaluation = EvaluateMaps(SmallWorld(), SmallVocabulary(), SmallTour(),
                                                *SmallCamera(), run, SmallEvaluation());
  return DrawMapComparison(evaluation, run, SmallVocabulary());
}

int PixelsOf(const cv::Mat& image, const cv::Scalar& colour) {
  cv::Mat is_colour;
  cv::inRange(image, colour, colour, is_colour);
  return cv::countNonZero(is_colour);
}

TEST(MapComparisonPictureTest, ShowsTruthAndMaps) {
  const cv::Mat picture = Draw(PerfectRun());
  ASSERT_EQ(picture.type(), CV_8UC3);
  const cv::Scalar occupied = cv::Scalar::all(30);
  const cv::Mat left = picture.colRange(0, picture.cols / 3);
  EXPECT_GT(PixelsOf(left, occupied), 1000);  // the walls
  // All three show them.
  EXPECT_GT(PixelsOf(picture, occupied), 2.7 * PixelsOf(left, occupied));
}

TEST(MapComparisonPictureTest, LeavesEmptyWhatWasNotMade) {
  RunOutputs run;
  run.trajectory = PerfectRun().trajectory;
  const cv::Mat all = Draw(PerfectRun()), partial = Draw(run);
  EXPECT_EQ(partial.size(), all.size());
  const cv::Scalar occupied = cv::Scalar::all(30);
  EXPECT_LT(PixelsOf(partial, occupied), 0.5 * PixelsOf(all, occupied));
}

}  // namespace
}  // namespace semantic_slam
