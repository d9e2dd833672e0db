#pragma once

#include <memory>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/loop_closing/loop_detector.h"
#include "semantic_slam/loop_closing/pose_graph_3d.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

struct LoopCorrectorOptions {
  double depth_sigma_at_1m_m = 0.02;  // of the depth sensor; grows with depth squared
  int window_keyframes = 20;          // around the keyframe, joined with the place
  int min_joint_points = 30;          // that tie one of them to the place
  int min_covisible_points = 100;     // shared by keyframes that the pose graph ties together
  double translation_sigma_m = 0.02;  // of a relative pose
  double rotation_sigma_rad = 0.01;   // of a relative pose
  int max_iterations = 50;            // of the pose graph

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("depth_sigma_at_1m_m", self.depth_sigma_at_1m_m, 1e-4, 1.0);
    visit("window_keyframes", self.window_keyframes, 1, 200);
    visit("min_joint_points", self.min_joint_points, 6, 1000);
    visit("min_covisible_points", self.min_covisible_points, 1, 10000);
    visit("translation_sigma_m", self.translation_sigma_m, 1e-6, 10.0);
    visit("rotation_sigma_rad", self.rotation_sigma_rad, 1e-6, 10.0);
    visit("max_iterations", self.max_iterations, 1, 1000);
  }
};

// Closes a loop that was detected (if the place is in a dormant map, the present one is joined to
// it first): ties the keyframes around its end to the place where it began, spreads the error over
// the essential graph (spanning tree, strong covisibility and all loops so far; Mur-Artal et al.,
// ORB-SLAM, 2015, section VII), and makes points that are the same one. The map's mutex is held to
// copy from the map and to change it, not while the graph is solved; nobody else may change poses
// meanwhile, but keyframes may be added. For one thread.
class LoopCorrector {
 public:
  // Throws ConfigError if an option is out of range.
  LoopCorrector(const LoopCorrectorOptions& options, Map& map);

  // False, and nothing has changed, if the keyframes of the loop are gone.
  bool Correct(const Loop& loop, const CameraModel& camera);

 private:
  // A keyframe near the loop's end.
  struct Member {
    KeyframeId id;
    std::shared_ptr<const FrameFeatures> features;
    Rigid3d T_map_camera;         // where the place's points put it
    std::vector<PointId> points;  // per feature: the place's point; or kNoPoint
  };
  // All keyframes, as the pose graph sees them.
  struct Essential {
    PoseGraph3d graph;
    std::map<KeyframeId, int> index;

    // Does nothing if one of the keyframes is not among them.
    void Add(const LoopEdge& edge);
  };

  std::vector<Member> SelectWindow(const Loop& loop) const;
  void Join(const std::vector<MapPoint>& place_points, const CameraModel& camera,
            std::vector<Member>& window) const;
  Essential BuildEssentialGraph() const;
  static std::vector<LoopEdge> Tie(const std::vector<Member>& window, KeyframeId place,
                                   const Rigid3d& T_map_place);
  void MergePoints(const std::vector<Member>& window);

  const LoopCorrectorOptions options_;
  const ObservationNoise noise_;
  Map& map_;
};

}  // namespace semantic_slam
