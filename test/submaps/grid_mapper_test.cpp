#include "semantic_slam/submaps/grid_mapper.h"

#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/scan/scan_builder.h"
#include "submaps_fixture.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"
#include "testing/textured_room.h"

namespace semantic_slam {
namespace {

GridSlamOptions SmallSubmaps() {
  GridSlamOptions options;
  options.submaps.min_scans = 10;
  options.submaps.min_distance_m = 0.5;
  return options;
}

// A walk around the room, looking around: i counts the steps.
Rigid2d Walk(int i) {
  return MakeRigid2d({1.2 * std::sin(0.05 * i) - 0.5, 0.8 * std::sin(0.1 * i)}, 0.13 * i);
}

InsertOutcome InsertAt(GridMapper& mapper, const Rigid2d& T_map_scan, KeyframeId keyframe = 0,
                       const Rigid3d& T_map_keyframe = Rigid3d::Identity()) {
  return mapper.Insert(DepthLikeScan(PlanarRoom(), T_map_scan),
                       ImageAt(T_map_scan, keyframe, T_map_keyframe));
}

// Walks for `steps`, with a keyframe every tenth.
std::vector<Rigid3d> WalkAround(GridMapper& mapper, int steps) {
  std::vector<Rigid3d> keyframes;
  for (int i = 0; i < steps; ++i) {
    if (i % 10 == 0) keyframes.push_back(LevelCamera(Walk(i)));
    InsertAt(mapper, Walk(i), static_cast<KeyframeId>(keyframes.size()) - 1, keyframes.back());
  }
  return keyframes;
}

double DistanceToWall(const Eigen::Vector2d& point_m) {
  return PlanarRoom().Clearance(point_m);
}

TEST(GridMapperTest, DrawsTheWallsOfTheRoom) {
  GridMapper mapper(SmallSubmaps());
  WalkAround(mapper, 150);
  EXPECT_GT(mapper.submaps(), 2u);
  const OccupancyMap map = mapper.Render();
  // Submaps lie turned to the map's cells: rounding twice makes up to a cell's diagonal.
  const OccupiedCells occupied = CountOccupied(map, 0.071, DistanceToWall);
  // The room's outline is 21 m, 420 cells of 5 cm; corners and the pillar's back are out of sight.
  EXPECT_GT(occupied.count, 300);
  EXPECT_LE(occupied.far, 0);
  EXPECT_EQ(CellAt(map, {0.0, 0.0}), 2) << "as free as it gets";
}

TEST(GridMapperTest, DrawsTheRenderedRoom) {
  // Above everything but the walls; the camera turns around in the middle. In the map the room is
  // shifted by half a cell, so that its walls do not lie on borders of cells.
  constexpr double kShiftM = 0.025;
  const ScanBuilder builder({}, SmallCamera());
  GridMapper mapper;
  for (int i = 0; i < 24; ++i) {
    const TrackedImage image = ImageAt(MakeRigid2d({0.1, 0.2}, i * M_PI / 12));
    Rigid3d T_world_camera = image.T_map_camera;
    T_world_camera.translation() += Eigen::Vector3d(-kShiftM, -kShiftM, 2.05);
    mapper.Insert(builder.Build(SmallRoomImage(T_world_camera, Stamp{i}), T_world_camera), image);
  }
  const OccupancyMap map = mapper.Render();
  const auto is_wall = [kShiftM](const Eigen::Vector2d& centre_m) {
    const Eigen::Vector2d world_m = centre_m.array() - kShiftM;
    const double x_m = std::abs(world_m.x()) - TexturedRoom::kLengthM / 2;
    const double y_m = std::abs(world_m.y()) - TexturedRoom::kWidthM / 2;
    return std::abs(std::max(x_m, y_m)) < 0.02;
  };
  int both = 0, either = 0;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const Eigen::Vector2d centre_m =
          map.origin_m + map.resolution_m * Eigen::Vector2d(x + 0.5, y + 0.5);
      const bool occupied = map.cells[static_cast<std::size_t>(y) * map.width + x] >= 65;
      both += occupied && is_wall(centre_m);
      either += occupied || is_wall(centre_m);
    }
  }
  EXPECT_GT(both, 330) << "of 364 cells around the room";
  // Depth is exact; where a wall is seen at a slant, half a degree of it is more than a cell deep.
  EXPECT_GT(static_cast<double>(both) / either, 0.85) << "intersection over union";
}

TEST(GridMapperTest, MovesRigidlyWithTheKeyframes) {
  GridMapper mapper(SmallSubmaps());
  std::vector<Rigid3d> keyframes = WalkAround(mapper, 100);
  mapper.FollowGraph(GraphOf(1, keyframes));
  const OccupancyMap before = mapper.Render();
  const std::uint64_t changes = mapper.changes();
  // Whole cells along the axes, and a quarter turn, so that no rounding hides a mistake.
  const Rigid2d correction = MakeRigid2d({0.5, -1.0}, M_PI / 2);
  for (Rigid3d& keyframe : keyframes) keyframe = InSpace(correction) * keyframe;
  mapper.FollowGraph(GraphOf(2, keyframes));
  const OccupancyMap after = mapper.Render();
  EXPECT_GT(mapper.changes(), changes);
  EXPECT_EQ(after.revision, 2u);
  EXPECT_EQ(after.width, before.height);
  int differing = 0;
  for (int y = 0; y < before.height; ++y) {
    for (int x = 0; x < before.width; ++x) {
      const Eigen::Vector2d centre_m =
          before.origin_m + before.resolution_m * Eigen::Vector2d(x + 0.5, y + 0.5);
      const std::int8_t cell = before.cells[static_cast<std::size_t>(y) * before.width + x];
      differing += CellAt(after, correction * centre_m) != cell;
    }
  }
  // A centre that falls on a border of the submap's cells may round either way.
  EXPECT_LT(differing, before.width * before.height / 100);
}

TEST(GridMapperTest, BendsWithAnUnevenCorrection) {
  GridMapper mapper(SmallSubmaps());
  std::vector<Rigid3d> keyframes = WalkAround(mapper, 100);
  const OccupancyMap before = mapper.Render();
  keyframes.back().translation().x() += 1.0;
  mapper.FollowGraph(GraphOf(1, keyframes));
  const OccupancyMap after = mapper.Render();
  EXPECT_NE(after.cells, before.cells);
}

TEST(GridMapperTest, LeavesTheMapWhereCorrectionsAreTiny) {
  GridMapper mapper(SmallSubmaps());
  std::vector<Rigid3d> keyframes = WalkAround(mapper, 30);
  mapper.FollowGraph(GraphOf(1, keyframes));
  const std::uint64_t changes = mapper.changes();
  for (Rigid3d& keyframe : keyframes) keyframe.translation().y() += 0.005;
  mapper.FollowGraph(GraphOf(2, keyframes));
  EXPECT_EQ(mapper.changes(), changes);
}

TEST(GridMapperTest, PlacesScansByTodaysKeyframes) {
  GridMapper mapper;
  const Rigid3d T_map_keyframe = LevelCamera(MakeRigid2d({0.0, 0.0}, 0.0));
  const Rigid3d moved = InSpace(MakeRigid2d({0.0, 1.0}, 0.0)) * T_map_keyframe;
  mapper.FollowGraph(GraphOf(1, {moved}));
  InsertAt(mapper, MakeRigid2d({0.0, 0.0}, 0.0), 0, T_map_keyframe);
  const OccupancyMap map = mapper.Render();
  EXPECT_GT(CellAt(map, {3.02, 0.7}), 50) << "the wall at y = -0.3, moved by 1 m";
  EXPECT_EQ(CellAt(map, {3.02, -1.3}), OccupancyMap::kUnknown);
}

TEST(GridMapperTest, DoesNotGrowWhileStandingStill) {
  GridMapper mapper(SmallSubmaps());
  const Rigid2d T = MakeRigid2d({0.2, 0.1}, 0.3);
  EXPECT_EQ(InsertAt(mapper, T), InsertOutcome::kInserted);
  const OccupancyMap before = mapper.Render();
  const std::uint64_t changes = mapper.changes();
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(InsertAt(mapper, T), InsertOutcome::kNotMoved);
  EXPECT_EQ(mapper.submaps(), 1u);
  EXPECT_EQ(mapper.changes(), changes);
  EXPECT_EQ(mapper.Render().cells, before.cells);
}

TEST(GridMapperTest, DoesNotGrowWhileHovering) {
  GridMapper mapper(SmallSubmaps());
  for (int i = 0; i < 2000; ++i) InsertAt(mapper, MakeRigid2d({0.2 * std::sin(i), 0.0}, 0.0));
  EXPECT_EQ(mapper.submaps(), 1u);
}

TEST(GridMapperTest, ForgetsTheLeastMissedBeyondItsBudget) {
  GridSlamOptions options = SmallSubmaps();
  options.grid_mapper.max_submaps = 5;
  GridMapper mapper(options);
  for (int i = 0; i < 600; ++i) {
    InsertAt(mapper, Walk(i));
    ASSERT_LE(mapper.submaps(), 5u);
  }
  // Five are enough for this room.
  EXPECT_GT(CountOccupied(mapper.Render(), 0.071, DistanceToWall).count, 250);
}

TEST(GridMapperTest, LaysAnOldMapAside) {
  GridMapper mapper;
  InsertAt(mapper, MakeRigid2d({0.0, 0.0}, 0.0));
  TrackedImage image = ImageAt(MakeRigid2d({0.0, 0.0}, M_PI));
  image.map_id = 1;
  const PlanarScan scan = DepthLikeScan(PlanarRoom(), MakeRigid2d({0.0, 0.0}, M_PI), Stamp{7});
  EXPECT_EQ(mapper.Insert(scan, image), InsertOutcome::kInserted);
  const OccupancyMap map = mapper.Render();
  EXPECT_EQ(map.map_id, 1);
  EXPECT_EQ(map.stamp.ns, 7);
  EXPECT_EQ(CellAt(map, {3.02, -0.3}), OccupancyMap::kUnknown) << "seen in the old map only";
  EXPECT_GT(CellAt(map, {-2.98, 0.1}), 50);
  EXPECT_EQ(InsertAt(mapper, MakeRigid2d({1.0, 0.0}, 0.0)), InsertOutcome::kOldMap);
  mapper.FollowGraph(GraphOf(9, {}, 2));
  EXPECT_TRUE(mapper.Render().cells.empty()) << "the graph tells of a new map, too";
}

TEST(GridMapperTest, AMapThatWasLostComesBackWhenItIsJoined) {
  GridMapper mapper;
  InsertAt(mapper, MakeRigid2d({0.0, 0.0}, 0.0));  // at keyframe 0
  KeyframeGraph lost;
  lost.map_id = 1;
  lost.revision = 5;
  lost.reason = RevisionReason::kLost;
  mapper.FollowGraph(lost);
  EXPECT_TRUE(mapper.Render().cells.empty());
  EXPECT_EQ(mapper.submaps(), 0u);
  const std::uint64_t changes = mapper.changes();
  mapper.FollowGraph(GraphOf(6, {Rigid3d(Eigen::Translation3d(1.0, 0.0, 0.0))}, 1));
  EXPECT_GT(mapper.changes(), changes);
  EXPECT_GT(CellAt(mapper.Render(), {4.02, -0.3}), 50) << "where the wall at x = 3 m lies now";
}

TEST(GridMapperTest, AResetOrALoadedMapForgetsMapsThatWereLost) {
  for (const RevisionReason reason : {RevisionReason::kReset, RevisionReason::kLoad}) {
    GridMapper mapper;
    InsertAt(mapper, MakeRigid2d({0.0, 0.0}, 0.0));
    KeyframeGraph begun;
    begun.map_id = 1;
    begun.revision = 5;
    begun.reason = reason;
    mapper.FollowGraph(begun);
    mapper.FollowGraph(GraphOf(6, {Rigid3d::Identity()}, 1));
    EXPECT_TRUE(mapper.Render().cells.empty());
  }
}

TEST(GridMapperTest, IgnoresAnOldGraph) {
  GridMapper mapper;
  std::vector<Rigid3d> keyframes = WalkAround(mapper, 20);
  mapper.FollowGraph(GraphOf(5, keyframes));
  const OccupancyMap before = mapper.Render();
  for (Rigid3d& keyframe : keyframes) keyframe.translation().x() += 1.0;
  mapper.FollowGraph(GraphOf(4, keyframes));
  EXPECT_EQ(mapper.Render().cells, before.cells);
  EXPECT_EQ(mapper.Render().revision, 5u);
}

TEST(GridMapperTest, LeavesOutWhatItCannotUse) {
  GridMapper mapper;
  TrackedImage lost = ImageAt(MakeRigid2d({0.0, 0.0}, 0.0));
  lost.status = TrackingStatus::kLost;
  EXPECT_EQ(mapper.Insert(PlanarScan(), lost), InsertOutcome::kNotTracked);
  EXPECT_EQ(InsertAt(mapper, MakeRigid2d({1000.0, 0.0}, 0.0)), InsertOutcome::kTooFar);
  TrackedImage broken = ImageAt(MakeRigid2d({0.0, 0.0}, 0.0));
  broken.T_map_camera.linear()(0, 0) = std::nan("");
  EXPECT_EQ(mapper.Insert(PlanarScan(), broken), InsertOutcome::kTooFar);
  EXPECT_TRUE(mapper.Render().cells.empty());
  EXPECT_EQ(mapper.Insert(PlanarScan(), ImageAt(MakeRigid2d({0.0, 0.0}, 0.0))),
            InsertOutcome::kInserted);
  EXPECT_TRUE(mapper.Render().cells.empty()) << "an empty scan says nothing";
}

TEST(GridMapperTest, MatchingSharpensWhatInexactPosesBlur) {
  GridSlamOptions options = SmallSubmaps();
  options.grid_mapper.min_motion_m = 0.0;
  GridSlamOptions matching = options;
  matching.grid_mapper.match_scans = true;
  GridMapper plain_mapper(options), matching_mapper(matching);
  std::mt19937 random(1);
  std::normal_distribution<double> error(0.0, 0.03);  // [m], and as many radians over 3
  for (int i = 0; i < 100; ++i) {
    const Rigid2d T = MakeRigid2d({0.01 * i - 0.5, 0.2}, 0.3);
    const PlanarScan scan = DepthLikeScan(PlanarRoom(), T);
    const TrackedImage image =
        ImageAt(T * MakeRigid2d({error(random), error(random)}, error(random) / 3));
    plain_mapper.Insert(scan, image);
    matching_mapper.Insert(scan, image);
  }
  const int plain = CountOccupied(plain_mapper.Render(), 0.1, DistanceToWall).count;
  const int matched = CountOccupied(matching_mapper.Render(), 0.1, DistanceToWall).count;
  EXPECT_LT(matched, plain) << "thinner walls";
}

TEST(GridMapperTest, GivesTheSameBytesTwice) {
  GridSlamOptions options = SmallSubmaps();
  options.grid_mapper.match_scans = true;
  GridMapper first(options), second(options);
  WalkAround(first, 60);
  WalkAround(second, 60);
  EXPECT_EQ(first.Render().cells, second.Render().cells);
}

TEST(GridMapperTest, RefusesOptionsOutOfRange) {
  GridSlamOptions options;
  options.grid_mapper.max_submaps = 2;
  EXPECT_EQ(MessageOf<ConfigError>([&] { GridMapper{options}; }),
            "max_submaps = 2, but must be in [3, 100000]");
}

TEST(GridMapperTest, NamesOutcomes) {
  EXPECT_STREQ(ToString(InsertOutcome::kInserted), "inserted");
  EXPECT_STREQ(ToString(InsertOutcome::kNotMoved), "not_moved");
  EXPECT_STREQ(ToString(InsertOutcome::kNotTracked), "not_tracked");
  EXPECT_STREQ(ToString(InsertOutcome::kOldMap), "old_map");
  EXPECT_STREQ(ToString(InsertOutcome::kTooFar), "too_far");
}

}  // namespace
}  // namespace semantic_slam
