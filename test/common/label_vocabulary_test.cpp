#include "semantic_slam/common/label_vocabulary.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr char kTwoLabels[] =
    "labels:\n"
    "  - {id: 7, name: table, colour: [1, 2, 3], movable: true, hollow: true, cost: 9}\n"
    "  - {id: 0, name: unknown, colour: [4, 5, 6]}\n";

LabelClass Class(LabelId id, const std::string& name) {
  LabelClass label;
  label.id = id;
  label.name = name;
  return label;
}

LabelVocabulary Read(const std::string& yaml) {
  const TemporaryFolder folder;
  return LabelVocabulary::Load(folder.Write("labels.yaml", yaml));
}

std::string ErrorOf(const std::string& yaml) {
  return MessageOf<ConfigError>([&] { Read(yaml); });
}

std::string ErrorOfClasses(const std::vector<LabelClass>& classes) {
  return MessageOf<ConfigError>([&] { LabelVocabulary{classes}; });
}

TEST(LabelVocabularyTest, ReadsEveryKeyAndSortsById) {
  const LabelVocabulary vocabulary = Read(kTwoLabels);
  ASSERT_EQ(vocabulary.classes().size(), 2u);
  EXPECT_EQ(vocabulary.classes()[0].name, "unknown");
  const LabelClass& table = vocabulary[7];
  EXPECT_EQ(table.name, "table");
  EXPECT_EQ(table.rgb, (std::array<std::uint8_t, 3>{1, 2, 3}));
  EXPECT_TRUE(table.movable && table.hollow);
  EXPECT_EQ(table.cost, 9);
}

TEST(LabelVocabularyTest, DefaultsAreAFixedSolidObstacle) {
  const LabelClass unknown = Read(kTwoLabels).classes()[0];
  EXPECT_FALSE(unknown.movable || unknown.hollow);
  EXPECT_EQ(unknown.cost, 254);
}

TEST(LabelVocabularyTest, FindsByIdAndByName) {
  const LabelVocabulary vocabulary = Read(kTwoLabels);
  EXPECT_TRUE(vocabulary.Contains(7));
  EXPECT_FALSE(vocabulary.Contains(1));
  EXPECT_FALSE(vocabulary.Contains(kReservedLabel));
  EXPECT_EQ(vocabulary.Find("table"), LabelId{7});
  EXPECT_FALSE(vocabulary.Find("Table"));
}

TEST(LabelVocabularyTest, HashTellsIdsAndNamesApart) {
  const auto hash = [](const std::vector<LabelClass>& classes) {
    return LabelVocabulary(classes).hash();
  };
  const LabelClass unknown = Class(0, "unknown");
  const std::uint64_t first = hash({unknown, Class(1, "a"), Class(2, "b")});
  EXPECT_EQ(first, hash({Class(2, "b"), unknown, Class(1, "a")}));
  EXPECT_NE(first, hash({unknown, Class(1, "b"), Class(2, "a")}));
  EXPECT_NE(first, hash({unknown, Class(1, "a"), Class(3, "b")}));
  EXPECT_NE(first, hash({unknown, Class(1, "a")}));
  LabelClass repainted = Class(2, "b");
  repainted.rgb = {9, 9, 9};
  EXPECT_EQ(first, hash({unknown, Class(1, "a"), repainted}));
}

TEST(LabelVocabularyTest, RefusesWhatIsNoVocabulary) {
  const LabelClass unknown = Class(0, "unknown");
  EXPECT_EQ(ErrorOfClasses({}), "labels: id 0 is missing or is not called 'unknown'");
  EXPECT_EQ(ErrorOfClasses({Class(1, "unknown")}),
            "labels: id 0 is missing or is not called 'unknown'");
  EXPECT_EQ(ErrorOfClasses({Class(0, "wall")}),
            "labels: id 0 is missing or is not called 'unknown'");
  EXPECT_EQ(ErrorOfClasses({unknown, Class(3, "")}), "labels: id 3 has no name");
  EXPECT_EQ(ErrorOfClasses({unknown, Class(255, "wall")}),
            "labels: id 255 is reserved, but 'wall' has it");
  EXPECT_EQ(ErrorOfClasses({unknown, Class(1, "a"), Class(1, "b")}),
            "labels: 'a' and 'b' have the same id or name");
  EXPECT_EQ(ErrorOfClasses({unknown, Class(1, "a"), Class(2, "a")}),
            "labels: 'a' and 'a' have the same id or name");
  LabelClass costly = Class(1, "a");
  costly.cost = 255;
  EXPECT_EQ(ErrorOfClasses({unknown, costly}),
            "labels: cost of 'a' = 255, but must be in [0, 254]");
}

TEST(LabelVocabularyTest, NamesFileLineAndKey) {
  ExpectOneLineWith(ErrorOf("labels:\n  - {id: 0, name: unknown, colour: [0, 0, 0], price: 3}\n"),
                    {"labels.yaml:2: unknown key labels/price"});
  ExpectOneLineWith(ErrorOf("labels:\n  - {id: 0, name: unknown}\n"),
                    {"labels.yaml: missing key labels/colour"});
  ExpectOneLineWith(ErrorOf("labels:\n  - {id: 300, name: x, colour: [0, 0, 0]}\n"),
                    {"labels.yaml: labels/id = 300, but must be in [0, 254]"});
  ExpectOneLineWith(ErrorOf("labels:\n  - {id: 0, name: unknown, colour: [0, 0]}\n"),
                    {"labels.yaml: label 'unknown'", "2 numbers, expected 3"});
  ExpectOneLineWith(ErrorOf("labels:\n  - {id: 0, name: unknown, colour: [0, 0, 256]}\n"),
                    {"label 'unknown': colour = 256, but must be in [0, 255]"});
  ExpectOneLineWith(ErrorOf("labels: {id: 0}\n"), {"labels.yaml: labels is not a list"});
  ExpectOneLineWith(ErrorOf("labels: [3]\n"), {"labels.yaml: labels: an entry is not a mapping"});
  ExpectOneLineWith(ErrorOf("labels: []\n"), {"labels.yaml: labels: id 0 is missing"});
}

TEST(LabelVocabularyTest, ReadsTheProjectsOwn) {
  const LabelVocabulary vocabulary =
      LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  EXPECT_EQ(vocabulary.Find("floor"), LabelId{2});
  EXPECT_EQ(vocabulary.Find("bag"), LabelId{37}) << "the last of SUN RGB-D's classes";
  EXPECT_EQ(vocabulary[2].cost, 0);
  EXPECT_TRUE(vocabulary[7].hollow);
}

}  // namespace
}  // namespace semantic_slam
