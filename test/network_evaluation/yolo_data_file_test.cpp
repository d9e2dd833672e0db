#include "semantic_slam/network_evaluation/yolo_data_file.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

std::vector<std::string> FileNames(const YoloData& data) {
  std::vector<std::string> names;
  for (const std::string& image : data.images) {
    names.push_back(std::filesystem::path(image).filename().string());
  }
  return names;
}

TEST(YoloDataFileTest, ReadsNamesAndImagesOfTheSplit) {
  const TemporaryFolder folder;
  folder.Write("images/val/b.jpg", "");
  folder.Write("images/val/a.jpg", "");
  const std::string path =
      folder.Write("data.yaml", "nc: 2\nnames: [chair, dining table]\nval: images/val\n");
  const YoloData data = ReadYoloData(path, "val");
  EXPECT_EQ(data.names, (std::vector<std::string>{"chair", "dining table"}));
  EXPECT_EQ(FileNames(data), (std::vector<std::string>{"a.jpg", "b.jpg"}));
}

TEST(YoloDataFileTest, NamesMayBeNumbered) {
  const TemporaryFolder folder;
  folder.Write("val/a.jpg", "");
  const std::string path =
      folder.Write("data.yaml", "names: {10: lamp, 0: chair, 2: table}\nval: val\n");
  EXPECT_EQ(ReadYoloData(path, "val").names, (std::vector<std::string>{"chair", "table", "lamp"}));
}

TEST(YoloDataFileTest, FindsTheSplitWhereToolsPutIt) {
  const TemporaryFolder folder;
  folder.Write("elsewhere/photos/a.jpg", "");
  folder.Write("valid/images/b.jpg", "");
  folder.Write("list.txt", "valid/images/b.jpg\n\nmore/c.jpg\r\n");
  const std::string path = folder.Write(
      "data.yaml",
      "path: elsewhere\nnames: [chair]\ntrain: photos\nval: ../valid/images\ntest: list.txt\n");
  EXPECT_EQ(FileNames(ReadYoloData(path, "train")), (std::vector<std::string>{"a.jpg"}));
  EXPECT_EQ(FileNames(ReadYoloData(path, "val")), (std::vector<std::string>{"b.jpg"}));
  EXPECT_EQ(FileNames(ReadYoloData(path, "test")), (std::vector<std::string>{"b.jpg", "c.jpg"}));
}

TEST(YoloDataFileTest, RefusesWhatItDoesNotUnderstand) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& text) {
    const std::string path = folder.Write("data.yaml", text);
    return MessageOf<ConfigError>([&] { ReadYoloData(path, "val"); });
  };
  ExpectOneLineWith(error("val: ."), {"data.yaml", "names"});
  ExpectOneLineWith(error("names: []\nval: ."), {"data.yaml", "names"});
  ExpectOneLineWith(error("names: {x: chair}\nval: ."), {"data.yaml", "names"});
  ExpectOneLineWith(error("names: [chair]"), {"data.yaml", "val"});
  ExpectOneLineWith(error("names: [chair]\nval: nowhere"), {"data.yaml", "nowhere"});
  ExpectOneLineWith(MessageOf<ConfigError>([&] { ReadYoloData(folder / "no.yaml", "val"); }),
                    {"no.yaml"});
}

}  // namespace
}  // namespace semantic_slam
