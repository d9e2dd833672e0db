#include "semantic_slam/submaps/active_submaps.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "submaps_fixture.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

SubmapsOptions SmallSubmaps() {
  SubmapsOptions options;
  options.min_scans = 10;
  options.min_distance_m = 1.0;
  options.min_turn_deg = 45.0;
  return options;
}

// Enters a scan of the room at a pose; returns the ids of what closed.
std::vector<SubmapId> InsertAt(ActiveSubmaps& active, const Rigid2d& T_map_scan) {
  const PlanarScan scan = DepthLikeScan(PlanarRoom(), T_map_scan);
  std::vector<SubmapId> closed;
  for (const auto& submap : active.Insert(
           {scan, T_map_scan, 0, Rigid3d::Identity(), InSpace(T_map_scan)}, ScanInserter())) {
    closed.push_back(submap->id());
  }
  return closed;
}

TEST(ActiveSubmapsTest, KeepsTwoThatOverlap) {
  ActiveSubmaps active(SmallSubmaps());
  EXPECT_TRUE(active.submaps().empty());
  std::vector<SubmapId> closed;
  for (int i = 0; i < 60; ++i) {
    const std::vector<SubmapId> now = InsertAt(active, MakeRigid2d({-2.0 + 0.06 * i, 0.0}, 0.0));
    closed.insert(closed.end(), now.begin(), now.end());
    EXPECT_LE(active.submaps().size(), 2u);
  }
  // 3.5 m of way, a new one every metre (17 steps of 6 cm, and a scan to notice it).
  EXPECT_EQ(closed, (std::vector<SubmapId>{0, 1}));
  ASSERT_EQ(active.submaps().size(), 2u);
  EXPECT_EQ(active.submaps().front()->id(), 2);
  EXPECT_EQ(active.submaps().back()->id(), 3);
  EXPECT_GT(active.submaps().front()->scans(), active.submaps().back()->scans());
}

TEST(ActiveSubmapsTest, ClosesNoneWhileHovering) {
  ActiveSubmaps active(SmallSubmaps());
  for (int i = 0; i < 500; ++i) {
    const double sway = 0.3 * std::sin(0.7 * i);
    EXPECT_TRUE(InsertAt(active, MakeRigid2d({sway, -0.5 * sway}, sway)).empty());
  }
  EXPECT_EQ(active.submaps().size(), 1u);
}

TEST(ActiveSubmapsTest, BeginsAnewAfterATurn) {
  ActiveSubmaps active(SmallSubmaps());
  for (int i = 0; i < 20; ++i) InsertAt(active, MakeRigid2d({0.0, 0.0}, 0.05 * i));
  EXPECT_EQ(active.submaps().size(), 2u);
}

TEST(ActiveSubmapsTest, WantsEnoughScansToo) {
  ActiveSubmaps active(SmallSubmaps());
  for (int i = 0; i < 9; ++i) InsertAt(active, MakeRigid2d({0.4 * i, 0.0}, 0.0));
  EXPECT_EQ(active.submaps().size(), 1u);
}

TEST(ActiveSubmapsTest, DoesNotStretchASubmapOverAJump) {
  SubmapsOptions options = SmallSubmaps();
  options.max_distance_m = 3.0;
  ActiveSubmaps active(options);
  InsertAt(active, MakeRigid2d({-2.0, 0.0}, 0.0));
  EXPECT_EQ(InsertAt(active, MakeRigid2d({2.0, 0.0}, 0.0)), std::vector<SubmapId>{0});
  ASSERT_EQ(active.submaps().size(), 1u);
  EXPECT_EQ(active.submaps().front()->id(), 1);
}

TEST(ActiveSubmapsTest, RefusesASubmapOfNoScans) {
  SubmapsOptions options;
  options.min_scans = 0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { ActiveSubmaps{options}; }),
            "min_scans = 0, but must be in [1, 100000]");
}

}  // namespace
}  // namespace semantic_slam
