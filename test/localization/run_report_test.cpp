#include "semantic_slam/localization/run_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"
#include "testing/small_sequence.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

std::string Content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> FilesIn(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

int LinesOf(const std::string& path) {
  const std::string content = Content(path);
  return static_cast<int>(std::count(content.begin(), content.end(), '\n'));
}

// A run of a few images, the last of them blank.
class RunReportTest : public testing::Test {
 protected:
  static constexpr int kTracked = 8;

  RunReportTest() : localization_(SmallSequenceOptions(), SmallCamera(), MappingMode::kInline) {
    facts_.source = "a room";
    facts_.gravity = "imu";
    facts_.dropped = {{"no_depth", 3}};
    facts_.timings_in_summary = false;
  }

  void Run() {
    localization_.SetStart(SmallSequencePose(0));
    for (int i = 0; i < kTracked; ++i) recorder_.Add(localization_.Track(SmallSequenceImage(i)));
    recorder_.Add(localization_.Track(BlankImage(SmallSequenceStamp(kTracked))));
  }

  void Write(const std::string& folder, const Trajectory& ground_truth = {}) const {
    WriteRunReport(folder, recorder_, localization_, facts_, ground_truth);
  }

  nlohmann::json Summary() const {
    return nlohmann::json::parse(Content(folder_ / "summary.json"));
  }

  const TemporaryFolder folder_;
  RunFacts facts_;
  TrajectoryRecorder recorder_;
  VisualLocalization localization_;
};

TEST_F(RunReportTest, LeavesEveryFile) {
  Run();
  Write(folder_.path());
  EXPECT_EQ(FilesIn(folder_.path()),
            (std::set<std::string>{"keyframe_trajectory.txt", "summary.json", "timing.csv",
                                   "trajectory.png", "trajectory.txt", "trajectory_live.txt"}));
  const Trajectory corrected = ReadTumTrajectory(folder_ / "trajectory.txt");
  const Trajectory live = ReadTumTrajectory(folder_ / "trajectory_live.txt");
  ASSERT_EQ(corrected.size(), static_cast<std::size_t>(kTracked));
  ASSERT_EQ(live.size(), corrected.size());
  for (int i = 0; i < kTracked; ++i) {
    EXPECT_EQ(corrected[i].stamp, SmallSequenceStamp(i));
    EXPECT_LT(DistanceBetween(corrected[i].pose, SmallSequencePose(i)), 0.02) << i;
    // Nine decimals of a quaternion.
    EXPECT_TRUE(live[i].pose.isApprox(recorder_.live()[i].pose, 1e-7)) << i;
  }
  EXPECT_EQ(LinesOf(folder_ / "timing.csv"),
            1 + static_cast<int>(localization_.timings().size()));  // a header before them
}

TEST_F(RunReportTest, TheSummaryCounts) {
  Run();
  Write(folder_.path());
  const nlohmann::json summary = Summary();
  const KeyframeGraph graph = localization_.keyframe_graph();
  const std::size_t keyframes = KeyframeTrajectory(graph).size();
  EXPECT_EQ(summary["source"], "a room");
  EXPECT_EQ(summary["images"], kTracked + 1);
  EXPECT_EQ(summary["tracked"], kTracked);
  EXPECT_EQ(summary["lost"], 1);
  EXPECT_EQ(summary["keyframes"], keyframes);
  EXPECT_EQ(summary["keyframes_culled"], graph.keyframes.size() - keyframes);
  EXPECT_EQ(summary["keyframes_rejected"], 0);
  EXPECT_EQ(summary["map_points"], localization_.map_points().size());
  EXPECT_EQ(summary["loops"], 0);
  EXPECT_EQ(summary["gravity"], "imu");
  EXPECT_EQ(summary["dropped"], nlohmann::json({{"no_depth", 3}}));
}

// Once around on the spot, in the middle of the room, until the camera sees again what it saw
// first.
TEST_F(RunReportTest, TheSummaryCountsClosedLoops) {
  constexpr int kImages = 64;
  Rigid3d T_base_camera = Rigid3d::Identity();
  T_base_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  for (int i = 0; i < kImages; ++i) {
    const Rigid3d T_world_camera = Eigen::Translation3d(0.0, 0.1 * std::sin(0.3 * i), 1.3) *
                                   Eigen::AngleAxisd(0.11 * i, Eigen::Vector3d::UnitZ()) *
                                   T_base_camera;
    recorder_.Add(localization_.Track(SmallRoomImage(T_world_camera, SmallSequenceStamp(i))));
  }
  ASSERT_EQ(recorder_.tracked(), static_cast<std::size_t>(kImages));
  ASSERT_GE(localization_.closed_loops(), 1u);
  Write(folder_.path());
  EXPECT_EQ(Summary()["loops"], localization_.closed_loops());
}

TEST_F(RunReportTest, TwoRunsGiveTheSameBytes) {
  Run();
  Write(folder_ / "first");
  recorder_ = TrajectoryRecorder();
  VisualLocalization again(SmallSequenceOptions(), SmallCamera(), MappingMode::kInline);
  again.SetStart(SmallSequencePose(0));
  for (int i = 0; i < kTracked; ++i) recorder_.Add(again.Track(SmallSequenceImage(i)));
  recorder_.Add(again.Track(BlankImage(SmallSequenceStamp(kTracked))));
  WriteRunReport(folder_ / "again", recorder_, again, facts_);
  for (const std::string& file : FilesIn(folder_ / "first")) {
    if (file == "timing.csv") continue;
    EXPECT_EQ(Content(folder_ / ("first/" + file)), Content(folder_ / ("again/" + file))) << file;
  }
}

TEST_F(RunReportTest, TimingsAreInTheSummaryOnlyIfAskedFor) {
  Run();
  Write(folder_.path());
  EXPECT_FALSE(Summary().contains("stages"));
  facts_.timings_in_summary = true;
  Write(folder_.path());
  EXPECT_EQ(Summary()["stages"]["tracking"]["count"], kTracked + 1);
}

TEST_F(RunReportTest, TellsOfTheStagesBehindTracking) {
  Run();
  facts_.stages["semantic"] = {{"images", 4}, {"voxels", 120}};
  facts_.stage_timings = {{"semantic.cloud", 4, 1.5, 2.0}};
  facts_.timings_in_summary = true;
  Write(folder_.path());
  EXPECT_EQ(Summary()["semantic"], nlohmann::json({{"images", 4}, {"voxels", 120}}));
  EXPECT_EQ(Summary()["stages"]["semantic.cloud"]["count"], 4);
  EXPECT_NE(Content(folder_ / "timing.csv").find("semantic.cloud,4,"), std::string::npos);
}

TEST_F(RunReportTest, TellsHowLivePosesCame) {
  Run();
  Write(folder_.path());
  EXPECT_FALSE(Summary().contains("live"));
  facts_.live = LiveFacts{{{SmallSequenceStamp(0), 5.0}, {SmallSequenceStamp(1), 50.0}}, 1.8, 0.9};
  Write(folder_.path());
  EXPECT_EQ(Summary()["live"]["in_time"], 1);
  EXPECT_EQ(Summary()["live"]["late"], 1);
  EXPECT_DOUBLE_EQ(Summary()["live"]["cpu_ms_per_image"], 100.0);  // of nine images
  EXPECT_EQ(LinesOf(folder_ / "delays.csv"), 3);
}

TEST_F(RunReportTest, ComparesWithTheGroundTruthIfThereIsOne) {
  Run();
  Write(folder_.path());
  EXPECT_FALSE(Summary().contains("trajectory_error"));
  Trajectory ground_truth;
  for (int i = 0; i < kTracked; ++i) {
    ground_truth.push_back({SmallSequenceStamp(i), SmallSequencePose(i)});
  }
  Write(folder_.path(), ground_truth);
  EXPECT_TRUE(Summary()["trajectory_error"].is_object());
}

TEST_F(RunReportTest, AGroundTruthOfAnotherTimeIsToldNotThrown) {
  Run();
  EXPECT_NO_THROW(Write(folder_.path(), {{Stamp{1}, Rigid3d::Identity()}}));
  EXPECT_TRUE(Summary()["trajectory_error"].is_string());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "trajectory.png"));
}

TEST_F(RunReportTest, ARunThatNeverStartedLeavesAReportToo) {
  recorder_.Add(localization_.Track(BlankImage(SmallSequenceStamp(0))));
  Write(folder_.path());
  EXPECT_EQ(Summary()["images"], 1);
  EXPECT_EQ(Summary()["tracked"], 0);
  EXPECT_EQ(Summary()["keyframes"], 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "trajectory.txt"));
}

TEST_F(RunReportTest, NamesTheFileThatCannotBeWritten) {
  const std::string not_a_folder = folder_.Write("occupied", "by a file");
  ExpectOneLineWith(MessageOf<InputError>([&] { Write(not_a_folder); }),
                    {"cannot write", "occupied/trajectory.txt"});
  EXPECT_EQ(Content(not_a_folder), "by a file");
}

}  // namespace
}  // namespace semantic_slam
