#include "semantic_slam/simulation/similar_labels.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

LabelVocabulary Vocabulary() {
  return LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
}

bool Contains(const std::vector<LabelId>& ids, LabelId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

TEST(SimilarLabelsTest, ATableIsLikeADesk) {
  const LabelVocabulary vocabulary = Vocabulary();
  const SimilarLabels similar(vocabulary);
  const LabelId table = *vocabulary.Find("table"), desk = *vocabulary.Find("desk");
  EXPECT_TRUE(Contains(similar.Of(table), desk));
  EXPECT_FALSE(Contains(similar.Of(table), *vocabulary.Find("person")));
}

TEST(SimilarLabelsTest, IsMutualAndNeverTheLabelItself) {
  const LabelVocabulary vocabulary = Vocabulary();
  const SimilarLabels similar(vocabulary);
  for (const LabelClass& label : vocabulary.classes()) {
    EXPECT_FALSE(Contains(similar.Of(label.id), label.id)) << label.name;
    for (const LabelId other : similar.Of(label.id)) {
      EXPECT_TRUE(Contains(similar.Of(other), label.id)) << label.name;
    }
  }
}

TEST(SimilarLabelsTest, EveryThingAtHomeAndInTheOfficeHasALookAlike) {
  const LabelVocabulary vocabulary = Vocabulary();
  const SimilarLabels similar(vocabulary);
  for (const char* name : {"wall",
                           "floor",
                           "cabinet",
                           "bed",
                           "chair",
                           "sofa",
                           "table",
                           "door",
                           "window",
                           "bookshelf",
                           "picture",
                           "desk",
                           "curtain",
                           "ceiling",
                           "books",
                           "fridge",
                           "tv",
                           "whiteboard",
                           "person",
                           "night_stand",
                           "lamp",
                           "coffee_table",
                           "conference_table",
                           "plant",
                           "laptop",
                           "bottle"}) {
    EXPECT_FALSE(similar.Of(*vocabulary.Find(name)).empty()) << name;
  }
}

TEST(SimilarLabelsTest, NamesThatTheVocabularyLacksAreLeftOut) {
  const LabelVocabulary two(
      {{0, "unknown", {}, false, false, 254}, {1, "table", {}, false, false, 254}});
  const SimilarLabels similar(two);
  EXPECT_TRUE(similar.Of(1).empty());
  EXPECT_TRUE(similar.Of(0).empty());
}

}  // namespace
}  // namespace semantic_slam
