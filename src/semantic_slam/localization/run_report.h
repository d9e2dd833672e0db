#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/localization/live_report.h"
#include "semantic_slam/localization/trajectory_recorder.h"
#include "semantic_slam/localization/visual_localization.h"

namespace semantic_slam {

// What the caller knows of a run that localization itself does not.
struct RunFacts {
  std::string source;   // what was played: a folder, a bag, topics
  std::string gravity;  // where "up" came from, see MapStart
  std::map<std::string, std::size_t> dropped;  // images that never reached tracking, by cause
  // What the stages behind tracking count, by stage and thing, and how long they took.
  std::map<std::string, std::map<std::string, std::size_t>> stages;
  std::vector<StageTiming> stage_timings;
  // Durations go into timing.csv always. They differ from run to run, so summary.json holds them
  // only where it need not be reproducible.
  bool timings_in_summary = true;
  std::optional<LiveFacts> live;  // of a recording that was played at the sensor's rate
};

// Leaves a run's results in `folder`: trajectory.txt (corrected), trajectory_live.txt (as published),
// keyframe_trajectory.txt, timing.csv, summary.json, and with live facts delays.csv. Each file is complete or absent. Throws
// InputError naming a file that cannot be written.
//
// With `ground_truth` not empty the summary also has the trajectory's errors, and trajectory.png
// shows both; else it shows the estimate alone.
void WriteRunReport(const std::string& folder, const TrajectoryRecorder& recorder,
                    const VisualLocalization& localization, const RunFacts& facts,
                    const Trajectory& ground_truth = {});

}  // namespace semantic_slam
