#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/keyframe_poses.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/octree/anchored_clouds.h"
#include "semantic_slam/octree/map_rebuild.h"
#include "semantic_slam/octree/octree_inserter.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"
#include "semantic_slam/semantic_fusion/label_fusion.h"

namespace semantic_slam {

struct SemanticMapOptions {
  double resolution_m = 0.05;                // edge of the smallest voxel
  std::string transient_classes = "person";  // separated by commas: what is seen but not entered
  double rebuild_threshold_m =
      0.05;                      // the map is made anew when a keyframe's surroundings move farther
  double rebuild_reach_m = 3.0;  // where those surroundings end: turning moves them too
  // For the clouds that the map is made of. They are only read when it is made again.
  int max_clouds_on_disk_mb = 2048;   // 0: none goes to disk
  int max_clouds_in_memory_mb = 256;  // where there is no disk
  std::string scratch_folder;         // where on disk; empty: the system's for temporary files

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("resolution_m", self.resolution_m, 0.01, 1.0);
    visit("transient_classes", self.transient_classes);
    visit("rebuild_threshold_m", self.rebuild_threshold_m, 0.001, 10.0);
    visit("rebuild_reach_m", self.rebuild_reach_m, 0.0, 30.0);
    visit("max_clouds_on_disk_mb", self.max_clouds_on_disk_mb, 0, 1000000);
    visit("max_clouds_in_memory_mb", self.max_clouds_in_memory_mb, 1, 100000);
    visit("scratch_folder", self.scratch_folder);
  }
};

// The options of everything behind SemanticMapper, in the groups that configuration files use.
struct SemanticMapperOptions {
  SemanticMapOptions map;
  OctreeInserterOptions insertion;
  OccupancyOptions occupancy;
  LabelFusionOptions fusion;

  // Calls visit_group(name, group) for each.
  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("map", self.map);
    visit_group("insertion", self.insertion);
    visit_group("occupancy", self.occupancy);
    visit_group("fusion", self.fusion);
  }
};

// Thesis sections 3.3.3 and 3.3.4: the semantic octree of one map, made of clouds that are anchored
// to keyframes, so that it follows every correction of the camera's path. Deterministic. Not
// thread-safe.
//
// What moves by itself (`transient_classes`) is not entered: its points free the way to them, as
// the camera does look through there, but neither occupy their voxels nor label them. So where a
// person stood before they were recognised, or walks away, the next rays clear the map.
class SemanticMapper {
 public:
  struct Counts {
    std::size_t inserted = 0;  // clouds that became part of the map
    std::size_t unknown_keyframe =
        0;                        // dropped: no graph lists their keyframe, or it is of another map
    std::size_t not_tracked = 0;  // dropped: the camera was lost
    std::size_t lost_keyframe = 0;  // taken out of the map: a later graph puts their keyframe
                                    // outside of the octree, or the disk fails
    std::size_t rebuilds = 0;
  };

  // Throws ConfigError if an option is out of range, a range is more than 1000 voxels, or a
  // transient class is not in the vocabulary.
  SemanticMapper(const SemanticMapperOptions& options,
                 std::shared_ptr<const LabelVocabulary> vocabulary);

  // Enters a cloud at today's pose of its image: T_map_keyframe as the latest graph has it, and
  // T_keyframe_camera of `image`. Returns whether it became part of the map; if not, `counts` say
  // why. Throws InputError, and changes nothing, if the cloud does not pass CheckSemanticCloud(),
  // is not of this image, or was seen from outside of the octree.
  bool Insert(const SemanticCloud& cloud, const TrackedImage& image);

  // Takes over where the keyframes are now. A reset, or a revision or map_id that goes back
  // (tracking was started anew), forgets everything: returns whether it did and there was
  // something. Throws InputError, and changes nothing, if a pose is not finite.
  bool TakeOver(const KeyframeGraph& graph);

  // Whether the map should be made again: the surroundings of some keyframe have moved farther than
  // the threshold since they were entered, or clouds can come back. Clouds whose keyframe the graph
  // does not list, because tracking was lost and began another map, are kept and come back with it.
  bool NeedsRebuild() const { return HasMoved() || ComesBack() || is_on_base_ != BelongsToBase(); }

  // Begins to make the whole map again; the map stays as it is, and clouds may go on being entered,
  // until FinishRebuild(). One at a time.
  std::unique_ptr<MapRebuild> BeginRebuild();

  // Puts what was rebuilt in the map's place, if no cloud has come in since its last Run(); else
  // hands it those clouds and returns false, to be run again. What was begun before a reset is
  // thrown away.
  bool FinishRebuild(MapRebuild& rebuild);

  // All of it at once. Returns whether the map was made anew or emptied.
  bool FollowGraph(const KeyframeGraph& graph);

  // Forgets the map, but not where the keyframes are.
  void Reset();

  // Goes on from a map that was there before, in place of what there is; it stays where it is when
  // the camera's path is corrected. Throws InputError, and changes nothing, if its voxels are of
  // another size.
  void Load(std::unique_ptr<SemanticOcTree> tree);

  // Makes what is occupied in the box free; see ClearBox(). What is seen there later counts again.
  // Returns how many voxels there were.
  std::size_t Clear(const Eigen::AlignedBox3d& box_m);

  // Where the camera was at the clouds that are kept, in the order in which they came.
  std::vector<Eigen::Vector3d> CameraPath() const;

  const SemanticOcTree& tree() const { return *tree_; }
  const LabelVocabulary& vocabulary() const { return *vocabulary_; }
  int map_id() const { return poses_.map_id(); }
  std::uint64_t revision() const { return poses_.revision(); }
  Stamp stamp() const { return stamp_; }  // of the newest image in the map
  const Counts& counts() const { return counts_; }
  const AnchoredClouds& clouds() const { return clouds_; }

  // Grows whenever the tree has changed.
  std::uint64_t version() const { return version_; }

 private:
  std::unique_ptr<SemanticOcTree> EmptyTree() const;
  void Keep(const CloudAnchor& anchor, const std::vector<VoxelObservation>& observations);
  bool HasMoved() const;
  bool ComesBack() const;
  bool BelongsToBase() const {
    return base_->getRoot() != nullptr && poses_.map_id() == base_map_id_;
  }

  const SemanticMapperOptions options_;
  const std::shared_ptr<const LabelVocabulary> vocabulary_;
  const LabelMask transient_;
  OctreeInserter inserter_;
  std::unique_ptr<SemanticOcTree> tree_;
  AnchoredClouds clouds_;
  std::shared_ptr<const SemanticOcTree> base_;  // that all clouds came after: empty, or loaded
  int base_map_id_ = 0;
  bool is_on_base_ = false;  // whether the tree is
  std::vector<ClearedBox> cleared_;
  KeyframePoses poses_;
  std::map<KeyframeId, Rigid3d> entered_poses_;  // T_map_keyframe when its first cloud was entered
  std::set<KeyframeId> unlisted_;                // of clouds that are not in the tree
  AnchoredClouds::Clouds came_meanwhile_;        // since a rebuild began or was last run
  std::vector<ClearedBox> cleared_meanwhile_;    // the same
  const MapRebuild* rebuild_ = nullptr;          // the one that was begun; null: none
  Stamp stamp_;
  Counts counts_;
  std::uint64_t version_ = 0;
};

}  // namespace semantic_slam
