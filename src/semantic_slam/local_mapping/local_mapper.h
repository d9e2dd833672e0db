#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/local_mapping/bundle_adjustment.h"
#include "semantic_slam/local_mapping/triangulation.h"
#include "semantic_slam/map/map.h"

namespace semantic_slam {

struct LocalMapperOptions {
  double depth_sigma_at_1m_m = 0.02;  // of the depth sensor; grows with depth squared
  int window_keyframes = 15;          // moved by one bundle adjustment
  int fixed_keyframes = 25;           // that hold it in place
  int robust_iterations = 3;
  int final_iterations = 4;
  int fusion_neighbours = 10;   // keyframes whose points are merged with the new one's
  int probation_keyframes = 8;  // after the one that made a point, until it must have proved right
  double min_found_ratio = 0.25;   // points on probation matched less often than this are mistakes
  int min_point_keyframes = 3;     // that see a point after its probation; else it goes
  double redundant_share = 0.9;    // a keyframe goes when this share of its points is seen well
  int redundant_observations = 3;  // by at least that many others
  TriangulationOptions triangulation;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("depth_sigma_at_1m_m", self.depth_sigma_at_1m_m, 1e-4, 1.0);
    visit("window_keyframes", self.window_keyframes, 2, 200);
    visit("fixed_keyframes", self.fixed_keyframes, 1, 500);
    visit("robust_iterations", self.robust_iterations, 0, 100);
    visit("final_iterations", self.final_iterations, 0, 100);
    visit("fusion_neighbours", self.fusion_neighbours, 0, 100);
    visit("probation_keyframes", self.probation_keyframes, 1, 1000);
    visit("min_found_ratio", self.min_found_ratio, 0.0, 1.0);
    visit("min_point_keyframes", self.min_point_keyframes, 2, 100);
    visit("redundant_share", self.redundant_share, 0.1, 1.0);
    visit("redundant_observations", self.redundant_observations, 1, 100);
  }
  // As configuration files have them.
  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("local_mapping", self);
    visit_group("triangulation", self.triangulation);
  }
};

// Thesis section 3.2, Local Mapping: keeps the map around the newest keyframe small and accurate.
// For one thread; it holds the map's mutex while it works on the map, and not while it solves.
class LocalMapper {
 public:
  // Throws ConfigError if an option is out of range.
  LocalMapper(const LocalMapperOptions& options, std::shared_ptr<const CameraModel> camera,
              Map& map);

  // Works a keyframe off: erases points that proved wrong, makes those that it takes two views for,
  // merges points seen twice, adjusts the keyframes around it and their points, and culls keyframes
  // that add nothing. Does nothing if the keyframe is gone. `timer` gets the stages' durations.
  void Process(KeyframeId keyframe, StageTimer& timer);

  // Keyframes to come are of `camera`.
  void Reset(std::shared_ptr<const CameraModel> camera);

 private:
  struct Window {
    BundleProblem problem;
    std::vector<KeyframeId> keyframes;  // parallel to problem.cameras
    std::vector<PointId> points;        // parallel to problem.points
  };

  void CullYoungPoints(KeyframeId newest);
  void CullPoint(PointId id, KeyframeId newest);
  void FuseWithNeighbours(KeyframeId keyframe);
  Window SelectWindow(KeyframeId keyframe) const;
  void Apply(const Window& window, const BundleSummary& summary);
  void CullKeyframes(KeyframeId keyframe);
  bool IsRedundant(const Keyframe& keyframe) const;

  const LocalMapperOptions options_;
  const ObservationNoise noise_;
  std::shared_ptr<const CameraModel> camera_;
  Map& map_;
};

}  // namespace semantic_slam
