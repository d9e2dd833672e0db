#include "semantic_slam/submaps/submap_collection.h"

#include <utility>

#include <gtest/gtest.h>

#include "submaps_fixture.h"

namespace semantic_slam {
namespace {

SubmapCollection SmallCollection(int max_submaps) {
  SubmapsOptions options;
  options.min_scans = 5;
  options.min_distance_m = 0.3;
  return SubmapCollection(options, {}, max_submaps);
}

void InsertAt(SubmapCollection& submaps, const Rigid2d& T_map_scan) {
  const PlanarScan scan = DepthLikeScan(PlanarRoom(), T_map_scan);
  submaps.Insert({scan, T_map_scan, 0, Rigid3d::Identity(), InSpace(T_map_scan)});
}

TEST(SubmapCollectionTest, KeepsWhatIsClosedInOrder) {
  SubmapCollection submaps = SmallCollection(100);
  for (int i = 0; i < 40; ++i) InsertAt(submaps, MakeRigid2d({-2.0 + 0.1 * i, 0.0}, 0.0));
  const std::vector<const Submap*> all = std::as_const(submaps).all();
  ASSERT_EQ(all.size(), submaps.size());
  EXPECT_GT(all.size(), 4u);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i]->id(), static_cast<int>(i));
  submaps.Reset();
  EXPECT_EQ(submaps.size(), 0u);
  EXPECT_TRUE(submaps.Render().cells.empty());
}

TEST(SubmapCollectionTest, KeepsNoMoreThanItsBudgetAndAlwaysTheActiveOnes) {
  SubmapCollection submaps = SmallCollection(3);
  for (int i = 0; i < 40; ++i) {
    InsertAt(submaps, MakeRigid2d({-2.0 + 0.1 * i, 0.0}, 0.0));
    EXPECT_LE(submaps.size(), 3u);
  }
  const std::vector<Submap*> all = submaps.all();
  EXPECT_EQ(all[2]->id(), all[1]->id() + 1) << "the two newest";
}

TEST(SubmapCollectionTest, MatchesToTheOlderActiveSubmap) {
  SubmapCollection submaps = SmallCollection(10);
  const ScanMatcher matcher({}, {}, {});
  const Rigid2d T = MakeRigid2d({0.5, -0.5}, 0.5);
  const Rigid2d expected = T * MakeRigid2d({0.05, 0.05}, 0.02);
  const PlanarScan scan = DepthLikeScan(PlanarRoom(), T);
  EXPECT_TRUE(submaps.Match(matcher, scan, expected).isApprox(expected)) << "no submap yet";
  for (int i = 0; i < 10; ++i) InsertAt(submaps, T);
  const Rigid2d matched = submaps.Match(matcher, scan, expected);
  // Half a cell's diagonal: within their cells the walls may lie anywhere.
  EXPECT_LT((matched.translation() - T.translation()).norm(), 0.035);
  EXPECT_TRUE(submaps.Match(matcher, PlanarScan(), expected).isApprox(expected)) << "an empty scan";
}

}  // namespace
}  // namespace semantic_slam
