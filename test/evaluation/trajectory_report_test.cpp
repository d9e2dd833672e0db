#include "semantic_slam/evaluation/trajectory_report.h"

#include <stdio.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

using Json = nlohmann::ordered_json;
using Positions = std::vector<Eigen::Vector3d>;

constexpr RelativeInterval kOneMetre{RelativeInterval::Unit::kMetres, 1.0};

// A square of two metres and its centre; the way through is 6 + sqrt(2) metres long.
const Positions kSquareAndCentre{
    {1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}, {-1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}, {0.0, 0.0, 0.0}};

// One pose a second, none turned.
Trajectory Through(const Positions& positions) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    trajectory.push_back({Stamp::FromSeconds(static_cast<double>(i)), Rigid3d::Identity()});
    trajectory.back().pose.translation() = positions[i];
  }
  return trajectory;
}

// The same path seen from elsewhere, but the sensor at the centre is a metre too high.
Trajectory WithOneBadPose() {
  Trajectory trajectory = Through(kSquareAndCentre);
  trajectory.back().pose.translation().z() += 1.0;
  for (StampedPose& stamped : trajectory) stamped.pose.translation() += Eigen::Vector3d(3, -4, 5);
  return trajectory;
}

Trajectory AtSeconds(const std::vector<double>& stamps_s) {
  Trajectory trajectory;
  for (const double stamp_s : stamps_s) {
    trajectory.push_back({Stamp::FromSeconds(stamp_s), Rigid3d::Identity()});
  }
  return trajectory;
}

std::vector<std::string> Keys(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(TrajectoryReportTest, APureOffsetIsNoError) {
  Trajectory estimate = Through(kSquareAndCentre);
  for (StampedPose& stamped : estimate) stamped.pose.translation() += Eigen::Vector3d(10, 20, 30);
  const TrajectoryReport report = CompareTrajectories(Through(kSquareAndCentre), estimate, {}, {});
  EXPECT_EQ(report.matches.size(), 5u);
  EXPECT_NEAR(report.path_m, 6.0 + std::sqrt(2.0), 1e-12);
  // Coordinates of tens of metres, a few roundings each.
  EXPECT_NEAR(Summarise(report.absolute.position_m).max, 0.0, 1e-12);
  EXPECT_NEAR(Summarise(report.relative.translation_m).max, 0.0, 1e-12);
  EXPECT_TRUE(
      report.T_reference_estimate.translation().isApprox(Eigen::Vector3d(-10, -20, -30), 1e-12));
}

TEST(TrajectoryReportTest, OneBadPoseGivesTheErrorsWeWorkOutByHand) {
  // Alignment takes out a fifth of the metre, so corners are off by 0.2 m and the centre by 0.8 m.
  const Json json =
      ToJson(CompareTrajectories(Through(kSquareAndCentre), WithOneBadPose(), {}, {}));
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(json["ate_rmse_m"], 0.4, kRounding);  // sqrt((4 * 0.04 + 0.64) / 5)
  EXPECT_NEAR(json["ate_mean_m"], 0.32, kRounding);
  EXPECT_NEAR(json["ate_median_m"], 0.2, kRounding);
  EXPECT_NEAR(json["ate_max_m"], 0.8, kRounding);
  EXPECT_NEAR(json["ate_rmse_deg"], 0.0, 1e-6);  // half the digits: nearly the identity
  EXPECT_NEAR(json["mean_deviation_xy_m"], 0.0, kRounding);
  EXPECT_NEAR(json["mean_deviation_xz_m"], 0.32, kRounding);
  EXPECT_NEAR(json["rpe_trans_rmse_m"], 0.5, kRounding);  // of 0, 0, 0 and 1
  EXPECT_NEAR(json["rpe_trans_mean_m"], 0.25, kRounding);
  EXPECT_NEAR(json["rpe_trans_median_m"], 0.0, kRounding);
  EXPECT_NEAR(json["rpe_trans_max_m"], 1.0, kRounding);
  EXPECT_EQ(json["rpe_seconds"], 1.0);
  EXPECT_EQ(json["rpe_pairs"], 4);
  EXPECT_EQ(json["matched"], 5);
}

TEST(TrajectoryReportTest, JsonOverTimeHasTheseKeysInThisOrder) {
  const Json json =
      ToJson(CompareTrajectories(Through(kSquareAndCentre), WithOneBadPose(), {}, {}));
  EXPECT_EQ(Keys(json), (std::vector<std::string>{
                            "ate_rmse_m",          "ate_mean_m",       "ate_median_m",
                            "ate_max_m",           "ate_rmse_deg",     "ate_mean_deg",
                            "ate_median_deg",      "ate_max_deg",      "mean_deviation_xy_m",
                            "mean_deviation_xz_m", "rpe_seconds",      "rpe_pairs",
                            "rpe_trans_rmse_m",    "rpe_trans_mean_m", "rpe_trans_median_m",
                            "rpe_trans_max_m",     "rpe_rot_rmse_deg", "rpe_rot_mean_deg",
                            "rpe_rot_median_deg",  "rpe_rot_max_deg",  "matched",
                            "reference_poses",     "estimate_poses",   "path_m"}));
}

TEST(TrajectoryReportTest, JsonOverPathHasErrorsPerLength) {
  const Json json =
      ToJson(CompareTrajectories(Through(kSquareAndCentre), WithOneBadPose(), {}, kOneMetre));
  // Three segments of 2 m without an error and one of sqrt(2) m that is off by a metre.
  EXPECT_NEAR(json["rpe_percent"], 100.0 / std::sqrt(2.0) / 4.0, 1e-10);
  EXPECT_NEAR(json["rpe_deg_per_m"], 0.0, 1e-6);
  EXPECT_EQ(json["rpe_metres"], 1.0);
  EXPECT_EQ(json["rpe_pairs"], 4);
  EXPECT_FALSE(json.contains("rpe_seconds"));
}

TEST(TrajectoryReportTest, JsonIsNullWhereThereIsNoPair) {
  const RelativeInterval minute{RelativeInterval::Unit::kSeconds, 60.0};
  const Json json =
      ToJson(CompareTrajectories(Through(kSquareAndCentre), WithOneBadPose(), {}, minute));
  EXPECT_EQ(json["rpe_pairs"], 0);
  EXPECT_TRUE(json["rpe_trans_rmse_m"].is_null());
  EXPECT_TRUE(json["rpe_rot_max_deg"].is_null());
  EXPECT_TRUE(json["ate_rmse_m"].is_number());
}

TEST(TrajectoryReportTest, PrintsATable) {
  std::ostringstream table;
  PrintTable(CompareTrajectories(Through(kSquareAndCentre), WithOneBadPose(), {}, kOneMetre),
             table);
  EXPECT_EQ(table.str(),
            "5 of 5 estimated poses matched with 5 reference poses, path 7.414 m\n"
            "\n"
            "                             rmse       mean     median        max\n"
            "ATE                        0.4000     0.3200     0.2000     0.8000  m\n"
            "                           0.0000     0.0000     0.0000     0.0000  deg\n"
            "deviation in X-Y           0.0000     0.0000     0.0000     0.0000  m\n"
            "deviation in X-Z           0.4000     0.3200     0.2000     0.8000  m\n"
            "RPE over 1 m               0.5000     0.2500     0.0000     1.0000  m\n"
            "                           0.0000     0.0000     0.0000     0.0000  deg\n"
            "  per length of path                 17.6777                        %\n"
            "                                      0.0000                        deg/m\n");
}

TEST(TrajectoryReportTest, TheTableSaysWhereThereIsNoPair) {
  std::ostringstream table;
  const RelativeInterval minute{RelativeInterval::Unit::kSeconds, 60.0};
  PrintTable(CompareTrajectories(Through(kSquareAndCentre), WithOneBadPose(), {}, minute), table);
  EXPECT_NE(table.str().find("\nRPE over 60 s: no pair of matched poses is that far apart\n"),
            std::string::npos)
      << table.str();
}

TEST(TrajectoryReportTest, NeedsThreeMatches) {
  const auto message = [](const Trajectory& reference, const Trajectory& estimate) {
    return MessageOf<InputError>([&] { CompareTrajectories(reference, estimate, {}, {}); });
  };
  EXPECT_EQ(message(AtSeconds({1.0, 2.0, 3.0}), AtSeconds({1.0, 2.0, 2.5, 9.5})),
            "only 2 poses match within 0.02 s, expected at least 3; the reference has 3 poses from "
            "1.000000 s to 3.000000 s, the estimate 4 from 1.000000 s to 9.500000 s");
  EXPECT_EQ(message(AtSeconds({1.0}), {}),
            "only 0 poses match within 0.02 s, expected at least 3; the reference has 1 poses from "
            "1.000000 s to 1.000000 s, the estimate 0");
  EXPECT_EQ(message(AtSeconds({1.0, 2.0, 3.0}), AtSeconds({1.0, 2.0, 3.0})), "");
}

TEST(TrajectoryReportTest, RefusesOptionsAndIntervalsThatAreOutOfRange) {
  const auto message = [](const AssociationOptions& options, const RelativeInterval& interval) {
    return MessageOf<ConfigError>([&] { CompareTrajectories({}, {}, options, interval); });
  };
  EXPECT_EQ(message({}, {RelativeInterval::Unit::kSeconds, 0.0}),
            "rpe_seconds = 0, but must be in [0.001, 1e+06]");
  EXPECT_EQ(message({}, {RelativeInterval::Unit::kMetres, -1.0}),
            "rpe_metres = -1, but must be in [0.001, 1e+06]");
  EXPECT_EQ(message({11.0, 0.0}, {}), "max_dt_s = 11, but must be in [0, 10]");
}

// A seeded copy of `reference` as a tracker might estimate it: in another frame, its clock half a
// second ahead, at a third of the rate with a silence of two seconds, jitter and noise.
Trajectory Perturbed(const Trajectory& reference) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Eigen::Vector3d(noise(random), noise(random), noise(random)); };
  Rigid3d T_estimate_reference = Rigid3d::Identity();
  T_estimate_reference.translation() << 1.0, -2.0, 3.0;
  T_estimate_reference.linear() = ExpSo3({0.5, -1.0, 2.0});
  Trajectory estimate;
  for (const StampedPose& stamped : reference) {
    const double since_start_s = SecondsBetween(reference.front().stamp, stamped.stamp);
    if (uniform(random) > -1.0 / 3.0 || (since_start_s > 5.0 && since_start_s < 7.0)) continue;
    Rigid3d error = Rigid3d::Identity();
    error.translation() = 0.01 * vector();
    error.linear() = ExpSo3(0.01 * vector());
    const double shift_s = 0.5 + 0.004 * uniform(random);
    estimate.push_back({Stamp{stamped.stamp.ns + std::llround(1e9 * shift_s)},
                        T_estimate_reference * stamped.pose * error});
  }
  return estimate;
}

std::string OutputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string output;
  std::array<char, 4096> buffer{};
  if (!pipe) return output;
  while (const std::size_t size = ::fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    output.append(buffer.data(), size);
  }
  return output;
}

TEST(TrajectoryReportTest, AgreesWithAnIndependentEvaluator) {
  const auto evaluator = SharedData("tools/trajectory_error.py");
  SEMANTIC_SLAM_SKIP_WITHOUT(evaluator, "tools/trajectory_error.py");
  const auto reference_path = SharedData(std::string(kFreiburg1Desk) + "/groundtruth.txt");
  SEMANTIC_SLAM_SKIP_WITHOUT(reference_path, "the ground truth of freiburg1_desk");

  const TemporaryFolder folder;
  const std::string estimate_path = folder / "estimate.txt";
  const Trajectory reference = ReadTumTrajectory(*reference_path);
  WriteTumTrajectory(Perturbed(reference), estimate_path);
  AssociationOptions options;
  options.offset_s = -0.5;
  const Json ours =
      ToJson(CompareTrajectories(reference, ReadTumTrajectory(estimate_path), options, {}));
  const std::string output = OutputOf("/usr/bin/python3 '" + *evaluator + "' '" + *reference_path +
                                      "' '" + estimate_path + "' --offset -0.5 --json");
  const Json theirs = Json::parse(output, nullptr, false);
  ASSERT_TRUE(theirs.is_object()) << output;

  EXPECT_GT(ours["matched"], 500);
  EXPECT_EQ(ours["matched"], theirs["matched"]);
  EXPECT_EQ(ours["rpe_pairs"], theirs["rpe_pairs"]);
  // Both see the same text; a wrong match or formula would show in the third digit.
  constexpr double kTolerance = 1e-6;
  EXPECT_NEAR(ours["ate_rmse_m"], theirs["ate_rmse_m"], kTolerance);
  EXPECT_NEAR(ours["ate_median_m"], theirs["ate_median_m"], kTolerance);
  EXPECT_NEAR(ours["ate_max_m"], theirs["ate_max_m"], kTolerance);
  EXPECT_NEAR(ours["rpe_trans_rmse_m"], theirs["rpe1s_trans_rmse_m"], kTolerance);
  EXPECT_NEAR(ours["rpe_rot_rmse_deg"], theirs["rpe1s_rot_rmse_deg"], kTolerance);
  EXPECT_NEAR(ours["path_m"], theirs["path_m"], kTolerance);
}

}  // namespace
}  // namespace semantic_slam
