#include "semantic_slam/network_evaluation/boxed_images.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

std::vector<BoxedImage> Find(const std::string& set, const ModelCard& card = {}) {
  return FindBoxedImages({set}, "val", card, Vocabulary());
}

TEST(BoxedImagesTest, FindsRenderedSequencesByLabelIds) {
  const TemporaryFolder folder;
  folder.Write("set/a/rgb.txt", "1.0 rgb/1.000000.jpg\n2.0 rgb/2.000000.jpg\n");
  folder.Write("set/a/boxes/2.000000.txt", "");
  const std::vector<BoxedImage> found = Find(folder / "set");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].image_path, folder / "set/a/rgb/2.000000.jpg");
  EXPECT_EQ(found[0].boxes_path, folder / "set/a/boxes/2.000000.txt");
  EXPECT_EQ((*found[0].label_of_class)[LabelOf("desk")], LabelOf("desk"));
}

TEST(BoxedImagesTest, FindsFoldersOfYoloByTheNamesOfTheirClasses) {
  const TemporaryFolder folder;
  folder.Write("images/val/a.jpg", "");
  folder.Write("data.yaml", "names: [couch, Coffee Table, spaceship]\nval: images/val\n");
  ModelCard card;
  card.label_map = {{"couch", "sofa"}};
  for (const std::string& set : {folder.path(), folder / "data.yaml"}) {
    const std::vector<BoxedImage> found = Find(set, card);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(std::filesystem::path(found[0].boxes_path).lexically_normal(),
              folder / "labels/val/a.txt");
    EXPECT_EQ(*found[0].label_of_class,
              (std::vector<LabelId>{LabelOf("sofa"), LabelOf("coffee_table"), kUnknownLabel}));
  }
}

TEST(BoxedImagesTest, WithoutAFolderCalledImagesBoxesLieBesideThem) {
  const TemporaryFolder folder;
  folder.Write("photos/a.jpg", "");
  folder.Write("data.yaml", "names: [chair]\nval: photos\n");
  const std::filesystem::path boxes(Find(folder.path())[0].boxes_path);
  EXPECT_EQ(boxes.lexically_normal(), folder / "photos/a.txt");
}

TEST(BoxedImagesTest, RefusesWhatIsNoSet) {
  const TemporaryFolder folder;
  folder.Write("bare/rgb.txt", "1.0 rgb/1.jpg\n");
  const auto error = [&](const char* name) {
    return MessageOf<ConfigError>([&] { Find(folder / name); });
  };
  ExpectOneLineWith(error("missing"), {"missing", "no such folder"});
  ExpectOneLineWith(error("missing.yaml"), {"missing.yaml"});
  ExpectOneLineWith(error("bare"), {"bare", "no images with boxes"});
}

}  // namespace
}  // namespace semantic_slam
