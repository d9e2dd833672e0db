#include "semantic_slam/semantic_fusion/voxel_observation.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

SemanticPoint Point(float x, std::array<LabelId, 3> labels, std::array<float, 3> confidences) {
  return {Eigen::Vector3f(x, 0, 1), {10, 20, 30}, labels, confidences};
}

VoxelObservation Combined(const std::vector<VoxelObservation>& observations) {
  ObservationCombiner combiner;
  for (const VoxelObservation& observation : observations)
    combiner.Add(observation, observation.position.x());
  return combiner.Take();
}

TEST(VoxelObservationTest, APointIsAnObservation) {
  SemanticCloud cloud;
  cloud.points = {Point(1.0f, {4, 0, 6}, {0.5f, 0.3f, 0.1f})};
  const auto observations = ObservationsOf(cloud, {});
  ASSERT_EQ(observations.size(), 1u);
  EXPECT_EQ(observations[0].position, cloud.points[0].position);
  EXPECT_EQ(observations[0].rgb, cloud.points[0].rgb);
  EXPECT_EQ(observations[0].points, 1);
  EXPECT_FALSE(observations[0].is_transient);
  // What is unknown belongs to the others.
  const LabelDistribution labels = observations[0].labels.Unpacked();
  EXPECT_EQ(labels.labels, (std::array<LabelId, 3>{4, 6, 0}));
  EXPECT_NEAR(labels.others(), 0.4f, 1e-4f);  // steps of 1/16383
}

TEST(VoxelObservationTest, TheMostProbableLabelMakesAPointTransient) {
  SemanticCloud cloud;
  cloud.points = {Point(1.0f, {31, 4, 0}, {0.5f, 0.3f, 0.0f}),
                  Point(2.0f, {4, 31, 0}, {0.5f, 0.4f, 0.0f})};
  LabelMask transient;
  transient.set(31);
  const auto observations = ObservationsOf(cloud, transient);
  EXPECT_TRUE(observations[0].is_transient);
  EXPECT_FALSE(observations[1].is_transient);
  EXPECT_EQ(observations[0].labels.label(0), 31);
  EXPECT_EQ(observations[1].labels.Unpacked().Probability(31), 0.0f);
  EXPECT_NEAR(observations[1].labels.Unpacked().Probability(4), 0.5f, 1e-4f);  // steps of 1/16383
}

TEST(ObservationCombinerTest, EachPointCountsByItsConfidence) {
  SemanticCloud cloud;
  cloud.points = {Point(3.0f, {4, 0, 0}, {0.9f, 0, 0}), Point(1.0f, {5, 4, 0}, {0.4f, 0.3f, 0}),
                  Point(2.0f, {5, 0, 0}, {0.4f, 0, 0})};
  cloud.points[0].rgb = {40, 50, 60};
  const VoxelObservation combined = Combined(ObservationsOf(cloud, {}));
  const LabelDistribution labels = combined.labels.Unpacked();
  // Two of three points would have voted for 5.
  EXPECT_EQ(labels.labels, (std::array<LabelId, 3>{4, 5, 0}));
  EXPECT_NEAR(labels.probabilities[0], 0.4f, 1e-4f);  // steps of 1/16383
  EXPECT_NEAR(labels.probabilities[1], 0.8f / 3, 1e-4f);
  EXPECT_EQ(combined.rgb, (std::array<std::uint8_t, 3>{20, 30, 40}));
  EXPECT_EQ(combined.points, 3);
  EXPECT_EQ(combined.position.x(), 1.0f);
}

TEST(ObservationCombinerTest, DoesNotDependOnTheOrder) {
  std::mt19937 random(3);
  SemanticCloud cloud;
  for (int i = 0; i < 300; ++i) {
    const float p = 0.3f + 0.0005f * i;
    cloud.points.push_back(
        Point(static_cast<float>(random() % 50),
              {static_cast<LabelId>(1 + i % 9), static_cast<LabelId>(20 + i % 11), 40},
              {p, (1 - p) / 2, (1 - p) / 3}));
    cloud.points.back().position.y() = static_cast<float>(i);
    cloud.points.back().rgb = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 2), 9};
  }
  auto observations = ObservationsOf(cloud, {});
  const VoxelObservation first = Combined(observations);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(observations.begin(), observations.end(), random);
    const VoxelObservation again = Combined(observations);
    EXPECT_TRUE(again.labels == first.labels);
    EXPECT_EQ(again.rgb, first.rgb);
    EXPECT_EQ(again.position, first.position);
  }
}

TEST(ObservationCombinerTest, CombiningWhatWasCombinedLosesNothing) {
  SemanticCloud cloud;
  cloud.points = {Point(1.0f, {4, 5, 6}, {0.5f, 0.3f, 0.1f}),
                  Point(2.0f, {4, 5, 7}, {0.7f, 0.2f, 0.05f})};
  const VoxelObservation once = Combined(ObservationsOf(cloud, {}));
  const VoxelObservation twice = Combined({once});
  EXPECT_TRUE(twice.labels == once.labels);
  EXPECT_EQ(twice.rgb, once.rgb);
  EXPECT_EQ(twice.points, 2);
}

TEST(ObservationCombinerTest, ForgetsWhatItHasGiven) {
  ObservationCombiner combiner;
  EXPECT_TRUE(combiner.empty());
  SemanticCloud cloud;
  cloud.points = {Point(1.0f, {4, 0, 0}, {0.5f, 0, 0}), Point(9.0f, {5, 0, 0}, {0.5f, 0, 0})};
  const auto observations = ObservationsOf(cloud, {});
  combiner.Add(observations[0], 0.0f);
  combiner.Take();
  EXPECT_TRUE(combiner.empty());
  combiner.Add(observations[1], 5.0f);
  const VoxelObservation second = combiner.Take();
  EXPECT_EQ(second.labels.label(0), 5);
  EXPECT_EQ(second.position.x(), 9.0f);
  EXPECT_EQ(second.points, 1);
}

}  // namespace
}  // namespace semantic_slam
