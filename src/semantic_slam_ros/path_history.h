#pragma once

#include <cstddef>
#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/evaluation/trajectory.h"

namespace semantic_slam_ros {

// The way the robot has come, for people to look at: follows the corrections of the map, and stays
// small on long runs by keeping only every second, fourth, eighth... image. Not thread-safe.
class PathHistory {
 public:
  // Keeps at most `max_poses`, and at least half of them once there were so many.
  explicit PathHistory(std::size_t max_poses);

  // Images that were not tracked are left out.
  void Add(const semantic_slam::TrackedImage& image, const semantic_slam::Rigid3d& T_camera_base);

  // T_map_base at each image kept, with today's keyframe poses. Images of keyframes that are not in
  // the graph, as those of other maps, are left out.
  semantic_slam::Trajectory Poses(const semantic_slam::KeyframeGraph& graph) const;

 private:
  struct Entry {
    semantic_slam::Stamp stamp;
    semantic_slam::KeyframeId keyframe_id;
    semantic_slam::Rigid3d T_keyframe_base;
  };

  void DropEverySecond();

  const std::size_t max_poses_;
  std::vector<Entry> entries_;
  std::size_t stride_ = 1;  // of how many images one is kept
  std::size_t skipped_ = 0;
};

}  // namespace semantic_slam_ros
