#include "semantic_slam/network_evaluation/class_list.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

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
  ExpectOneLineWith(ErrorOf("classes: [wall]\nclases: [floor]"), {"clases"});
}

// Every list that training has can be read, and each of its classes counts as itself.
TEST(ClassListTest, ReadsTheListsOfTraining) {
  for (const std::string name : {"indoor", "furniture", "sun_rgbd", "appearance"}) {
    const ClassList classes =
        ReadClassList(SEMANTIC_SLAM_SOURCE_DIR "/training/classes/" + name + ".yaml", Vocabulary());
    for (std::size_t c = 0; c < classes.size(); ++c) {
      EXPECT_EQ(classes.of_label[LabelOf(classes.names[c])], static_cast<int>(c)) << name;
    }
  }
}

TEST(ClassListTest, WithoutAFileTheNetworksLabelsCount) {
  // Its classes map to wall, chair, plant and tv.
  const ClassList classes = ClassesOfModel(ColourSegmenter(), Vocabulary());
  EXPECT_EQ(classes.names, (std::vector<std::string>{"wall", "chair", "tv", "plant"}));
  EXPECT_EQ(classes.of_label[kUnknownLabel], kIgnoredClass);
}

TEST(ClassListTest, RefusesANetworkWithoutLabels) {
  Model model = ColourSegmenter();
  model.card.label_map.clear();
  model.classes = {"x", "y"};
  const std::string message = MessageOf<ConfigError>([&] { ClassesOfModel(model, Vocabulary()); });
  ExpectOneLineWith(message, {"colour_segmenter.yaml", "none of its classes"});
}

TEST(ClassListTest, NamesAreUnderstoodAsTheCardSaysThenByThemselves) {
  ModelCard card;
  card.label_map = {{"couch", "sofa"}, {"kite", "unknown"}};
  EXPECT_EQ(LabelOfName("couch", card, Vocabulary()), LabelOf("sofa"));
  EXPECT_EQ(LabelOfName("kite", card, Vocabulary()), kUnknownLabel);
  EXPECT_EQ(LabelOfName("chair", card, Vocabulary()), LabelOf("chair"));
  EXPECT_EQ(LabelOfName(" Coffee Table", card, Vocabulary()), LabelOf("coffee_table"));
  EXPECT_EQ(LabelOfName("coffee-table", card, Vocabulary()), LabelOf("coffee_table"));
  EXPECT_EQ(LabelOfName("spaceship", card, Vocabulary()), kUnknownLabel);
  EXPECT_EQ(LabelOfName(" ", card, Vocabulary()), kUnknownLabel);
}

}  // namespace
}  // namespace semantic_slam
