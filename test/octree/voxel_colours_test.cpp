#include "semantic_slam/octree/voxel_colours.h"

#include <gtest/gtest.h>

#include "octree/octree_testing.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

const LabelVocabulary kVocabulary({{0, "unknown", {9, 9, 9}}, {5, "chair", {200, 10, 10}}});

TEST(VoxelColoursTest, ShowsTheClassTheColourOrTheHeight) {
  SemanticNode node;
  node.SetRgb({1, 2, 3});
  node.SetLabels(CompactLabels(Distribution(5, 0.8f)));
  EXPECT_EQ(VoxelColours(ColourMode::kClass, kVocabulary)(node, 0.0), (Rgb{200, 10, 10}));
  EXPECT_EQ(VoxelColours(ColourMode::kRgb, kVocabulary)(node, 0.0), (Rgb{1, 2, 3}));
  const VoxelColours height(ColourMode::kHeight, kVocabulary, 1.0, 3.0);
  EXPECT_EQ(height(node, 0.0), (Rgb{0, 0, 255}));
  EXPECT_EQ(height(node, 2.0), (Rgb{0, 255, 0}));
  EXPECT_EQ(height(node, 9.0), (Rgb{255, 0, 0}));
}

TEST(VoxelColoursTest, WhatHasNoClassLooksUnknown) {
  SemanticNode node;
  const VoxelColours colours(ColourMode::kClass, kVocabulary);
  EXPECT_EQ(colours(node, 0.0), (Rgb{9, 9, 9}));
  node.SetLabels(CompactLabels(Distribution(77, 0.8f)));
  EXPECT_EQ(colours(node, 0.0), (Rgb{9, 9, 9}));
}

TEST(VoxelColoursTest, KnowsItsModesByName) {
  EXPECT_EQ(ColourModeFromName("height"), ColourMode::kHeight);
  EXPECT_EQ(MessageOf<ConfigError>([] { ColourModeFromName("depth"); }),
            "colour_mode = depth, but must be one of: class, rgb, height");
}

}  // namespace
}  // namespace semantic_slam
