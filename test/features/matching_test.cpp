#include "semantic_slam/features/matching.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

std::vector<int> All(const FrameFeatures& frame) {
  std::vector<int> all(frame.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void ExpectOneToOneAndAscending(const std::vector<FeatureMatch>& matches) {
  std::set<int> seen_b;
  int last_a = -1;
  for (const FeatureMatch& match : matches) {
    EXPECT_GT(match.a, last_a);
    last_a = match.a;
    EXPECT_TRUE(seen_b.insert(match.b).second) << match.b;
  }
}

TEST(RotationConsistencyTest, TheMajorityIsRight) {
  RotationConsistency rotation;
  for (int i = 0; i < 30; ++i) {
    const float angle = 0.2f * static_cast<float>(i);
    rotation.Add(angle + 1.0f, angle);
  }
  for (const float wrong : {2.0f, 3.0f, 4.0f}) rotation.Add(wrong, 0.0f);
  const std::vector<bool> consistent = rotation.Consistent();
  ASSERT_EQ(consistent.size(), 33u);
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(consistent[i]) << i;
  // A single vote is less than a tenth of the fullest bin's: no majority of its own.
  for (int i = 30; i < 33; ++i) EXPECT_FALSE(consistent[i]) << i;
}

TEST(RotationConsistencyTest, AFullTurnIsNoTurn) {
  RotationConsistency rotation;
  rotation.Add(0.05f, 6.25f);  // +0.08 rad across the seam
  rotation.Add(6.25f, 0.05f);  // -0.08 rad: the same bin of 0.21 rad
  for (int i = 0; i < 20; ++i) rotation.Add(1.0f, 1.0f);
  for (const bool consistent : rotation.Consistent()) EXPECT_TRUE(consistent);
}

TEST(RotationConsistencyTest, ThreeBinsCountBecauseAMajoritySpreads) {
  RotationConsistency rotation;
  for (int i = 0; i < 10; ++i) {
    rotation.Add(0.5f, 0.0f);
    rotation.Add(0.7f, 0.0f);
    rotation.Add(0.9f, 0.0f);
  }
  for (int i = 0; i < 5; ++i) rotation.Add(3.0f, 0.0f);
  const std::vector<bool> consistent = rotation.Consistent();
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(consistent[i]) << i;
  for (int i = 30; i < 35; ++i) EXPECT_FALSE(consistent[i]) << i;
}

TEST(RotationConsistencyTest, NothingAddedIsNothingJudged) {
  EXPECT_TRUE(RotationConsistency().Consistent().empty());
}

TEST(MatchDescriptorsTest, AnImageMatchesItself) {
  const auto frame = SquaresFeatures(1);
  const auto matches = MatchDescriptors(*frame, All(*frame), *frame, {});
  ExpectOneToOneAndAscending(matches);
  EXPECT_GT(matches.size(), 0.9 * frame->size());  // a few look like their own next octave
  for (const FeatureMatch& match : matches) {
    EXPECT_EQ(match.a, match.b);
    EXPECT_EQ(match.distance, 0);
  }
}

TEST(MatchDescriptorsTest, ATurnedImageMatchesWhereverItsFeaturesLie) {
  RgbdImage image = SquaresImage(1);
  const FrameFeatures upright(image, *SmallCamera(), SmallExtractor());
  cv::rotate(image.colour, image.colour, cv::ROTATE_180);
  const FrameFeatures turned(image, *SmallCamera(), SmallExtractor());
  const auto matches = MatchDescriptors(upright, All(upright), turned, {});
  ExpectOneToOneAndAscending(matches);
  EXPECT_GT(matches.size(), 0.5 * upright.size());
  int right = 0;
  for (const FeatureMatch& match : matches) {
    const Eigen::Vector2f expected = Eigen::Vector2f(319.0f, 239.0f) - upright[match.a].raw;
    // Coarse levels are resampled: three pixels of the coarsest.
    right += (turned[match.b].raw - expected).norm() < 10.0f;
  }
  EXPECT_GT(right, 0.95 * matches.size());
}

TEST(MatchDescriptorsTest, OfTwoThatWantAFeatureTheMoreSimilarOneGetsIt) {
  const auto a = SquaresFeatures(1), b = SquaresFeatures(2);  // alike only by chance
  DescriptorMatchingOptions anything;
  anything.max_distance = kMaxDescriptorDistance;
  anything.max_ratio = 1.0;
  anything.check_rotation = false;
  const auto matches = MatchDescriptors(*a, All(*a), *b, anything);
  EXPECT_LT(matches.size(), a->size());  // so some did not get what they wanted
  std::vector<int> least_distance(b->size(), kMaxDescriptorDistance);
  for (const Descriptor& descriptor : a->descriptors()) {
    std::size_t wanted = 0;
    for (std::size_t j = 1; j < b->size(); ++j) {
      if (HammingDistance(descriptor, b->descriptor(j)) <
          HammingDistance(descriptor, b->descriptor(wanted))) {
        wanted = j;
      }
    }
    least_distance[wanted] =
        std::min(least_distance[wanted], HammingDistance(descriptor, b->descriptor(wanted)));
  }
  for (const FeatureMatch& match : matches) EXPECT_EQ(match.distance, least_distance[match.b]);
}

TEST(MatchDescriptorsTest, OnlyCandidatesTakePart) {
  const auto frame = SquaresFeatures(1);
  const auto matches = MatchDescriptors(*frame, {30, 10, 20}, *frame, {});
  ExpectOneToOneAndAscending(matches);
  for (const FeatureMatch& match : matches) EXPECT_EQ(match.a % 10, 0);
  EXPECT_LE(matches.size(), 3u);
  EXPECT_GE(matches.size(), 1u);
  EXPECT_TRUE(MatchDescriptors(*frame, {}, *frame, {}).empty());
}

TEST(MatchDescriptorsTest, DifferentImagesDoNotMatch) {
  const auto a = SquaresFeatures(1), b = SquaresFeatures(2);
  EXPECT_LT(MatchDescriptors(*a, All(*a), *b, {}).size(), 0.03 * a->size());
}

TEST(MatchDescriptorsTest, AnImageWithoutFeaturesMatchesNothing) {
  const auto frame = SquaresFeatures(1);
  const FrameFeatures blank(BlankImage(Stamp{1}), *SmallCamera(), SmallExtractor());
  EXPECT_TRUE(MatchDescriptors(*frame, All(*frame), blank, {}).empty());
  EXPECT_TRUE(MatchDescriptors(blank, {}, *frame, {}).empty());
}

TEST(MatchDescriptorsTest, EveryOptionMakesItStricter) {
  RgbdImage image = SquaresImage(1);
  const FrameFeatures a(image, *SmallCamera(), SmallExtractor());
  cv::Mat noise(image.colour.size(), CV_8UC3);
  cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 40);
  image.colour = image.colour * 0.8 + noise;
  const FrameFeatures b(image, *SmallCamera(), SmallExtractor());
  DescriptorMatchingOptions loose;
  loose.max_distance = 80;
  loose.max_ratio = 1.0;
  loose.check_rotation = false;
  const auto matched = [&](const DescriptorMatchingOptions& options) {
    return MatchDescriptors(a, All(a), b, options);
  };
  const std::size_t all = matched(loose).size();
  auto near = loose, distinct = loose, turned = loose;
  near.max_distance = 20;
  distinct.max_ratio = 0.5;
  turned.check_rotation = true;
  EXPECT_LT(matched(near).size(), all);
  for (const FeatureMatch& match : matched(near)) EXPECT_LE(match.distance, 20);
  EXPECT_LT(matched(distinct).size(), all);
  EXPECT_LT(matched(turned).size(), all);
}

}  // namespace
}  // namespace semantic_slam
