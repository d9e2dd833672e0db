#pragma once

#include <string>
#include <vector>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"

namespace semantic_slam {

struct StampedPose {
  Stamp stamp;
  Rigid3d pose;  // T_world_sensor
};

// By ascending stamp.
using Trajectory = std::vector<StampedPose>;

// Reads TUM's format: "stamp tx ty tz qx qy qz qw" per line, seconds, metres and a quaternion of
// any length; '#' starts a comment, commas count as blanks. Stamps finer than a nanosecond or in
// scientific notation are rounded. Sorted by stamp; of equal stamps the file's order stays. Throws
// InputError naming file and line for anything else, for a number beyond 1e9, for a quaternion of
// zero length and for a file without a pose.
Trajectory ReadTumTrajectory(const std::string& path);

// Writes the same format with nine decimals and qw >= 0; the file is complete or absent. Throws
// InputError if it cannot be written.
void WriteTumTrajectory(const Trajectory& trajectory, const std::string& path);

}  // namespace semantic_slam
