#pragma once

#include <atomic>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/local_mapping/bundle_adjustment.h"
#include "semantic_slam/map/map.h"

namespace semantic_slam {

struct FullAdjusterOptions {
  double depth_sigma_at_1m_m = 0.02;  // of the depth sensor; grows with depth squared
  int max_keyframes = 400;            // with more, the pose graph must do
  int robust_iterations = 5;
  int final_iterations = 5;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("depth_sigma_at_1m_m", self.depth_sigma_at_1m_m, 1e-4, 1.0);
    visit("max_keyframes", self.max_keyframes, 0, 100000);
    visit("robust_iterations", self.robust_iterations, 0, 100);
    visit("final_iterations", self.final_iterations, 0, 100);
  }
};

// Bundle adjustment of the whole map after a loop was closed, thesis eq. (3.9). What it adjusts is
// a copy, so that tracking and mapping go on; what they add meanwhile moves with what it hangs on.
class FullAdjuster {
 public:
  // A copy of the map, to be solved at leisure.
  struct Work {
    BundleProblem problem;
    std::vector<KeyframeId> keyframes;  // parallel to problem.cameras
    std::vector<PointId> points;        // parallel to problem.points
    int map_id = 0;
  };

  // Throws ConfigError if an option is out of range.
  FullAdjuster(const FullAdjusterOptions& options, Map& map);

  // Empty if the map is too large. Holds the map's mutex.
  Work Copy() const;

  // Without a lock.
  void Solve(Work& work, const CameraModel& camera) const;

  // Does nothing if the map is another one by now. Holds the map's mutex; nobody else may change
  // poses meanwhile.
  void Apply(const Work& work);

 private:
  const FullAdjusterOptions options_;
  Map& map_;
};

}  // namespace semantic_slam
