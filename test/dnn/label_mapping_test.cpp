#include "semantic_slam/dnn/label_mapping.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

Model ModelOf(const std::vector<std::string>& classes,
              const std::map<std::string, std::string>& map) {
  Model model;
  model.card.path = "card.yaml";
  model.card.labels_file = "a.names";
  model.card.label_map = map;
  model.classes = classes;
  return model;
}

TEST(LabelMappingTest, MapsByTheCardElseByNameElseToUnknown) {
  const Model model = ModelOf({"couch", "tv", "kite", "armchair", "chair"},
                              {{"couch", "sofa"}, {"armchair", "chair"}});
  EXPECT_EQ(MapClassesToLabels(model, Vocabulary()),
            (std::vector<LabelId>{LabelOf("sofa"), LabelOf("tv"), kUnknownLabel, LabelOf("chair"),
                                  LabelOf("chair")}));
}

TEST(LabelMappingTest, TheCardHasTheLastWord) {
  const Model model = ModelOf({"tv"}, {{"tv", "unknown"}});
  EXPECT_EQ(MapClassesToLabels(model, Vocabulary()), std::vector<LabelId>{kUnknownLabel});
}

TEST(LabelMappingTest, RefusesNamesThatNobodyKnows) {
  EXPECT_EQ(MessageOf<ConfigError>([] {
              MapClassesToLabels(ModelOf({"couch"}, {{"couch", "settee"}}), Vocabulary());
            }),
            "card.yaml: labels/map: 'couch: settee': no label of that name is in the vocabulary");
  EXPECT_EQ(MessageOf<ConfigError>([] {
              MapClassesToLabels(ModelOf({"couch"}, {{"coach", "sofa"}}), Vocabulary());
            }),
            "card.yaml: labels/map: 'coach: sofa': no class of that name is in a.names");
}

}  // namespace
}  // namespace semantic_slam
