#include "semantic_slam/octree/packed_cloud.h"

#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(PackedCloudTest, LosesLittle) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-5.0f, 5.0f);
  std::vector<VoxelObservation> observations(500);
  for (VoxelObservation& observation : observations) {
    observation.position = {coordinate(random), coordinate(random), coordinate(random)};
    observation.rgb = {static_cast<std::uint8_t>(random()), 2, 255};
    observation.labels = CompactLabels({4, 9, 200}, {9000, 4000, 1}, 0);
    observation.points = static_cast<std::uint16_t>(1 + random() % 400);
    observation.is_only_seen = random() % 5 == 0;
  }
  const auto unpacked = Unpack(Pack(observations));
  ASSERT_EQ(unpacked.size(), observations.size());
  for (std::size_t i = 0; i < unpacked.size(); ++i) {
    const VoxelObservation &before = observations[i], &after = unpacked[i];
    // Half a step of 5 m / 32767.
    EXPECT_LT((before.position - after.position).cwiseAbs().maxCoeff(), 8e-5f);
    ASSERT_EQ(after.is_only_seen, before.is_only_seen);
    if (before.is_only_seen) continue;
    EXPECT_EQ(after.rgb, before.rgb);
    EXPECT_EQ(after.points, std::min<int>(before.points, 255));
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(after.labels.label(k), before.labels.label(k));
      // Half a step of 1/255.
      EXPECT_NEAR(after.labels.scaled_probability(k), before.labels.scaled_probability(k), 33);
    }
    EXPECT_TRUE(after.labels.IsValid());
  }
}

TEST(PackedCloudTest, PackingAgainLosesNothingMore) {
  VoxelObservation observation;
  observation.position = {1.0f, -2.0f, 3.0f};
  observation.labels = CompactLabels({4, 9, 0}, {9000, 4000, 0}, 0);
  const auto once = Unpack(Pack({observation})), twice = Unpack(Pack(once));
  EXPECT_EQ(once[0].position, twice[0].position);
  EXPECT_TRUE(once[0].labels == twice[0].labels);
}

TEST(PackedCloudTest, NothingIsNoError) {
  EXPECT_TRUE(Unpack(Pack({})).empty());
  VoxelObservation at_the_camera;
  at_the_camera.position.setZero();
  EXPECT_EQ(Unpack(Pack({at_the_camera}))[0].position, Eigen::Vector3f(0, 0, 0));
}

}  // namespace
}  // namespace semantic_slam
