#include "semantic_slam/octree/map_picture.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "octree/octree_testing.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

// How many pixels have that hue: the given colour (red, green, blue), up to the shade.
int CountHue(const cv::Mat& image, const std::array<std::uint8_t, 3>& rgb) {
  int count = 0;
  const cv::Vec3d wanted(rgb[2], rgb[1], rgb[0]);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Vec3d pixel = image.at<cv::Vec3b>(y, x);
      const double shade = pixel.dot(wanted) / wanted.dot(wanted);
      count += shade > 0.25 && shade <= 1.0 && cv::norm(pixel - shade * wanted) < 3.0;
    }
  }
  return count;
}

class MapPictureTest : public testing::Test {
 protected:
  MapPictureTest() : tree_(0.1), vocabulary_(SmallVocabulary()) { AddRoom(tree_); }

  SemanticOcTree tree_;
  std::shared_ptr<const LabelVocabulary> vocabulary_;
};

TEST_F(MapPictureTest, ShowsFloorAndTableUnderTheCeiling) {
  const cv::Mat picture = DrawMapFromAbove(tree_, *vocabulary_);
  // 20 x 10 cells of 16 pixels, of which the table hides 25.
  EXPECT_GE(CountHue(picture, {255, 127, 14}), 25 * 256);
  EXPECT_GE(CountHue(picture, {150, 110, 80}), 170 * 256);
  EXPECT_LT(CountHue(picture, {225, 225, 235}), 256);
}

TEST_F(MapPictureTest, HigherIsBrighter) {
  const cv::Mat picture = DrawMapFromAbove(tree_, *vocabulary_);
  // The cell of (0.75, 0.5) is the table's; (1.5, 0.5) is floor. The map begins 24 pixels from the
  // corner.
  const cv::Vec3b table = picture.at<cv::Vec3b>(24 + 5 * 16 + 8, 24 + 7 * 16 + 8);
  const cv::Vec3b floor = picture.at<cv::Vec3b>(24 + 5 * 16 + 8, 24 + 15 * 16 + 8);
  EXPECT_EQ(table, cv::Vec3b(14, 127, 255));
  EXPECT_NEAR(floor[2], 0.45 * 150, 1.0);  // the darkest shade, rounded
}

TEST_F(MapPictureTest, HasALegendOnlyForClasses) {
  MapPictureOptions options;
  options.colour_mode = ColourMode::kRgb;
  const cv::Mat classes = DrawMapFromAbove(tree_, *vocabulary_);
  const cv::Mat seen = DrawMapFromAbove(tree_, *vocabulary_, options);
  EXPECT_LT(seen.cols, classes.cols - 200);
  EXPECT_EQ(CountHue(seen, {255, 127, 14}), 0);
}

TEST_F(MapPictureTest, LeavesOutWhatIsTooHigh) {
  MapPictureOptions options;
  options.max_z_m = 0.5;
  EXPECT_LT(CountHue(DrawMapFromAbove(tree_, *vocabulary_, options), {255, 127, 14}), 256);
}

TEST_F(MapPictureTest, DrawsTheCamerasPath) {
  MapPictureOptions options;
  options.camera_path_m = {{0.2, 0.2, 1.0}, {1.8, 0.8, 1.0}};
  const cv::Mat without = DrawMapFromAbove(tree_, *vocabulary_),
                with = DrawMapFromAbove(tree_, *vocabulary_, options);
  cv::Mat difference;
  cv::absdiff(with, without, difference);
  EXPECT_GT(cv::countNonZero(difference.reshape(1)), 500);
}

TEST_F(MapPictureTest, AnEmptyMapSaysSo) {
  const SemanticOcTree empty(0.1);
  const cv::Mat picture = DrawMapFromAbove(empty, *vocabulary_);
  ASSERT_FALSE(picture.empty());
  EXPECT_LT(cv::mean(picture)[0], 255.0);
}

TEST_F(MapPictureTest, AVastMapStaysAPicture) {
  SemanticOcTree vast(0.05);
  AddVoxel(vast, {-1500.0, -1500.0, 0.0}, 5);
  AddVoxel(vast, {1500.0, 1500.0, 0.0}, 5);
  const cv::Mat picture = DrawMapFromAbove(vast, *vocabulary_);
  EXPECT_LE(picture.cols, 1400);
}

TEST_F(MapPictureTest, TheSameMapGivesTheSameBytes) {
  const TemporaryFolder folder;
  WriteMapFromAbove(folder / "a.png", tree_, *vocabulary_);
  WriteMapFromAbove(folder / "b.png", tree_, *vocabulary_);
  const cv::Mat a = cv::imread(folder / "a.png"), b = cv::imread(folder / "b.png");
  ASSERT_FALSE(a.empty());
  EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(a, DrawMapFromAbove(tree_, *vocabulary_), cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace semantic_slam
