#include "semantic_slam/worlds/material_file.h"

#include <gtest/gtest.h>

#include "testing/world_text.h"

namespace semantic_slam {
namespace {

class MaterialFileTest : public testing::Test {
 protected:
  // What `key: value` means where the usual material is grey wood, seed 4.
  Material Read(const std::string& value) {
    YamlReader file(YAML::Load("materials: {oak: {pattern: wood, rgb: [9, 8, 7], gloss: 0.5}}"),
                    "w.yaml");
    const MaterialPalette palette(file);
    YamlReader reader(YAML::Load("{top: " + value + "}"), "w.yaml");
    Material usual = MakeMaterial("wood", {100, 100, 100}, 0.2f);
    usual.seed = 4;
    return palette.Read(reader, value.empty() ? "legs" : "top", usual);
  }
  std::string ErrorOf(const std::string& value) {
    return MessageOf<ConfigError>([&] { Read(value); });
  }
};

TEST_F(MaterialFileTest, AbsentMeansTheUsual) {
  EXPECT_EQ(Read("").seed, 4u);
}

TEST_F(MaterialFileTest, ANameMeansOneOfThePalette) {
  const Material oak = Read("oak");
  EXPECT_EQ(oak.rgb, (std::array<std::uint8_t, 3>{9, 8, 7}));
  EXPECT_EQ(oak.gloss, 0.5f);
}

TEST_F(MaterialFileTest, AColourMeansTheUsualInThatColour) {
  const Material coloured = Read("[1, 2, 3]");
  EXPECT_EQ(coloured.rgb, (std::array<std::uint8_t, 3>{1, 2, 3}));
  EXPECT_EQ(coloured.pattern, "wood");
  EXPECT_EQ(coloured.seed, 4u);
}

TEST_F(MaterialFileTest, AMappingSaysWhatDiffers) {
  const Material material = Read("{pattern: brick, seed: 7, brightness: 0.5}");
  EXPECT_EQ(material.pattern, "brick");
  EXPECT_EQ(material.seed, 7u);
  EXPECT_EQ(material.brightness, 0.5f);
  EXPECT_EQ(material.gloss, 0.2f);
}

TEST_F(MaterialFileTest, RefusesByFileLineAndKey) {
  EXPECT_EQ(ErrorOf("elm"),
            "w.yaml:1: top = elm, but must be [r, g, b], a mapping or one of materials: oak");
  EXPECT_EQ(ErrorOf("[1, 2, 300]"),
            "w.yaml:1: top = [1, 2, 300], but must be three numbers from 0 to 255");
  EXPECT_EQ(ErrorOf("{gloss: 3}"), "w.yaml:1: top/gloss = 3, but must be in [0, 1]");
  ExpectOneLineWith(ErrorOf("{pattern: fur}"),
                    {"w.yaml:1: top/pattern = fur, but must be one of: banded_curtain, books, brick,"});
  ExpectOneLineWith(ErrorOf("{colour: [1, 2, 3]}"), {"w.yaml:1: unknown key top/colour"});
  EXPECT_EQ(WorldText().ErrorOf("materials: [1]\n"),
            "w.yaml:1: materials = [1], but must be a mapping");
}

}  // namespace
}  // namespace semantic_slam
