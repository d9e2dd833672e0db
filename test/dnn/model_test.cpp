#include "semantic_slam/dnn/model.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dnn/label_mapping.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"
#include "testing/tiny_networks.h"

namespace semantic_slam {
namespace {

constexpr char kCard[] =
    "file: net.cfg\n"
    "input: {width: 1, height: 1, colour: rgb, scale: 1, fit: stretch}\n"
    "head: {type: yolo}\n"
    "labels: {file: net.names}\n";
constexpr char kDigestOfAbc[] = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

std::vector<std::string> ProjectCards() {
  std::vector<std::string> cards;
  for (const auto& entry :
       std::filesystem::directory_iterator(SEMANTIC_SLAM_SOURCE_DIR "/config/cards")) {
    if (entry.path().extension() == ".yaml") cards.push_back(entry.path().string());
  }
  return cards;
}

TEST(LoadModelTest, FindsTheFilesBesideTheCard) {
  const TemporaryFolder folder;
  const std::string card =
      folder.Write("net.yaml", std::string("sha256: ") + kDigestOfAbc + "\n" + kCard);
  folder.Write("net.cfg", "[net]");
  folder.Write("net.weights", "abc");
  folder.Write("net.names", "one\ntwo\n");
  const Model model = LoadModel(card);
  EXPECT_EQ(model.network_path, folder / "net.cfg");
  EXPECT_EQ(model.weights_path, folder / "net.weights");
  EXPECT_EQ(model.classes, (std::vector<std::string>{"one", "two"}));
}

TEST(LoadModelTest, PrefersTheModelsFolder) {
  const TemporaryFolder folder;
  const std::string card = folder.Write("cards/net.yaml", kCard);
  for (const char* name : {"net.cfg", "net.weights", "net.names"}) {
    folder.Write(std::string("cards/") + name, "a");
    folder.Write(std::string("models/") + name, "b");
  }
  EXPECT_EQ(LoadModel(card, folder / "models").network_path, folder / "models/net.cfg");
  EXPECT_EQ(LoadModel(card, folder / "models").classes[0], "b");
  EXPECT_EQ(LoadModel(card).classes[0], "a");
}

TEST(LoadModelTest, RefusesOtherWeightsThanTheCards) {
  const TemporaryFolder folder;
  const std::string card =
      folder.Write("net.yaml", std::string("sha256: ") + kDigestOfAbc + "\n" + kCard);
  folder.Write("net.cfg", "abc");
  folder.Write("net.weights", "abcd");
  folder.Write("net.names", "one\n");
  ExpectOneLineWith(MessageOf<ConfigError>([&] { LoadModel(card); }),
                    {"net.yaml", "net.weights", "sha256 is ", "expected ", kDigestOfAbc});
}

TEST(LoadModelTest, NamesAMissingFileAndWhereItLooked) {
  const TemporaryFolder folder;
  const std::string card = folder.Write("net.yaml", kCard);
  folder.Write("net.cfg", "");
  ExpectOneLineWith(MessageOf<ConfigError>([&] { LoadModel(card, "/mine"); }),
                    {"net.yaml", "net.weights is in none of: /mine, ", folder.path().c_str()});
}

TEST(ProjectCardsTest, AllCanBeReadAndMapToTheVocabulary) {
  const std::vector<std::string> cards = ProjectCards();
  EXPECT_GE(cards.size(), 4u);
  for (const std::string& path : cards) {
    const ModelCard card = ReadModelCard(path);
    EXPECT_FALSE(card.licence.empty()) << path;
    EXPECT_FALSE(card.sha256.empty()) << path;
    for (const auto& [class_name, label_name] : card.label_map) {
      EXPECT_TRUE(Vocabulary().Find(label_name)) << path << ": " << class_name;
    }
  }
}

TEST(ProjectCardsTest, NameEveryClassOfTheirFiles) {
  SEMANTIC_SLAM_SKIP_WITHOUT(SharedData("models"), "the models folder");
  for (const std::string& path : ProjectCards()) {
    const Model model = LoadModel(path, *SharedData("models"));
    EXPECT_EQ(MapClassesToLabels(model, Vocabulary()).size(), model.classes.size());
    for (const std::string& name : model.classes) {
      EXPECT_EQ(model.card.label_map.count(name), 1u) << path << ": " << name;
    }
  }
}

}  // namespace
}  // namespace semantic_slam
