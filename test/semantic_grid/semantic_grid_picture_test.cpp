#include "semantic_slam/semantic_grid/semantic_grid_picture.h"

#include <gtest/gtest.h>

#include "semantic_grid/small_plan.h"
#include "semantic_slam/semantic_grid/semantic_grid_builder.h"

namespace semantic_slam {
namespace {

cv::Mat Picture(const OccupancyMap& map, const ObjectMap& objects) {
  const SemanticGridBuilder builder({}, {}, SmallVocabulary());
  return DrawSemanticGrid(builder.Build(map, objects), map, objects, builder.vocabulary());
}

int CountOf(const cv::Mat& picture, const cv::Vec3b& colour) {
  cv::Mat mask;
  cv::inRange(picture, cv::Scalar(colour), cv::Scalar(colour), mask);
  return cv::countNonZero(mask);
}

// The map's cells are 12 pixels wide; the picture begins 24 pixels from the upper left.
cv::Vec3b AtCell(const cv::Mat& picture, int x, int y) {
  return picture.at<cv::Vec3b>(24 + 12 * (9 - y) + 6, 24 + 12 * x + 6);
}

TEST(SemanticGridPictureTest, ShowsTheFloorPlanInGreysWithYUp) {
  OccupancyMap map = FreePlan();
  map.cells[0] = 100;
  map.cells[9] = OccupancyMap::kUnknown;
  const cv::Mat picture = Picture(map, ObjectMap());
  EXPECT_EQ(AtCell(picture, 0, 0), cv::Vec3b(30, 30, 30));
  EXPECT_EQ(AtCell(picture, 9, 0), cv::Vec3b(205, 205, 205));
  EXPECT_EQ(AtCell(picture, 5, 5), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(AtCell(picture, 0, 9), cv::Vec3b(255, 255, 255));
}

TEST(SemanticGridPictureTest, TintsCellsByClassAndProbability) {
  MapObject sure = SmallTable();
  sure.footprint_m = {{0.2, 0.2}, {0.6, 0.2}, {0.6, 0.8}, {0.2, 0.8}};
  MapObject doubtful = sure;
  doubtful.labels = {{4, 0.5f}};
  // Above the name, which stands in the middle; tables are pure green.
  const cv::Vec3b strong = AtCell(Picture(FreePlan(), ObjectMapOf({sure})), 3, 7);
  const cv::Vec3b weak = AtCell(Picture(FreePlan(), ObjectMapOf({doubtful})), 3, 7);
  EXPECT_EQ(strong[1], 255);
  EXPECT_EQ(strong[0], 64) << "a quarter of white";
  EXPECT_GT(weak[0], 150);
  EXPECT_LT(weak[0], 170) << "about 1 - 0.75 * 0.5";
}

TEST(SemanticGridPictureTest, NamesTheClassesInTheLegend) {
  const cv::Mat with = Picture(FreePlan(), ObjectMapOf({SmallTable()}));
  const cv::Mat without = Picture(FreePlan(), ObjectMap());
  const cv::Vec3b table(0, 255, 0);
  EXPECT_GT(CountOf(with, table), 150) << "a square of 16 x 16 pixels";
  EXPECT_EQ(CountOf(without, table), 0);
}

TEST(SemanticGridPictureTest, CropsToWhatIsKnown) {
  OccupancyMap map = FreePlan();
  map.width = map.height = 500;
  map.cells.assign(500 * 500, OccupancyMap::kUnknown);
  for (int i = 0; i < 10; ++i) map.cells[200 * 500 + 200 + i] = 0;
  const cv::Mat picture = Picture(map, ObjectMap());
  EXPECT_LT(picture.cols, 24 * 3 + 200 + 12 * 17) << "ten cells and three to either side";
}

TEST(SemanticGridPictureTest, StaysOfAReadableSizeForALargeMap) {
  OccupancyMap map = FreePlan();
  map.width = 3000, map.height = 2000;
  map.cells.assign(3000 * 2000, 0);
  const cv::Mat picture = Picture(map, ObjectMap());
  EXPECT_EQ(picture.cols, 1000 + 3 * 24 + 200);
}

TEST(SemanticGridPictureTest, SaysThatThereIsNothing) {
  const cv::Mat picture = Picture(OccupancyMap(), ObjectMap());
  EXPECT_FALSE(picture.empty());
  EXPECT_LT(CountOf(picture, {255, 255, 255}), picture.rows * picture.cols) << "a line of text";
}

TEST(SemanticGridPictureTest, CopesWithObjectsWithoutOutlineOrClass) {
  MapObject bare = SmallTable(), nameless = SmallTable();
  bare.footprint_m.clear();
  nameless.labels.clear();
  EXPECT_FALSE(Picture(FreePlan(), ObjectMapOf({bare, nameless})).empty());
}

}  // namespace
}  // namespace semantic_slam
