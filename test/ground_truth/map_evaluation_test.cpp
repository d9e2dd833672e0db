#include "semantic_slam/ground_truth/map_evaluation.h"

#include <gtest/gtest.h>

#include "ground_truth/small_run.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

MapEvaluation Evaluate(const RunOutputs& run,
                       const MapEvaluationOptions& options = SmallEvaluation()) {
  return EvaluateMaps(SmallWorld(), SmallVocabulary(), SmallTour(), *SmallCamera(), run, options);
}

TEST(MapEvaluationTest, APerfectRunHasNoErrors) {
  const MapEvaluation evaluation = Evaluate(PerfectRun());
  EXPECT_TRUE(evaluation.T_world_map.isApprox(SmallMapPose(), 1e-6));
  EXPECT_NEAR(Summarise(evaluation.trajectory.absolute.position_m).max, 0.0, 1e-9);
  ASSERT_TRUE(evaluation.voxels && evaluation.objects && evaluation.grid &&
              evaluation.semantic_grid);
  EXPECT_EQ(evaluation.voxels->all.voxels, 24u * 16u);
  EXPECT_EQ(evaluation.voxels->all.share(), 1.0);
  EXPECT_EQ(evaluation.voxels->without_surface, 0u);
  EXPECT_EQ(evaluation.objects->expected, 2u);  // table and lamp
  EXPECT_EQ(evaluation.objects->matches.size(), 2u);
  EXPECT_EQ(evaluation.objects->right_class(), 2u);
  EXPECT_NEAR(evaluation.objects->position_m().max, 0.0, 1e-6);
  EXPECT_GT(evaluation.grid->free_precision.cells, 1000u);
  EXPECT_EQ(evaluation.grid->free_precision.share(), 1.0);
  EXPECT_EQ(evaluation.grid->free_recall.share(), 1.0);
  EXPECT_EQ(evaluation.grid->occupied_precision.share(), 1.0);
  EXPECT_EQ(evaluation.grid->occupied_recall.share(), 1.0);
  // 1.2 m x 0.8 m in cells of 5 cm: a row of them at the edge is not covered.
  EXPECT_GT(evaluation.hollow.in_objects.share(), 0.9);
  EXPECT_EQ(evaluation.hollow.in_grid.cells, 0u);  // the drone flies over the table
}

TEST(MapEvaluationTest, AShiftedMapHasErrors) {
  RunOutputs run = PerfectRun();
  const RunOutputs elsewhere = PerfectRun(At(3.8, 1.5, M_PI / 2));
  run.tree = TableTop(SmallMapPose() * Eigen::Translation3d(0.0, 0.0, -0.3));  // 0.3 m up
  run.grid = elsewhere.grid;
  for (MapObject& object : run.objects->objects) object = InWorld(object, At(0.2, 0.0));
  const MapEvaluation evaluation = Evaluate(run);
  EXPECT_EQ(evaluation.voxels->all.voxels, 0u);
  EXPECT_EQ(evaluation.voxels->without_surface, 24u * 16u);
  EXPECT_NEAR(evaluation.objects->position_m().mean, 0.2, 1e-6);
  EXPECT_LT(evaluation.grid->occupied_precision.share(), 0.7);
  EXPECT_LT(evaluation.hollow.in_objects.share(), 0.9);
}

TEST(MapEvaluationTest, ATableAtTheFlightHeightBelongsInTheSemanticGrid) {
  MapEvaluationOptions options = SmallEvaluation();
  options.costs.flight_min_height_m = -0.7;  // of a robot that reaches down to the table
  const MapEvaluation without = Evaluate(PerfectRun(), options);
  EXPECT_GT(without.hollow.in_semantic_grid.cells, 1000u);
  EXPECT_EQ(without.hollow.in_semantic_grid.share(), 0.0);
  EXPECT_LT(without.semantic_grid->occupied_recall.share(), 1.0);
  RunOutputs run = PerfectRun();
  for (const MapObject& object : run.objects->objects) {
    FillPolygon(object.footprint_m, *run.semantic_grid);
  }
  const MapEvaluation with = Evaluate(run, options);
  EXPECT_GT(with.hollow.in_semantic_grid.share(), 0.9);
  EXPECT_EQ(with.hollow.in_grid.share(), 0.0);
  EXPECT_EQ(with.semantic_grid->occupied_recall.share(), 1.0);
}

TEST(MapEvaluationTest, WhatWasNotMadeIsNotScored) {
  RunOutputs run;
  run.trajectory = PerfectRun().trajectory;
  const MapEvaluation evaluation = Evaluate(run);
  EXPECT_EQ(evaluation.trajectory.matches.size(), SmallTour().size());
  EXPECT_FALSE(evaluation.voxels || evaluation.objects || evaluation.grid ||
               evaluation.semantic_grid);
  EXPECT_EQ(evaluation.hollow.in_objects.cells, 0u);
}

TEST(MapEvaluationTest, OnlyTheClassesAskedForCount) {
  MapEvaluationOptions options = SmallEvaluation();
  const TemporaryFolder folder;
  options.object_classes =
      ReadClassList(folder.Write("classes.yaml", "classes: [lamp, chair]"), SmallVocabulary());
  RunOutputs run = PerfectRun();
  run.objects->objects.clear();
  const MapEvaluation evaluation = Evaluate(run, options);
  EXPECT_EQ(evaluation.objects->expected, 1u);
}

TEST(MapEvaluationTest, MergedClassesAreOne) {
  MapEvaluationOptions options = SmallEvaluation();
  RunOutputs run = PerfectRun();
  for (MapObject& object : run.objects->objects) {
    LabelId& label = object.labels.front().label;
    if (label == SmallVocabulary().Find("table")) label = *SmallVocabulary().Find("chair");
  }
  EXPECT_EQ(Evaluate(run, options).objects->right_class(), 1u);
  const TemporaryFolder folder;
  options.object_classes =
      ReadClassList(folder.Write("classes.yaml", "classes: [lamp, chair]\nmerge: {table: chair}"),
                    SmallVocabulary());
  EXPECT_EQ(Evaluate(run, options).objects->right_class(), 2u);
}

TEST(MapEvaluationTest, WhatNobodySawIsNotExpected) {
  MapEvaluationOptions options = SmallEvaluation();
  options.min_views = 1000;
  RunOutputs run = PerfectRun();
  run.objects->objects.clear();
  EXPECT_EQ(Evaluate(run, options).objects->expected, 0u);
}

TEST(MapEvaluationTest, AStraightPathIsEnoughToTellHowTheMapLies) {
  Trajectory truth;
  RunOutputs run;
  for (int i = 0; i < 10; ++i) {
    truth.push_back(Looking(i, {0.5 + 0.1 * i, 1.5, 1.2}, 0.0));
    run.trajectory.push_back({truth.back().stamp, SmallMapPose().inverse() * truth.back().pose});
  }
  const MapEvaluation evaluation =
      EvaluateMaps(SmallWorld(), SmallVocabulary(), truth, *SmallCamera(), run, SmallEvaluation());
  EXPECT_TRUE(evaluation.T_world_map.isApprox(SmallMapPose(), 1e-6));
}

TEST(MapEvaluationTest, RefusesATrajectoryOfAnotherTime) {
  RunOutputs run = PerfectRun();
  for (StampedPose& stamped : run.trajectory) stamped.stamp.ns += 3'600'000'000'000;
  EXPECT_THROW(Evaluate(run), InputError);
}

TEST(MapEvaluationTest, TheFlightHeightIsTheMedian) {
  EXPECT_EQ(FlightHeight({Looking(0, {0, 0, 0.2}, 0), Looking(1, {0, 0, 1.3}, 0),
                          Looking(2, {0, 0, 1.4}, 0)}),
            1.3);
  EXPECT_NEAR(FlightBand(1.3, 0.2).min_height_m, 1.1, 1e-9);
  EXPECT_NEAR(FlightBand(1.3, 0.2).max_height_m, 1.5, 1e-9);
}

}  // namespace
}  // namespace semantic_slam
