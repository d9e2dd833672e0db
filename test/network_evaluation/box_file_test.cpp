#include "semantic_slam/network_evaluation/box_file.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

const cv::Size kImage(200, 100);

std::vector<FileBox> Read(const std::string& text) {
  const TemporaryFolder folder;
  return ReadBoxFile(folder.Write("boxes.txt", text), kImage);
}

void ExpectBox(const cv::Rect2f& box, const cv::Rect2f& expected) {
  constexpr double kTolerancePx = 1e-4;  // single precision at 200 px
  EXPECT_NEAR(box.x, expected.x, kTolerancePx);
  EXPECT_NEAR(box.y, expected.y, kTolerancePx);
  EXPECT_NEAR(box.width, expected.width, kTolerancePx);
  EXPECT_NEAR(box.height, expected.height, kTolerancePx);
}

TEST(BoxFileTest, ReadsBoxesInPixels) {
  const std::vector<FileBox> boxes = Read("5 0.5 0.5 0.2 0.4\n\n0.0 0.25 0.5 0.5 1.0\r\n");
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].class_number, 5);
  ExpectBox(boxes[0].box, {79.5f, 29.5f, 40.0f, 40.0f});  // edges of pixels lie at halves
  EXPECT_EQ(boxes[1].class_number, 0);
  ExpectBox(boxes[1].box, {-0.5f, -0.5f, 100.0f, 100.0f});
}

TEST(BoxFileTest, ALineMayTellWhichShareIsVisible) {
  const std::vector<FileBox> boxes = Read("5 0.5 0.5 0.2 0.4 0.25\n5 0.5 0.5 0.2 0.4\n");
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].visible_share, 0.25);
  EXPECT_EQ(boxes[0].box, boxes[1].box);
  EXPECT_EQ(boxes[1].visible_share, 1.0);
}

TEST(BoxFileTest, OfAPolygonTheBoxAroundItCounts) {
  const std::vector<FileBox> boxes = Read("1 0.1 0.2 0.3 0.1 0.2 0.6\n");
  ASSERT_EQ(boxes.size(), 1u);
  ExpectBox(boxes[0].box, {19.5f, 9.5f, 40.0f, 50.0f});
}

TEST(BoxFileTest, BoxesAreCutAtTheImage) {
  const std::vector<FileBox> boxes = Read("1 1.0 0.5 0.2 0.2\n1 3 3 0.1 0.1\n");
  ExpectBox(boxes[0].box, {179.5f, 39.5f, 20.0f, 20.0f});
  EXPECT_TRUE(boxes[1].box.empty());
}

TEST(BoxFileTest, NoFileNoBoxes) {
  EXPECT_TRUE(ReadBoxFile("/missing/boxes.txt", kImage).empty());
  EXPECT_TRUE(Read("").empty());
}

TEST(BoxFileTest, RefusesOtherLines) {
  for (const char* line :
       {"1 0.5 0.5 0.2", "chair 0.5 0.5 0.2 0.2", "1.5 0.5 0.5 0.2 0.2", "1 0.5 0.5 nan 0.2",
        "1 0.1 0.1 0.2 0.2 0.3 0.3 0.4", "1 0.5 0.5 0.2 0.2 x", "1e9 0.5 0.5 0.2 0.2"}) {
    const std::string error =
        MessageOf<InputError>([&] { Read(std::string("0 0.5 0.5 0.1 0.1\n") + line + "\n"); });
    ExpectOneLineWith(error, {"boxes.txt:2", "expected class"});
  }
}

}  // namespace
}  // namespace semantic_slam
