#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/evaluation/trajectory_report.h"

namespace semantic_slam {

// Draw one figure, BGR: the path seen from above (X-Y, thesis Fig. 4.2) and from the side (X-Z,
// Fig. 4.3) in metres, x and y (z) at one scale, and below them a curve over time. Lines break
// where poses are missing.

// With a reference: the estimate aligned to it, and the position error over time. `report` must
// come from the same two trajectories.
cv::Mat PlotComparison(const Trajectory& reference, const Trajectory& estimate,
                       const TrajectoryReport& report);

// Without one: the estimate in its own frame, and x, y, z over time. Needs at least one pose.
cv::Mat PlotTrajectory(const Trajectory& estimate);

// Throws ConfigError unless `path` ends in ".png".
void CheckPlotPath(const std::string& path);

// Writes a PNG; the file is complete or absent. Throws ConfigError as above, InputError if it
// cannot be written.
void WritePlot(const cv::Mat& plot, const std::string& path);

}  // namespace semantic_slam
