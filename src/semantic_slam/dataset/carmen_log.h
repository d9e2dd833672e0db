#pragma once

#include <string>
#include <vector>

#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// What a laser scanner on a robot measured at one time.
struct LaserReading {
  Stamp stamp;
  Rigid2d T_odom_robot;         // by the wheels: drifts
  std::vector<float> ranges_m;  // from right to left over half a circle, evenly spaced
};

// Reads the FLASER lines of a CARMEN log, in the order of the file:
//
//   FLASER count range... x y theta odom_x odom_y odom_theta ipc_timestamp host logger_timestamp
//
// Lines of other sensors are passed over. Throws InputError naming the file if it cannot be read or
// has no such line, and the line too if that is anything else.
std::vector<LaserReading> ReadCarmenLog(const std::string& path);

}  // namespace semantic_slam
