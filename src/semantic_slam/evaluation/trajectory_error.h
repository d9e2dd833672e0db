#pragma once

#include <cstddef>
#include <vector>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/evaluation/association.h"

// The errors of a trajectory, thesis section 4.1.3, with two corrections that make them independent
// of where the origin is and equal to those of the TUM RGB-D tools (Sturm et al., IROS 2012):
// Delta p = p - p' and delta X = (X_s^-1 X_e)^-1 (X'_s^-1 X'_e), where X is the reference and X'
// the estimate. Means are over all matched poses.

namespace semantic_slam {

// In the unit of what it summarises.
struct ErrorStatistics {
  double rmse = 0.0;
  double mean = 0.0;
  double median = 0.0;  // of an even number: the mean of the two in the middle
  double max = 0.0;
};

// All zero if there are no errors to summarise.
ErrorStatistics Summarise(std::vector<double> errors);

// One of each per match, in the order of the matches, after alignment.
struct AbsoluteErrors {
  std::vector<double> position_m;      // |Delta p|, eq. (4.3)
  std::vector<double> rotation_deg;    // angle of Delta R, eq. (4.3)
  std::vector<double> deviation_xy_m;  // |Delta p| seen along z of the reference frame, Fig. 4.2
  std::vector<double> deviation_xz_m;  // |Delta p| seen along y, Fig. 4.3
};

AbsoluteErrors ComputeAbsoluteErrors(const std::vector<MatchedPose>& matches,
                                     const Rigid3d& T_reference_estimate);

// The sets RE_pos and RE_rot of eq. (4.6), one of each per pair of poses. No alignment is needed.
struct RelativeErrors {
  std::vector<double> translation_m;
  std::vector<double> rotation_deg;
  std::vector<double> path_m;  // length of the reference between the two poses

  std::size_t pairs() const { return translation_m.size(); }
};

// From every pose to the one whose stamp is nearest to `interval_s` later, if one is within 0.1 s
// of that. Needs interval_s > 0.
RelativeErrors RelativeErrorsOverTime(const std::vector<MatchedPose>& matches, double interval_s);

// From every pose to the first that is at least `segment_m` of the reference's path later (thesis
// Fig. 4.4; Geiger et al., CVPR 2012). Needs segment_m > 0.
RelativeErrors RelativeErrorsOverPath(const std::vector<MatchedPose>& matches, double segment_m);

// Mean error per length of path, each pair by its own; 0 without pairs. For RelativeErrorsOverPath:
// a sensor that stands still has no path to divide by.
double MeanTranslationPercent(const RelativeErrors& errors);
double MeanRotationDegPerMetre(const RelativeErrors& errors);

// Length [m] of the reference through the matched poses.
double ReferencePathLength(const std::vector<MatchedPose>& matches);

}  // namespace semantic_slam
