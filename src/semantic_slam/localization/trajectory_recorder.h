#pragma once

#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/evaluation/trajectory.h"

namespace semantic_slam {

// Remembers every tracked image relative to its reference keyframe, so that the whole trajectory
// can be told again after the map has been corrected. 100 bytes an image. Not thread-safe.
class TrajectoryRecorder {
 public:
  // Images that were not tracked are counted, not kept.
  void Add(const TrackedImage& image);

  // Poses of the optical frame in the map as they were at each image: "trajectory_live".
  const Trajectory& live() const { return live_; }

  // The same images with today's keyframe poses: "trajectory". Images of other maps, that were not
  // joined to the graph's, are left out.
  Trajectory Corrected(const KeyframeGraph& graph) const;

  std::size_t images() const { return images_; }
  std::size_t tracked() const { return live_.size(); }
  std::size_t lost() const { return lost_; }

 private:
  struct Entry {
    KeyframeId keyframe_id;
    Rigid3d T_keyframe_camera;
  };
  Trajectory live_;
  std::vector<Entry> entries_;  // parallel to live_
  std::size_t images_ = 0;
  std::size_t lost_ = 0;
};

// Poses of the keyframes that were not culled.
Trajectory KeyframeTrajectory(const KeyframeGraph& graph);

}  // namespace semantic_slam
