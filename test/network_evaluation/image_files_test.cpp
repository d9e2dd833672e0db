#include "semantic_slam/network_evaluation/image_files.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

TEST(ImageFilesTest, FindsSequencesAtAnyDepth) {
  const TemporaryFolder folder;
  folder.Write("set/b/rgb.txt", "");
  folder.Write("set/a/deep/rgb.txt", "");
  folder.Write("set/c/depth.txt", "");
  EXPECT_EQ(SequenceFolders(folder / "set"),
            (std::vector<std::string>{folder / "set/a/deep", folder / "set/b"}));
  EXPECT_EQ(SequenceFolders(folder / "set/b"), (std::vector<std::string>{folder / "set/b"}));
  EXPECT_TRUE(SequenceFolders(folder / "missing").empty());
}

TEST(ImageFilesTest, ListsImagesByName) {
  const TemporaryFolder folder;
  for (const char* name : {"b.JPG", "a.png", "c.jpeg", "c.txt"}) folder.Write(name, "");
  EXPECT_EQ(ImagesIn(folder.path()),
            (std::vector<std::string>{folder / "a.png", folder / "b.JPG", folder / "c.jpeg"}));
  EXPECT_TRUE(ImagesIn(folder / "missing").empty());
}

TEST(ImageFilesTest, ReadsLabelsOf8And16Bits) {
  const TemporaryFolder folder;
  cv::Mat ids(2, 3, CV_16UC1, cv::Scalar(7));
  ids.at<std::uint16_t>(1, 2) = 1000;
  cv::imwrite(folder / "ids16.png", ids);
  cv::imwrite(folder / "ids8.png", cv::Mat(2, 3, CV_8UC1, cv::Scalar(9)));
  const cv::Mat labels = ReadLabelImage(folder / "ids16.png", {3, 2});
  EXPECT_EQ(labels.type(), CV_8UC1);
  EXPECT_EQ(labels.at<std::uint8_t>(0, 0), 7);
  EXPECT_EQ(labels.at<std::uint8_t>(1, 2), 255);
  EXPECT_EQ(ReadLabelImage(folder / "ids8.png", {3, 2}).at<std::uint8_t>(0, 0), 9);
}

TEST(ImageFilesTest, RefusesWhatIsNoSuchImage) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "colour.png", cv::Mat(2, 3, CV_8UC3, cv::Scalar::all(5)));
  cv::imwrite(folder / "ids.png", cv::Mat(2, 3, CV_8UC1, cv::Scalar(5)));
  folder.Write("text.png", "no image");
  const auto labels_error = [&](const char* name, cv::Size size) {
    return MessageOf<InputError>([&] { ReadLabelImage(folder / name, size); });
  };
  ExpectOneLineWith(labels_error("colour.png", {3, 2}), {"colour.png", "grey"});
  ExpectOneLineWith(labels_error("text.png", {3, 2}), {"text.png", "grey"});
  ExpectOneLineWith(labels_error("missing.png", {3, 2}), {"missing.png"});
  ExpectOneLineWith(labels_error("ids.png", {2, 3}), {"ids.png", "3 x 2", "2 x 3"});
  for (const char* name : {"text.png", "missing.png"}) {
    const std::string error = MessageOf<InputError>([&] { ReadColourImage(folder / name); });
    ExpectOneLineWith(error, {name});
  }
  EXPECT_EQ(ReadColourImage(folder / "ids.png").type(), CV_8UC3);
}

TEST(ImageFilesTest, SpreadsEvenly) {
  const std::vector<int> items{0, 1, 2, 3, 4, 5, 6};
  EXPECT_EQ(Spread(items, 3), (std::vector<int>{0, 2, 4}));
  EXPECT_EQ(Spread(items, 7), items);
  EXPECT_EQ(Spread(items, 0), items);
  EXPECT_TRUE(Spread(std::vector<int>(), 3).empty());
}

}  // namespace
}  // namespace semantic_slam
