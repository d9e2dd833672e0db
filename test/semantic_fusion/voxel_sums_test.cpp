#include "semantic_slam/semantic_fusion/voxel_sums.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

VoxelSums::Sample Sample(const std::array<LabelId, 3>& labels,
                         const std::array<float, 3>& confidences, int rgb = 100, int place = 128) {
  VoxelSums::Sample sample;
  sample.place = Ints4{place, place, place, 0};
  sample.rgb = Ints4{rgb, rgb + 10, rgb + 20, 0};
  sample.labels = labels[0] | labels[1] << 8 | labels[2] << 16;
  for (int i = 0; i < 3; ++i)
    sample.confidences[i + 1] =
        static_cast<int>(std::lround(confidences[i] * CompactLabels::kProbabilityOne));
  return sample;
}

LabelMask AllLabels() {
  return ~LabelMask();
}

VoxelSums::Mean MeanOf(const std::vector<VoxelSums::Sample>& samples,
                       const LabelMask& labels = AllLabels()) {
  VoxelSums sums;
  std::uint64_t points = 0;
  for (const auto& sample : samples) points += static_cast<std::uint64_t>(sample.points);
  sums.Reset(labels, points);
  sums.AddVoxel();
  VoxelSums::Adder adder(sums);
  for (const auto& sample : samples) adder.Add(0, sample);
  adder.Finish();
  return sums.MeanOf(0);
}

TEST(VoxelSumsTest, EachPointCountsByItsConfidence) {
  const VoxelSums::Mean mean =
      MeanOf({Sample({4, 0, 0}, {0.9f, 0, 0}, 40), Sample({5, 4, 0}, {0.4f, 0.3f, 0}, 10),
              Sample({5, 0, 0}, {0.4f, 0, 0}, 10)});
  const LabelDistribution labels = mean.labels.Unpacked();
  // Two of three points would have voted for 5.
  EXPECT_EQ(labels.labels, (std::array<LabelId, 3>{4, 5, 0}));
  EXPECT_NEAR(labels.probabilities[0], 0.4f, 1e-4f);  // steps of 1/16383
  EXPECT_NEAR(labels.probabilities[1], 0.8f / 3, 1e-4f);
  EXPECT_EQ(mean.rgb, (std::array<std::uint8_t, 3>{20, 30, 40}));
  EXPECT_EQ(mean.points, 3);
}

TEST(VoxelSumsTest, WhatDoesNotCountBelongsToTheOthers) {
  LabelMask labels = AllLabels();
  labels.reset(31);
  const VoxelSums::Mean mean =
      MeanOf({Sample({31, 4, 0}, {0.5f, 0.3f, 0}), Sample({0, 4, 31}, {0.4f, 0.3f, 0.1f})}, labels);
  const LabelDistribution found = mean.labels.Unpacked();
  EXPECT_EQ(found.labels, (std::array<LabelId, 3>{4, 0, 0}));
  EXPECT_NEAR(found.others(), 0.7f, 1e-4f);  // steps of 1/16383
}

TEST(VoxelSumsTest, DoesNotDependOnTheOrder) {
  std::mt19937 random(3);
  std::vector<VoxelSums::Sample> samples;
  for (int i = 0; i < 300; ++i) {
    const float p = 0.3f + 0.0005f * static_cast<float>(i);
    samples.push_back(
        Sample({static_cast<LabelId>(1 + i % 9), static_cast<LabelId>(20 + i % 11), 40},
               {p, (1 - p) / 2, (1 - p) / 3}, i % 230, i % 256));
    samples.back().points = 1 + i % 2000;  // so many that sums are kept halved
  }
  const VoxelSums::Mean first = MeanOf(samples);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(samples.begin(), samples.end(), random);
    const VoxelSums::Mean again = MeanOf(samples);
    EXPECT_TRUE(again.labels == first.labels);
    EXPECT_EQ(again.rgb, first.rgb);
    EXPECT_EQ(again.place, first.place);
  }
}

TEST(VoxelSumsTest, ManyPointsDoNotOverflow) {
  // 640 x 480 px, all in one voxel and all sure.
  std::vector<VoxelSums::Sample> samples(307200, Sample({4, 0, 0}, {1.0f, 0, 0}, 200, 200));
  const VoxelSums::Mean mean = MeanOf(samples);
  EXPECT_NEAR(mean.labels.Unpacked().probabilities[0], 1.0f, 2e-4f);  // steps of 1/8192 then
  EXPECT_EQ(mean.rgb[0], 200);
  EXPECT_EQ(mean.points, 65535);
  EXPECT_FLOAT_EQ(mean.place[0], 200.0f / 256.0f);
}

TEST(VoxelSumsTest, TheMeanStaysAwayFromTheFaces) {
  EXPECT_FLOAT_EQ(MeanOf({Sample({4, 0, 0}, {1, 0, 0}, 0, 0)}).place[1], 1.0f / 16.0f);
  EXPECT_FLOAT_EQ(MeanOf({Sample({4, 0, 0}, {1, 0, 0}, 0, 255)}).place[1], 15.0f / 16.0f);
}

TEST(VoxelSumsTest, KeepsVoxelsApart) {
  VoxelSums sums;
  sums.Reset(AllLabels(), 10);
  for (int i = 0; i < 3; ++i) sums.AddVoxel();
  VoxelSums::Adder adder(sums);
  adder.Add(2, Sample({4, 0, 0}, {0.5f, 0, 0}));
  adder.Add(0, Sample({5, 0, 0}, {0.5f, 0, 0}));
  adder.Add(2, Sample({4, 0, 0}, {0.7f, 0, 0}));
  adder.Finish();
  EXPECT_EQ(sums.MeanOf(0).labels.label(0), 5);
  EXPECT_TRUE(sums.IsEmpty(1));
  EXPECT_EQ(sums.MeanOf(2).points, 2);
  EXPECT_NEAR(sums.MeanOf(2).labels.Unpacked().probabilities[0], 0.6f, 1e-4f);
}

}  // namespace
}  // namespace semantic_slam
