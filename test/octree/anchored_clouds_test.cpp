#include "semantic_slam/octree/anchored_clouds.h"

#include <gtest/gtest.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

constexpr std::size_t kMegabyte = 1 << 20;

void AddTo(AnchoredClouds& clouds, int index, std::size_t points = 100) {
  CloudAnchor anchor;
  anchor.stamp.ns = index;
  anchor.keyframe_id = index / 10;
  const auto z = static_cast<float>(index + 1);
  clouds.Add(anchor, std::vector<VoxelObservation>(points, Observation({0, 0, z}, 5, 0.5f)));
}

AnchoredClouds::Limits InMemory(std::size_t bytes) {
  return {0, bytes, ""};
}

AnchoredClouds::Limits OnDisk(std::size_t bytes, const std::string& folder = testing::TempDir()) {
  return {bytes, kMegabyte, folder};
}

// Of 100 points.
std::size_t BytesOfOne() {
  AnchoredClouds clouds(InMemory(kMegabyte));
  AddTo(clouds, 0);
  return clouds.memory_bytes();
}

void ExpectIntact(const AnchoredClouds& clouds, std::int64_t step) {
  for (std::size_t i = 0; i < clouds.clouds().size(); ++i) {
    const AnchoredCloud& cloud = *clouds.clouds()[i];
    EXPECT_EQ(cloud.anchor().stamp.ns, static_cast<std::int64_t>(i) * step);
    const auto observations = cloud.Load();
    ASSERT_EQ(observations.size(), 100u);
    EXPECT_NEAR(observations[99].position.z(), static_cast<float>(i) * step + 1.0f, 1e-3f);
  }
}

TEST(AnchoredCloudsTest, KeepsAllWithinTheLimits) {
  for (const auto& limits : {InMemory(kMegabyte), OnDisk(kMegabyte)}) {
    AnchoredClouds clouds(limits);
    for (int i = 0; i < 100; ++i) AddTo(clouds, i);
    EXPECT_EQ(clouds.clouds().size(), 100u);
    EXPECT_EQ(clouds.keeps_one_of(), 1u);
    EXPECT_EQ(clouds.memory_bytes() + clouds.disk_bytes(), 100 * BytesOfOne());
    EXPECT_EQ(clouds.clouds()[0]->is_on_disk(), limits.disk_bytes > 0);
    ExpectIntact(clouds, 1);
  }
}

TEST(AnchoredCloudsTest, ThinsEvenlyPastTheLimits) {
  for (const bool on_disk : {false, true}) {
    const std::size_t limit = 50 * BytesOfOne();
    AnchoredClouds clouds(on_disk ? OnDisk(limit) : InMemory(limit));
    for (int i = 0; i < 1000; ++i) {
      AddTo(clouds, i);
      EXPECT_LE(clouds.memory_bytes() + clouds.disk_bytes(), limit);
    }
    EXPECT_EQ(clouds.disk_error(), "");
    EXPECT_EQ(clouds.keeps_one_of(), 32u);
    EXPECT_GE(clouds.clouds().size(), 25u);
    ExpectIntact(clouds, 32);
  }
}

TEST(AnchoredCloudsTest, ACloudBeyondTheLimitIsNotKept) {
  AnchoredClouds clouds(InMemory(1000));
  AddTo(clouds, 0, 10000);
  EXPECT_TRUE(clouds.clouds().empty());
  EXPECT_EQ(clouds.memory_bytes(), 0u);
}

TEST(AnchoredCloudsTest, WithoutADiskCloudsStayInMemory) {
  AnchoredClouds clouds(OnDisk(kMegabyte, "/no/such/folder"));
  for (int i = 0; i < 5; ++i) AddTo(clouds, i);
  EXPECT_NE(clouds.disk_error().find("/no/such/folder"), std::string::npos);
  EXPECT_EQ(clouds.disk_bytes(), 0u);
  ExpectIntact(clouds, 1);
}

TEST(AnchoredCloudsTest, WhoHoldsACloudCanReadItAfterItIsGone) {
  AnchoredClouds clouds(OnDisk(kMegabyte));
  AddTo(clouds, 4);
  const auto held = clouds.clouds()[0];
  clouds.Clear();
  AddTo(clouds, 7);
  EXPECT_NEAR(held->Load()[0].position.z(), 5.0f, 1e-3f);
}

TEST(AnchoredCloudsTest, RemovesAndForgets) {
  AnchoredClouds clouds(InMemory(kMegabyte));
  for (int i = 0; i < 30; ++i) AddTo(clouds, i);
  const std::size_t bytes = clouds.memory_bytes();
  EXPECT_EQ(
      clouds.RemoveIf([](const AnchoredCloud& cloud) { return cloud.anchor().keyframe_id == 1; }),
      10u);
  EXPECT_EQ(clouds.clouds().size(), 20u);
  EXPECT_EQ(clouds.memory_bytes(), bytes / 3 * 2);
  clouds.Clear();
  EXPECT_EQ(clouds.memory_bytes(), 0u);
  EXPECT_TRUE(clouds.clouds().empty());
}

}  // namespace
}  // namespace semantic_slam
