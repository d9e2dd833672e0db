#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "semantic_slam/evaluation/association.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/evaluation/trajectory_error.h"

namespace semantic_slam {

// What a relative error is taken over.
struct RelativeInterval {
  enum class Unit { kSeconds, kMetres };
  Unit unit = Unit::kSeconds;
  double length = 1.0;  // more than 0
};

// Everything there is to say about an estimate that has a reference.
struct TrajectoryReport {
  std::size_t reference_poses = 0;
  std::size_t estimate_poses = 0;
  std::vector<MatchedPose> matches;
  double path_m = 0.0;  // of the reference through the matches
  Rigid3d T_reference_estimate = Rigid3d::Identity();
  AbsoluteErrors absolute;
  RelativeInterval interval;
  RelativeErrors relative;  // empty if the matches do not last an interval
};

// Associates, aligns and compares. Throws InputError if fewer than three poses match, ConfigError
// if an option or the interval's length is out of range.
TrajectoryReport CompareTrajectories(const Trajectory& reference, const Trajectory& estimate,
                                     const AssociationOptions& options,
                                     const RelativeInterval& interval);

// Keys end in their unit: ate_rmse_m, ate_rmse_deg, rpe_trans_rmse_m, rpe_rot_rmse_deg or, over
// path segments, rpe_percent, rpe_deg_per_m (means), ... Relative errors without a pair are null.
nlohmann::ordered_json ToJson(const TrajectoryReport& report);

// The same as a small table for people.
void PrintTable(const TrajectoryReport& report, std::ostream& out);

}  // namespace semantic_slam
