#include "semantic_slam/common/label_check.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam {
namespace {

TEST(LabelCheckTest, PassesWhatIsOfTheVocabulary) {
  const LabelVocabulary vocabulary = SmallVocabulary();
  EXPECT_NO_THROW(CheckLabelSet("detections", vocabulary.hash(), vocabulary));
  EXPECT_NO_THROW(CheckLabel("detections", 0, vocabulary));
  EXPECT_NO_THROW(CheckLabel("detections", 9, vocabulary));
}

TEST(LabelCheckTest, RefusesAnotherSetNamingBoth) {
  const LabelVocabulary vocabulary = SmallVocabulary();
  EXPECT_EQ(MessageOf<InputError>([&] { CheckLabelSet("detections", 5, vocabulary); }),
            "detections: made with another label set, hash 5, expected " +
                std::to_string(vocabulary.hash()));
}

TEST(LabelCheckTest, RefusesAnIdThatNobodyHas) {
  EXPECT_EQ(MessageOf<InputError>([&] { CheckLabel("objects", 8, SmallVocabulary()); }),
            "objects: label id 8 is not in the vocabulary");
}

TEST(LabelCheckTest, FindsTheLabelsOfAList) {
  const LabelVocabulary vocabulary = SmallVocabulary();
  EXPECT_EQ(FindLabels("hidden", "lamp, wall,,", vocabulary), (std::vector<LabelId>{9, 1}));
  EXPECT_TRUE(FindLabels("hidden", "", vocabulary).empty());
  EXPECT_EQ(MessageOf<ConfigError>([&] { FindLabels("hidden", "wall,unicorn", vocabulary); }),
            "hidden: 'unicorn' is not in the vocabulary");
}

}  // namespace
}  // namespace semantic_slam
