// 2D SLAM on a laser log.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <string>
#include <vector>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/check.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/dataset/carmen_log.h"
#include "semantic_slam/submaps/occupancy_map_file.h"
#include "semantic_slam/submaps/planar_slam.h"
#include "tools/command_line.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Runs 2D SLAM on the FLASER lines of a CARMEN log and leaves in DIR: trajectory.txt (stamp x "
    "y\n"
    "theta), grid.pgm and grid.yaml (for map_server), timing.csv. The scanner is taken to sit at "
    "the\n"
    "robot's centre. Loops are not closed in this version. The same bytes on every run (but for\n"
    "timing.csv).";

constexpr float kNearestM = 0.1f;  // nearer readings are the robot's own or faults

// Wheels are worse than a camera: a wider window than for depth images, and beams that reach
// farther.
GridSlamOptions LaserOptions() {
  GridSlamOptions options;
  options.scan_matcher.min_score = 0.2;
  options.correlative_matcher.linear_window_m = 0.3;
  options.correlative_matcher.angular_window_deg = 20.0;
  options.correlative_matcher.translation_sigma_m = 0.15;
  options.correlative_matcher.rotation_sigma_deg = 6.0;
  options.submaps.max_distance_m = 20.0;
  options.grid_mapper.min_motion_m = 0.1;
  options.grid_mapper.max_distance_m = 1000.0;
  return options;
}

// Scanners with an odd number of beams look to both sides, those with an even one leave out the
// last direction. A reading beyond the maximum range is not known to be free: it may be a black or
// a mirroring thing.
PlanarScan ToPlanarScan(const LaserReading& reading, double max_range_m) {
  const std::size_t count = reading.ranges_m.size();
  PlanarScan scan;
  scan.stamp = reading.stamp;
  scan.first_bearing_rad = -M_PI / 2;
  scan.bearing_step_rad = count > 1 ? M_PI / static_cast<double>(count - count % 2) : 0.0;
  scan.max_range_m = max_range_m;
  for (const float range_m : reading.ranges_m) {
    ScanBeam beam;
    if (range_m > kNearestM && range_m < static_cast<float>(max_range_m)) {
      beam.hit_m = beam.free_to_m = range_m;
    }
    scan.beams.push_back(beam);
  }
  return scan;
}

struct PlanarPose {
  Stamp stamp;
  Rigid2d T_map_robot;
};

void WriteTrajectory(const std::vector<PlanarPose>& trajectory, std::ostream& out) {
  out << "# stamp x y theta\n" << std::fixed;
  out.precision(6);
  for (const PlanarPose& pose : trajectory) {
    const Eigen::Vector2d p = pose.T_map_robot.translation();
    out << ToString(pose.stamp) << ' ' << p.x() << ' ' << p.y() << ' ' << Yaw(pose.T_map_robot)
        << '\n';
  }
}

int CarmenReplay(CommandLine& command_line) {
  std::string log, folder;
  double max_range_m = 30.0;
  command_line.Argument("LOG", &log, "the CARMEN log");
  command_line.RequiredOption("out", "DIR", &folder, "folder for the results");
  command_line.Option("max-range", "M", &max_range_m, "readings of M metres and more are none");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  CheckInRange("--max-range", max_range_m, 1.0, 100.0);

  const std::vector<LaserReading> readings = ReadCarmenLog(log);
  PlanarSlam slam(LaserOptions());
  StageTimer timer;
  std::vector<PlanarPose> trajectory;
  ProgressBar progress("mapping", readings.size());
  for (const LaserReading& reading : readings) {
    StageTimer::Scope scope(timer, "scan");
    const PlanarScan scan = ToPlanarScan(reading, max_range_m);
    trajectory.push_back({reading.stamp, slam.Add(scan, reading.T_odom_robot)});
    progress.Update(trajectory.size());
  }
  const std::filesystem::path out(folder);
  WriteFileAtomically(out / "trajectory.txt",
                      [&](std::ostream& file) { WriteTrajectory(trajectory, file); });
  WriteOccupancyMap(folder, slam.Render());
  WriteFileAtomically(out / "timing.csv",
                      [&](std::ostream& file) { WriteTimingCsv(timer.Timings(), file); });
  std::cout << trajectory.size() << " scans, " << slam.submaps() << " submaps; results in "
            << folder << '\n';
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::CarmenReplay);
}
