#include "semantic_slam/worlds/material.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(MaterialTest, EqualOnlyIfEveryPropertyIs) {
  const Material material;
  EXPECT_TRUE(material == Material());
  Material other = material;
  other.pattern = "brick";
  EXPECT_FALSE(material == other);
  other = material;
  other.rgb[2] = 1;
  EXPECT_FALSE(material == other);
  other = material;
  other.seed = 2;
  EXPECT_FALSE(material == other);
  other = material;
  other.picture_size_m = {1, 1};
  EXPECT_FALSE(material == other);
  other = material;
  other.gloss = 0.5f;
  EXPECT_FALSE(material == other);
  other = material;
  other.brightness = 0.5f;
  EXPECT_FALSE(material == other);
}

}  // namespace
}  // namespace semantic_slam
