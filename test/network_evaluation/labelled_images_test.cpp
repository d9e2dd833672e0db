#include "semantic_slam/network_evaluation/labelled_images.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

// Names of image and labels, with a blank between them.
std::vector<std::string> Found(const std::vector<std::string>& sets,
                               const std::string& split = "test") {
  std::vector<std::string> names;
  for (const LabelledImage& image : FindLabelledImages(sets, split)) {
    EXPECT_TRUE(std::filesystem::path(image.image_path).is_absolute());
    names.push_back(std::filesystem::path(image.image_path).filename().string() + " " +
                    std::filesystem::path(image.labels_path).filename().string());
  }
  return names;
}

TEST(LabelledImagesTest, FindsRenderedSequencesAndLeavesOutImagesWithoutLabels) {
  const TemporaryFolder folder;
  folder.Write("set/a/rgb.txt", "# stamp file\n1.0 rgb/1.jpg\n2.0 rgb/2.jpg\n");
  folder.Write("set/a/labels.txt", "2.0 labels/2.png\n");
  folder.Write("set/b/rgb.txt", "1.0 rgb/3.jpg\n");
  folder.Write("set/b/labels.txt", "1.0 labels/3.png\n");
  EXPECT_EQ(Found({folder / "set"}), (std::vector<std::string>{"2.jpg 2.png", "3.jpg 3.png"}));
  EXPECT_EQ(Found({folder / "set/b", folder / "set/a"}),
            (std::vector<std::string>{"3.jpg 3.png", "2.jpg 2.png"}));
}

TEST(LabelledImagesTest, FindsAFolderOfImagesAndLabels) {
  const TemporaryFolder folder;
  for (const char* name : {"images/x.jpg", "images/y.png", "images/z.jpg", "labels/x.png",
                           "labels/z.png", "labels/other.png"}) {
    folder.Write(name, "");
  }
  EXPECT_EQ(Found({folder.path()}), (std::vector<std::string>{"x.jpg x.png", "z.jpg z.png"}));
}

TEST(LabelledImagesTest, FindsBothLayoutsOfSunRgbd) {
  const TemporaryFolder archive;
  for (const char* name :
       {"SUNRGBD-test_images/img-1.jpg", "SUNRGBD-train_images/img-1.jpg",
        "sunrgbd_train_test_labels/img-1.png", "sunrgbd_train_test_labels/img-2.png"}) {
    archive.Write(name, "");
  }
  EXPECT_EQ(Found({archive.path()}), (std::vector<std::string>{"img-1.jpg img-1.png"}));
  EXPECT_EQ(Found({archive.path()}, "train"), (std::vector<std::string>{"img-1.jpg img-2.png"}));
  const TemporaryFolder reorganised;
  for (const char* name : {"image/test/a.jpg", "label37/test/a.png", "image/train/b.jpg"}) {
    reorganised.Write(name, "");
  }
  EXPECT_EQ(Found({reorganised.path()}), (std::vector<std::string>{"a.jpg a.png"}));
  const std::string error =
      MessageOf<ConfigError>([&] { FindLabelledImages({reorganised.path()}, "train"); });
  ExpectOneLineWith(error, {"1 photos and 0 label images", "train"});
}

TEST(LabelledImagesTest, RefusesWhatIsNoSet) {
  const TemporaryFolder folder;
  folder.Write("bare/rgb.txt", "1.0 rgb/1.jpg\n");
  const auto error = [&](const char* name) {
    return MessageOf<ConfigError>([&] { FindLabelledImages({folder / name}, "test"); });
  };
  ExpectOneLineWith(error("missing"), {"missing", "no such folder"});
  std::filesystem::create_directories(folder / "empty");
  ExpectOneLineWith(error("empty"), {"empty", "no images with labels"});
  const std::string no_list =
      MessageOf<InputError>([&] { FindLabelledImages({folder / "bare"}, "test"); });
  ExpectOneLineWith(no_list, {"bare/labels.txt"});
}

}  // namespace
}  // namespace semantic_slam
