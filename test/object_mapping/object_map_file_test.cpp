#include "semantic_slam/object_mapping/object_map_file.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

LabelVocabulary Vocabulary() {
  LabelClass unknown, table, desk;
  unknown.name = "unknown";
  table.id = 7;
  table.name = "table";
  desk.id = 14;
  desk.name = "desk";
  return LabelVocabulary({unknown, table, desk});
}

ObjectMap OneTable() {
  MapObject table;
  table.id = 12;
  table.labels = {{7, 0.75f}, {14, 0.25f}};
  table.position_m = {1.0, 2.0, 0.74};
  table.position_covariance_m2 = 0.01 * Eigen::Matrix3d::Identity();
  table.T_map_box = Eigen::Translation3d(1.0, 2.0, 0.4) *
                    Rigid3d(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  table.box_size_m = {1.2, 0.8, 0.75};
  table.max_height_m = 0.75;
  table.hollow = Hollowness::kFull;
  table.footprint_m = {{0, 0}, {1.2, 0}, {1.2, 0.8}, {0, 0.8}};
  table.observations = 9;
  table.last_seen = Stamp{1'500'000'000};
  return {Stamp{2'000'000'000}, 1, 42, Vocabulary().hash(), {table}};
}

TEST(ObjectMapFileTest, HoldsEverything) {
  const TemporaryFolder folder;
  WriteObjectMap(folder / "new/objects.json", OneTable(), Vocabulary());
  std::ifstream file(folder / "new/objects.json");
  const auto json = nlohmann::json::parse(file);
  EXPECT_EQ(json["map_id"], 1);
  EXPECT_EQ(json["revision"], 42);
  EXPECT_EQ(json["stamp_s"], "2.000000");
  EXPECT_EQ(json["label_set_hash"], Vocabulary().hash());
  const auto& table = json["objects"].at(0);
  EXPECT_EQ(table["id"], 12);
  EXPECT_EQ(table["class"], "table");
  EXPECT_EQ(table["probabilities"]["desk"], 0.25);
  EXPECT_EQ(table["position_m"], nlohmann::json({1.0, 2.0, 0.74}));
  EXPECT_EQ(table["position_covariance_m2"][1][1], 0.01);
  EXPECT_EQ(table["box"]["yaw_rad"], 0.5);
  EXPECT_EQ(table["box"]["size_m"][0], 1.2);
  EXPECT_EQ(table["hollow"], "full");
  EXPECT_EQ(table["footprint_m"].size(), 4u);
  EXPECT_EQ(table["footprint_m"][1][0], 1.2);
  EXPECT_EQ(table["observations"], 9);
  EXPECT_EQ(table["last_seen_s"], "1.500000");
}

TEST(ObjectMapFileTest, AnEmptyMapIsAFileToo) {
  const TemporaryFolder folder;
  WriteObjectMap(folder / "objects.json", {}, Vocabulary());
  std::ifstream file(folder / "objects.json");
  EXPECT_TRUE(nlohmann::json::parse(file)["objects"].empty());
}

TEST(ObjectMapFileTest, WhatCannotBeWrittenIsNamed) {
  ExpectOneLineWith(MessageOf<InputError>(
                        [] { WriteObjectMap("/proc/no/objects.json", OneTable(), Vocabulary()); }),
                    {"/proc/no/objects.json"});
}

TEST(ObjectMapFileTest, ReadsWhatItWrites) {
  const TemporaryFolder folder;
  WriteObjectMap(folder / "objects.json", OneTable(), Vocabulary());
  const ObjectMap map = ReadObjectMap(folder / "objects.json", Vocabulary());
  EXPECT_EQ(map.stamp, OneTable().stamp);
  EXPECT_EQ(map.map_id, 1);
  EXPECT_EQ(map.revision, 42u);
  EXPECT_EQ(map.vocabulary_hash, Vocabulary().hash());
  ASSERT_EQ(map.objects.size(), 1u);
  const MapObject &read = map.objects[0], table = OneTable().objects[0];
  EXPECT_EQ(read.id, 12);
  ASSERT_EQ(read.labels.size(), 2u);
  EXPECT_EQ(read.labels[1].label, 14);
  EXPECT_EQ(read.labels[1].probability, 0.25f);
  EXPECT_EQ(read.position_m, table.position_m);
  EXPECT_EQ(read.position_covariance_m2, table.position_covariance_m2);
  EXPECT_TRUE(read.T_map_box.isApprox(table.T_map_box, 1e-4));  // the file's digits
  EXPECT_EQ(read.box_size_m, table.box_size_m);
  EXPECT_EQ(read.max_height_m, 0.75);
  EXPECT_EQ(read.hollow, Hollowness::kFull);
  EXPECT_EQ(read.footprint_m, table.footprint_m);
  EXPECT_EQ(read.observations, 9);
  EXPECT_EQ(read.last_seen, table.last_seen);
}

TEST(ObjectMapFileTest, WhatIsNoObjectMapIsNamed) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& path) {
    return MessageOf<InputError>([&] { ReadObjectMap(path, Vocabulary()); });
  };
  ExpectOneLineWith(message(folder / "gone.json"), {"gone.json"});
  ExpectOneLineWith(message(folder.Write("cut.json", "{\"stamp_s\": ")), {"cut.json"});
  ExpectOneLineWith(message(folder.Write("other.json", "{\"stamp_s\": \"1.0\"}")), {"other.json"});
  WriteObjectMap(folder / "objects.json", OneTable(), Vocabulary());
  const LabelVocabulary other({{0, "unknown"}, {7, "desk"}});
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadObjectMap(folder / "objects.json", other); }),
                    {"objects.json", "label set"});
}

}  // namespace
}  // namespace semantic_slam
