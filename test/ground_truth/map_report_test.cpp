#include "semantic_slam/ground_truth/map_report.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ground_truth/small_run.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

MapEvaluation Evaluate(const RunOutputs& run) {
  return EvaluateMaps(SmallWorld(), SmallVocabulary(), SmallTour(), *SmallCamera(), run,
                      SmallEvaluation());
}

RunOutputs TrajectoryOnly() {
  RunOutputs run;
  run.trajectory = PerfectRun().trajectory;
  return run;
}

TEST(MapReportTest, JsonHoldsEverything) {
  const auto json = ToJson(Evaluate(PerfectRun()), SmallVocabulary());
  EXPECT_NEAR(json["trajectory"]["ate_rmse_m"].get<double>(), 0.0, 1e-9);
  EXPECT_EQ(json["voxels"]["right"], 1.0);
  EXPECT_EQ(json["voxels"]["by_class"]["table"]["voxels"], 24 * 16);
  EXPECT_EQ(json["voxels"]["by_observations"]["2-3"]["right"], 1.0);
  EXPECT_TRUE(json["voxels"]["by_observations"]["32+"]["right"].is_null());
  EXPECT_EQ(json["objects"]["found"], 2);
  EXPECT_EQ(json["objects"]["right_class"], 1.0);
  EXPECT_EQ(json["grid"]["free_precision"], 1.0);
  EXPECT_EQ(json["semantic_grid"]["occupied_recall"], 1.0);
  EXPECT_TRUE(json["hollow_area"]["in_grid"].is_null());
}

TEST(MapReportTest, WhatIsNotThereIsNull) {
  const auto json = ToJson(Evaluate(TrajectoryOnly()), SmallVocabulary());
  for (const char* key : {"voxels", "objects", "grid", "semantic_grid"}) {
    EXPECT_TRUE(json[key].is_null()) << key;
  }
}

TEST(MapReportTest, TheTableHasALineForEach) {
  std::ostringstream out;
  PrintTable(Evaluate(PerfectRun()), SmallVocabulary(), out);
  for (const char* part : {"ATE", "0.000 m", "100.0 %", "table", "seen 2-3 times", "right class",
                           "floor plan", "semantic grid"}) {
    EXPECT_NE(out.str().find(part), std::string::npos) << part;
  }
}

TEST(MapReportTest, TheTableSaysWhatIsMissing) {
  std::ostringstream out;
  PrintTable(Evaluate(TrajectoryOnly()), SmallVocabulary(), out);
  EXPECT_NE(out.str().find("voxels                                    -\n"), std::string::npos)
      << out.str();
}

}  // namespace
}  // namespace semantic_slam
