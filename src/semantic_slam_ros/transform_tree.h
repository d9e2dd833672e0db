#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/evaluation/trajectory.h"

namespace semantic_slam_ros {

// All transforms of a recording at once. tf2's buffer keeps ten seconds and does not say which
// links move; this keeps everything and does. Frame names have no leading slash. Not thread-safe.
class TransformTree {
 public:
  // A transform between two frames, valid at `stamp`. The first parent that a frame gets is its
  // parent; links to another one are ignored.
  void Add(const std::string& parent, const std::string& child, semantic_slam::Stamp stamp,
           const semantic_slam::Rigid3d& T_parent_child);

  // The transform between two frames that nothing moves against each other; nullopt if a moving
  // link is between them, or none at all.
  std::optional<semantic_slam::Rigid3d> Fixed(const std::string& target,
                                              const std::string& source) const;

  // The path of `frame` in `root`: a pose T_root_frame for every stamp of the link on the way that
  // has the most of them; the others are interpolated, and fixed ones hold always. Empty if `root`
  // is not above `frame` or nothing between them moves.
  semantic_slam::Trajectory Path(const std::string& root, const std::string& frame) const;

 private:
  struct Link {
    std::string parent;
    std::map<semantic_slam::Stamp, semantic_slam::Rigid3d> samples;  // T_parent_child; not empty
    bool moves = false;
  };

  // From `frame` up to the top; `frame` itself is not a link.
  std::vector<const Link*> LinksAbove(const std::string& frame) const;
  static std::optional<semantic_slam::Rigid3d> At(const Link& link, semantic_slam::Stamp stamp);
  // Of links from a frame upwards; nullopt if one is not known at `stamp`.
  static std::optional<semantic_slam::Rigid3d> Product(const std::vector<const Link*>& links,
                                                       semantic_slam::Stamp stamp);

  std::map<std::string, Link> links_;  // by child
};

}  // namespace semantic_slam_ros
