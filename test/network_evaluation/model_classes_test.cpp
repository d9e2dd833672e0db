#include "semantic_slam/network_evaluation/model_classes.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

TEST(ModelClassesTest, WithoutAFileTheNetworksLabelsCount) {
  // Its classes map to wall, chair, plant and tv.
  const ClassList classes = ClassesOfModel(ColourSegmenter(), Vocabulary());
  EXPECT_EQ(classes.names, (std::vector<std::string>{"wall", "chair", "tv", "plant"}));
  EXPECT_EQ(classes.of_label[kUnknownLabel], kIgnoredClass);
}

TEST(ModelClassesTest, RefusesANetworkWithoutLabels) {
  Model model = ColourSegmenter();
  model.card.label_map.clear();
  model.classes = {"x", "y"};
  const std::string message = MessageOf<ConfigError>([&] { ClassesOfModel(model, Vocabulary()); });
  ExpectOneLineWith(message, {"colour_segmenter.yaml", "none of its classes"});
}

TEST(ModelClassesTest, NamesAreUnderstoodAsTheCardSaysThenByThemselves) {
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
