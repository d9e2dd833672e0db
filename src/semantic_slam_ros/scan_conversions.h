#pragma once

#include <string>

#include <sensor_msgs/LaserScan.h>

#include "semantic_slam/scan/planar_scan.h"

namespace semantic_slam_ros {

// A planar scan by REP-117: the range of a hit, +infinity where a beam is free all the way to the
// maximum range, NaN where it is not known to be (free for a part of the way included: the message
// cannot say how far). `frame` is the scan's level frame, `min_range_m` what the scanner cannot see
// below.
sensor_msgs::LaserScan ToLaserScan(const semantic_slam::PlanarScan& scan, double min_range_m,
                                   const std::string& frame);

}  // namespace semantic_slam_ros
