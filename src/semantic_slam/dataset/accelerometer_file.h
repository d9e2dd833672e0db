#pragma once

#include <string>
#include <vector>

#include "semantic_slam/dataset/rgbd_source.h"

namespace semantic_slam {

// Reads TUM's accelerometer.txt: "stamp ax ay az" per line, in m/s^2 and the sensor's own axes.
// Sorted by stamp. Throws InputError naming file and line for anything else.
std::vector<AccelerometerReading> ReadAccelerometerFile(const std::string& path);

}  // namespace semantic_slam
