#include "semantic_slam/ground_truth/run_outputs.h"

#include <gtest/gtest.h>

#include "ground_truth/small_run.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/object_mapping/object_map_file.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "semantic_slam/submaps/occupancy_map_file.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

TEST(RunOutputsTest, ReadsAllThatIsThere) {
  const TemporaryFolder folder;
  const RunOutputs run = PerfectRun();
  WriteTumTrajectory(run.trajectory, folder / "trajectory.txt");
  const RunOutputs trajectory_only = ReadRunOutputs(folder.path(), SmallVocabulary());
  EXPECT_EQ(trajectory_only.trajectory.size(), run.trajectory.size());
  EXPECT_EQ(trajectory_only.tree, nullptr);
  EXPECT_FALSE(trajectory_only.objects || trajectory_only.grid || trajectory_only.semantic_grid);

  WriteSemanticTree(folder / "semantic_map.ot", *run.tree, SmallVocabulary());
  WriteObjectMap(folder / "objects.json", *run.objects, SmallVocabulary());
  WriteOccupancyMap(folder.path(), *run.grid);
  WriteOccupancyMap(folder.path(), *run.semantic_grid, "semantic_grid");
  const RunOutputs all = ReadRunOutputs(folder.path(), SmallVocabulary());
  ASSERT_NE(all.tree, nullptr);
  EXPECT_EQ(all.tree->size(), run.tree->size());
  EXPECT_EQ(all.objects->objects.size(), 2u);
  EXPECT_EQ(all.grid->cells, run.grid->cells);
  EXPECT_EQ(all.semantic_grid->width, run.grid->width);
}

TEST(RunOutputsTest, NamesWhatIsMissingOrDamaged) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& path) {
    return MessageOf<InputError>([&] { ReadRunOutputs(path, SmallVocabulary()); });
  };
  ExpectOneLineWith(message(folder / "none"), {"no such folder", "none"});
  ExpectOneLineWith(message(folder.path()), {"trajectory.txt"});
  WriteTumTrajectory(SmallTour(), folder / "trajectory.txt");
  folder.Write("objects.json", "{");
  ExpectOneLineWith(message(folder.path()), {"objects.json"});
}

}  // namespace
}  // namespace semantic_slam
