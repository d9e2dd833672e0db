#include "semantic_slam_ros/scan_conversions.h"

#include <limits>

#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

using semantic_slam::BeamStatus;
using semantic_slam::PlanarScan;
using semantic_slam::ScanBeam;

namespace {

float ToRange(const ScanBeam& beam, double max_range_m) {
  if (beam.status() == BeamStatus::kHit) return beam.hit_m;
  const bool is_free_all_the_way = beam.status() == BeamStatus::kFree && beam.free_from_m == 0.0f &&
                                   beam.free_to_m >= static_cast<float>(max_range_m);
  using Limits = std::numeric_limits<float>;
  return is_free_all_the_way ? Limits::infinity() : Limits::quiet_NaN();
}

}  // namespace

sensor_msgs::LaserScan ToLaserScan(const PlanarScan& scan, double min_range_m,
                                   const std::string& frame) {
  sensor_msgs::LaserScan msg;
  msg.header = MakeHeader(scan.stamp, frame);
  const double span_rad =
      scan.beams.empty() ? 0.0 : scan.bearing_step_rad * static_cast<double>(scan.beams.size() - 1);
  msg.angle_min = static_cast<float>(scan.first_bearing_rad);
  msg.angle_max = static_cast<float>(scan.first_bearing_rad + span_rad);
  msg.angle_increment = static_cast<float>(scan.bearing_step_rad);
  msg.range_min = static_cast<float>(min_range_m);
  msg.range_max = static_cast<float>(scan.max_range_m);
  msg.ranges.reserve(scan.beams.size());
  for (const ScanBeam& beam : scan.beams) msg.ranges.push_back(ToRange(beam, scan.max_range_m));
  return msg;
}

}  // namespace semantic_slam_ros
