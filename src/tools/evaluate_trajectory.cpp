// Scores an estimated trajectory against a reference: thesis section 4.1.3.

#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/evaluation/trajectory_plot.h"
#include "semantic_slam/evaluation/trajectory_report.h"
#include "tools/command_line.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Scores an estimated trajectory against a reference: absolute trajectory error (ATE) after\n"
    "alignment by a rigid motion without scale, relative pose error (RPE) over time or over path\n"
    "segments. Poses match by stamp, one to one, nearest first. Both files are in TUM's format,\n"
    "\"stamp tx ty tz qx qy qz qw\" per line.";

struct Arguments {
  std::string reference;
  std::string estimate;
  AssociationOptions association;
  std::optional<double> rpe_seconds;
  std::optional<double> rpe_metres;
  std::optional<std::string> plot;
  bool json = false;
};

// nullopt after printing the help.
std::optional<Arguments> ParseArguments(CommandLine& command_line) {
  Arguments arguments;
  command_line.Argument("REFERENCE", &arguments.reference, "ground truth");
  command_line.Argument("ESTIMATE", &arguments.estimate, "what to score");
  command_line.Option("rpe-seconds", "S", &arguments.rpe_seconds,
                      "RPE over pairs of poses S seconds apart (the default, S = 1)");
  command_line.Option("rpe-metres", "M", &arguments.rpe_metres,
                      "RPE over path segments of M metres, also in % and deg/m");
  command_line.Option("max-dt", "S", &arguments.association.max_dt_s,
                      "stamps match up to this difference [s]");
  command_line.Option("offset", "S", &arguments.association.offset_s,
                      "added to the estimate's stamps [s]");
  command_line.Option("plot", "FILE.png", &arguments.plot,
                      "draw both paths from above and from the side, and the error over time");
  command_line.Flag("json", &arguments.json, "print JSON instead of a table");
  if (!command_line.Parse()) return std::nullopt;
  CheckInRange("--max-dt", arguments.association.max_dt_s, 0.0, 10.0);
  CheckInRange("--offset", arguments.association.offset_s, -1e10, 1e10);
  return arguments;
}

RelativeInterval Interval(const Arguments& arguments) {
  if (arguments.rpe_seconds && arguments.rpe_metres) {
    throw ConfigError("--rpe-seconds and --rpe-metres exclude each other; give one of them");
  }
  if (arguments.rpe_metres) {
    CheckInRange("--rpe-metres", *arguments.rpe_metres, 1e-3, 1e6);
    return {RelativeInterval::Unit::kMetres, *arguments.rpe_metres};
  }
  const double seconds = arguments.rpe_seconds.value_or(RelativeInterval().length);
  CheckInRange("--rpe-seconds", seconds, 1e-3, 1e6);
  return {RelativeInterval::Unit::kSeconds, seconds};
}

int EvaluateTrajectory(CommandLine& command_line) {
  const std::optional<Arguments> arguments = ParseArguments(command_line);
  if (!arguments) return EXIT_SUCCESS;
  const RelativeInterval interval = Interval(*arguments);
  if (arguments->plot) CheckPlotPath(*arguments->plot);

  const Trajectory reference = ReadTumTrajectory(arguments->reference);
  const Trajectory estimate = ReadTumTrajectory(arguments->estimate);
  const TrajectoryReport report =
      CompareTrajectories(reference, estimate, arguments->association, interval);
  if (arguments->plot) {
    WritePlot(PlotComparison(reference, estimate, report), *arguments->plot);
  }
  if (arguments->json) {
    std::cout << ToJson(report).dump(2) << "\n";
  } else {
    PrintTable(report, std::cout);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::EvaluateTrajectory);
}
