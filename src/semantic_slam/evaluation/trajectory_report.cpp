#include "semantic_slam/evaluation/trajectory_report.h"

#include <array>
#include <cstdio>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/evaluation/alignment.h"

namespace semantic_slam {
namespace {

using Json = nlohmann::ordered_json;
using Unit = RelativeInterval::Unit;

constexpr std::size_t kMinMatches = 3;  // fewer positions leave the alignment open

[[noreturn]] void ThrowTooFewMatches(const TrajectoryReport& report, const Trajectory& reference,
                                     const Trajectory& estimate,
                                     const AssociationOptions& options) {
  std::ostringstream what;
  what << "only " << report.matches.size() << " poses match within " << options.max_dt_s
       << " s, expected at least " << kMinMatches << "; the reference has " << reference.size()
       << " poses";
  const auto span = [&](const Trajectory& trajectory) {
    if (trajectory.empty()) return;
    what << " from " << ToString(trajectory.front().stamp) << " s to "
         << ToString(trajectory.back().stamp) << " s";
  };
  span(reference);
  what << ", the estimate " << estimate.size();
  span(estimate);
  throw InputError(what.str());
}

RelativeErrors ComputeRelativeErrors(const std::vector<MatchedPose>& matches,
                                     const RelativeInterval& interval) {
  return interval.unit == Unit::kSeconds ? RelativeErrorsOverTime(matches, interval.length)
                                         : RelativeErrorsOverPath(matches, interval.length);
}

void CheckInterval(const RelativeInterval& interval) {
  const bool is_time = interval.unit == Unit::kSeconds;
  CheckInRange(is_time ? "rpe_seconds" : "rpe_metres", interval.length, 1e-3, 1e6);
}

void AddStatistics(const std::string& prefix, const std::string& unit,
                   const ErrorStatistics& statistics, Json& json) {
  json[prefix + "_rmse_" + unit] = statistics.rmse;
  json[prefix + "_mean_" + unit] = statistics.mean;
  json[prefix + "_median_" + unit] = statistics.median;
  json[prefix + "_max_" + unit] = statistics.max;
}

void AddRelative(const TrajectoryReport& report, Json& json) {
  const bool over_path = report.interval.unit == Unit::kMetres;
  Json errors;
  if (over_path) {
    errors["rpe_percent"] = MeanTranslationPercent(report.relative);
    errors["rpe_deg_per_m"] = MeanRotationDegPerMetre(report.relative);
  }
  AddStatistics("rpe_trans", "m", Summarise(report.relative.translation_m), errors);
  AddStatistics("rpe_rot", "deg", Summarise(report.relative.rotation_deg), errors);

  json[over_path ? "rpe_metres" : "rpe_seconds"] = report.interval.length;
  json["rpe_pairs"] = report.relative.pairs();
  for (const auto& [key, value] : errors.items()) {
    json[key] = report.relative.pairs() > 0 ? value : Json(nullptr);
  }
}

template <typename... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

void PrintRow(const std::string& name, const ErrorStatistics& statistics, const char* unit,
              std::ostream& out) {
  out << Format("%-22s %10.4f %10.4f %10.4f %10.4f  %s\n", name.c_str(), statistics.rmse,
                statistics.mean, statistics.median, statistics.max, unit);
}

// In the table's column of means.
void PrintMean(const std::string& name, double mean, const char* unit, std::ostream& out) {
  out << Format("%-22s %21.4f %23s%s\n", name.c_str(), mean, "", unit);
}

void PrintRelative(const TrajectoryReport& report, std::ostream& out) {
  const bool over_path = report.interval.unit == Unit::kMetres;
  const std::string over = Format("RPE over %g %s", report.interval.length, over_path ? "m" : "s");
  if (report.relative.pairs() == 0) {
    out << over << ": no pair of matched poses is that far apart\n";
    return;
  }
  PrintRow(over, Summarise(report.relative.translation_m), "m", out);
  PrintRow("", Summarise(report.relative.rotation_deg), "deg", out);
  if (!over_path) return;
  PrintMean("  per length of path", MeanTranslationPercent(report.relative), "%", out);
  PrintMean("", MeanRotationDegPerMetre(report.relative), "deg/m", out);
}

}  // namespace

TrajectoryReport CompareTrajectories(const Trajectory& reference, const Trajectory& estimate,
                                     const AssociationOptions& options,
                                     const RelativeInterval& interval) {
  CheckInterval(interval);
  TrajectoryReport report;
  report.reference_poses = reference.size();
  report.estimate_poses = estimate.size();
  report.matches = AssociateTrajectories(reference, estimate, options);
  if (report.matches.size() < kMinMatches) {
    ThrowTooFewMatches(report, reference, estimate, options);
  }
  report.path_m = ReferencePathLength(report.matches);
  report.T_reference_estimate = AlignTrajectories(report.matches);
  report.absolute = ComputeAbsoluteErrors(report.matches, report.T_reference_estimate);
  report.interval = interval;
  report.relative = ComputeRelativeErrors(report.matches, interval);
  return report;
}

Json ToJson(const TrajectoryReport& report) {
  Json json;
  AddStatistics("ate", "m", Summarise(report.absolute.position_m), json);
  AddStatistics("ate", "deg", Summarise(report.absolute.rotation_deg), json);
  json["mean_deviation_xy_m"] = Summarise(report.absolute.deviation_xy_m).mean;
  json["mean_deviation_xz_m"] = Summarise(report.absolute.deviation_xz_m).mean;
  AddRelative(report, json);
  json["matched"] = report.matches.size();
  json["reference_poses"] = report.reference_poses;
  json["estimate_poses"] = report.estimate_poses;
  json["path_m"] = report.path_m;
  return json;
}

void PrintTable(const TrajectoryReport& report, std::ostream& out) {
  out << Format("%zu of %zu estimated poses matched with %zu reference poses, path %.3f m\n\n",
                report.matches.size(), report.estimate_poses, report.reference_poses, report.path_m)
      << Format("%-22s %10s %10s %10s %10s\n", "", "rmse", "mean", "median", "max");
  PrintRow("ATE", Summarise(report.absolute.position_m), "m", out);
  PrintRow("", Summarise(report.absolute.rotation_deg), "deg", out);
  PrintRow("deviation in X-Y", Summarise(report.absolute.deviation_xy_m), "m", out);
  PrintRow("deviation in X-Z", Summarise(report.absolute.deviation_xz_m), "m", out);
  PrintRelative(report, out);
}

}  // namespace semantic_slam
