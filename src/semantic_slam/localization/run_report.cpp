#include "semantic_slam/localization/run_report.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/evaluation/trajectory_plot.h"
#include "semantic_slam/evaluation/trajectory_report.h"

namespace semantic_slam {
namespace {

using Json = nlohmann::ordered_json;

Json TimingsJson(const std::vector<StageTiming>& timings) {
  Json json = Json::object();
  for (const StageTiming& timing : timings) {
    json[timing.stage] = {
        {"count", timing.count}, {"median_ms", timing.median_ms}, {"p95_ms", timing.p95_ms}};
  }
  return json;
}

// Tracking's and those of the stages behind it.
std::vector<StageTiming> AllTimings(const VisualLocalization& localization, const RunFacts& facts) {
  std::vector<StageTiming> timings = localization.timings();
  timings.insert(timings.end(), facts.stage_timings.begin(), facts.stage_timings.end());
  return timings;
}

Json SummaryJson(const TrajectoryRecorder& recorder, const VisualLocalization& localization,
                 const KeyframeGraph& graph, const RunFacts& facts) {
  Json json;
  json["source"] = facts.source;
  json["images"] = recorder.images();
  json["tracked"] = recorder.tracked();
  json["lost"] = recorder.lost();
  json["keyframes"] = KeyframeTrajectory(graph).size();
  json["keyframes_culled"] = graph.keyframes.size() - KeyframeTrajectory(graph).size();
  json["keyframes_rejected"] = localization.rejected_keyframes();
  json["map_points"] = localization.map_points().size();
  json["loops"] = localization.closed_loops();
  json["gravity"] = facts.gravity;
  json["dropped"] = Json::object();
  for (const auto& [cause, count] : facts.dropped) json["dropped"][cause] = count;
  for (const auto& [stage, counts] : facts.stages) json[stage] = counts;
  if (facts.live) json["live"] = LiveJson(*facts.live, recorder.images());
  if (facts.timings_in_summary) json["stages"] = TimingsJson(AllTimings(localization, facts));
  return json;
}

// Errors against the ground truth into `summary`, and the picture of the trajectory.
void Compare(const Trajectory& ground_truth, const Trajectory& estimate, Json& summary,
             const std::string& plot_path) {
  if (ground_truth.empty()) {
    WritePlot(PlotTrajectory(estimate), plot_path);
    return;
  }
  try {
    const TrajectoryReport report =
        CompareTrajectories(ground_truth, estimate, AssociationOptions(), RelativeInterval());
    summary["trajectory_error"] = ToJson(report);
    WritePlot(PlotComparison(ground_truth, estimate, report), plot_path);
  } catch (const InputError& e) {  // too few poses match: a result worth telling, not a failure
    summary["trajectory_error"] = e.what();
    WritePlot(PlotTrajectory(estimate), plot_path);
  }
}

}  // namespace

void WriteRunReport(const std::string& folder, const TrajectoryRecorder& recorder,
                    const VisualLocalization& localization, const RunFacts& facts,
                    const Trajectory& ground_truth) {
  const std::filesystem::path out(folder);
  const KeyframeGraph graph = localization.keyframe_graph();
  const Trajectory corrected = recorder.Corrected(graph);
  WriteTumTrajectory(corrected, out / "trajectory.txt");
  WriteTumTrajectory(recorder.live(), out / "trajectory_live.txt");
  WriteTumTrajectory(KeyframeTrajectory(graph), out / "keyframe_trajectory.txt");
  WriteFileAtomically(out / "timing.csv", [&](std::ostream& file) {
    WriteTimingCsv(AllTimings(localization, facts), file);
  });
  if (facts.live) WriteDelays(facts.live->delays, out / "delays.csv");
  Json summary = SummaryJson(recorder, localization, graph, facts);
  if (!corrected.empty()) Compare(ground_truth, corrected, summary, out / "trajectory.png");
  WriteFileAtomically(out / "summary.json",
                      [&](std::ostream& file) { file << summary.dump(2) << '\n'; });
}

}  // namespace semantic_slam
