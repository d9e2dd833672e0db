#include "semantic_slam/common/class_list.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

std::string ErrorOf(const std::string& text) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("classes.yaml", text);
  return MessageOf<ConfigError>([&] { ReadClassList(path, SmallVocabulary()); });
}

TEST(ClassListTest, MergedLabelsCountAsTheirClassAndTheRestIsIgnored) {
  const TemporaryFolder folder;
  const std::string path =
      folder.Write("classes.yaml", "classes: [table, wall]\nmerge: {chair: table}\n");
  const ClassList classes = ReadClassList(path, SmallVocabulary());
  EXPECT_EQ(classes.names, (std::vector<std::string>{"table", "wall"}));
  EXPECT_EQ(classes.labels, (std::vector<LabelId>{4, 1}));
  EXPECT_EQ(classes.of_label[4], 0);
  EXPECT_EQ(classes.of_label[3], 0);
  EXPECT_EQ(classes.of_label[1], 1);
  for (const int id : {0, 2, 9, 100, 255}) EXPECT_EQ(classes.of_label[id], kIgnoredClass) << id;
}

TEST(ClassListTest, TellsHowMuchOfAnObjectMustBeVisible) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& text) {
    return ReadClassList(folder.Write("classes.yaml", text), SmallVocabulary()).least_visible_share;
  };
  EXPECT_EQ(read("classes: [chair]\n"), 0.0);
  EXPECT_EQ(read("classes: [chair]\nleast_visible_share: 0.5\n"), 0.5);
  ExpectOneLineWith(ErrorOf("classes: [chair]\nleast_visible_share: 1.5\n"),
                    {"classes.yaml", "least_visible_share", "1.5"});
}

TEST(ClassListTest, OptionalLabelsAreIgnoredAndMarked) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("classes.yaml", "classes: [chair]\noptional: [table]\n");
  const ClassList classes = ReadClassList(path, SmallVocabulary());
  EXPECT_EQ(classes.of_label[4], kIgnoredClass);
  EXPECT_TRUE(classes.is_optional[4]);
  EXPECT_EQ(classes.is_optional.count(), 1u);
}

TEST(ClassListTest, UnknownIsAClassIfTheFileSaysSo) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("classes.yaml", "classes: [unknown]\nmerge:\n");
  EXPECT_EQ(ReadClassList(path, SmallVocabulary()).of_label[kUnknownLabel], 0);
}

TEST(ClassListTest, RefusesWhatItCannotCount) {
  ExpectOneLineWith(ErrorOf("classes: [wall, cooker]"), {"classes.yaml", "'cooker'"});
  ExpectOneLineWith(ErrorOf("classes: [wall, wall]"), {"classes.yaml", "each once"});
  ExpectOneLineWith(ErrorOf("classes: []"), {"classes.yaml", "one or more"});
  ExpectOneLineWith(ErrorOf("merge: {chair: table}"), {"classes.yaml", "classes"});
  ExpectOneLineWith(ErrorOf("classes: [wall]\nmerge: {chair: table}"), {"'table'", "none of"});
  ExpectOneLineWith(ErrorOf("classes: [wall]\nmerge: {cooker: wall}"), {"'cooker'", "vocabulary"});
  ExpectOneLineWith(ErrorOf("classes: [wall]\nmerge: [chair]"), {"merge", "mapping"});
  ExpectOneLineWith(ErrorOf("classes: [wall]\noptional: [cooker]"), {"'cooker'", "vocabulary"});
  ExpectOneLineWith(ErrorOf("classes: [wall]\noptional: [wall]"), {"optional", "'wall'"});
  ExpectOneLineWith(ErrorOf("classes: [wall]\nclases: [floor]"), {"clases"});
}

// Every list that training has can be read, and each of its classes counts as itself.
TEST(ClassListTest, ReadsTheListsOfTraining) {
  const std::string repository = SEMANTIC_SLAM_SOURCE_DIR;
  const auto vocabulary = LabelVocabulary::Load(repository + "/config/labels.yaml");
  for (const std::string name : {"indoor", "furniture", "sun_rgbd", "appearance"}) {
    const ClassList classes =
        ReadClassList(repository + "/training/classes/" + name + ".yaml", vocabulary);
    for (std::size_t c = 0; c < classes.size(); ++c) {
      EXPECT_EQ(classes.of_label[*vocabulary.Find(classes.names[c])], static_cast<int>(c)) << name;
    }
  }
}

}  // namespace
}  // namespace semantic_slam
