#include "semantic_slam/scan/planar_scan.h"

namespace semantic_slam {

PlanarPoints HitPoints(const PlanarScan& scan) {
  PlanarPoints points;
  for (std::size_t i = 0; i < scan.beams.size(); ++i) {
    const ScanBeam& beam = scan.beams[i];
    if (beam.status() == BeamStatus::kHit) points.push_back(beam.hit_m * scan.Direction(i));
  }
  return points;
}

}  // namespace semantic_slam
