#pragma once

#include <vector>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/evaluation/trajectory.h"

namespace semantic_slam {

struct AssociationOptions {
  double max_dt_s = 0.02;  // stamps farther apart than this do not match
  double offset_s = 0.0;   // added to the estimate's stamps before they are compared

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_dt_s", self.max_dt_s, 0.0, 10.0);
    visit("offset_s", self.offset_s, -1e10, 1e10);
  }
};

// The same instant in both trajectories. "reference" and "estimate" are the two world frames.
struct MatchedPose {
  Stamp stamp;  // the estimate's, without offset
  Rigid3d T_reference_sensor = Rigid3d::Identity();
  Rigid3d T_estimate_sensor = Rigid3d::Identity();
};

// Seconds since the epoch, rounded once: the number that a program reads from a file that has this
// stamp in it. Results must agree with the usual Python tools, also where two stamps are equally
// near or exactly max_dt_s away, so the evaluation counts time as they do.
double RoundedSeconds(Stamp stamp);

// Pairs every estimated pose with at most one reference pose and vice versa, nearest stamps first,
// as associate.py of the TUM RGB-D benchmark does (Sturm et al., IROS 2012); of equally near ones
// the earlier. By ascending stamp of the estimate. Throws ConfigError if an option is out of range.
std::vector<MatchedPose> AssociateTrajectories(const Trajectory& reference,
                                               const Trajectory& estimate,
                                               const AssociationOptions& options);

}  // namespace semantic_slam
