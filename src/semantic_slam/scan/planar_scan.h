#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

enum class BeamStatus : std::uint8_t { kUnknown, kFree, kHit };

// What is known along one direction. Ranges are horizontal distances [m].
struct ScanBeam {
  float hit_m = std::numeric_limits<float>::quiet_NaN();  // the nearest thing; NaN if none was seen
  float free_from_m = 0.0f;                               // seen free from here
  float free_to_m = 0.0f;  // to here, never beyond the hit; not beyond free_from_m: nowhere

  BeamStatus status() const {
    if (std::isfinite(hit_m)) return BeamStatus::kHit;
    return free_to_m > free_from_m ? BeamStatus::kFree : BeamStatus::kUnknown;
  }
};

// One look around in a plane. Its frame is level: z up, x ahead, the sensor at the origin. For a
// camera that is LevelPose() at the image's stamp.
struct PlanarScan {
  Stamp stamp;
  double first_bearing_rad = 0.0;  // of beams[0], from x towards y
  double bearing_step_rad = 0.0;   // the beams are evenly spaced
  double max_range_m = 0.0;        // nothing is known beyond
  std::vector<ScanBeam> beams;

  Eigen::Vector2d Direction(std::size_t beam) const {
    const double bearing_rad = first_bearing_rad + static_cast<double>(beam) * bearing_step_rad;
    return {std::cos(bearing_rad), std::sin(bearing_rad)};
  }
};

using PlanarPoints = std::vector<Eigen::Vector2d>;

// Where the beams hit, in the scan's frame [m], by ascending bearing.
PlanarPoints HitPoints(const PlanarScan& scan);

}  // namespace semantic_slam
