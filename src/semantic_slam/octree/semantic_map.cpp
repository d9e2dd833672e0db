#include "semantic_slam/octree/semantic_map.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam/octree/clear_box.h"
#include "semantic_slam/semantic_cloud/check_cloud.h"

namespace semantic_slam {
namespace {

constexpr std::size_t kMegabyte = 1 << 20;

LabelMask MaskOf(const std::string& names, const LabelVocabulary& vocabulary) {
  LabelMask mask;
  for (const LabelId label : FindLabels("transient_classes", names, vocabulary)) mask.set(label);
  return mask;
}

void CheckPoses(const KeyframeGraph& graph) {
  for (const KeyframeNode& node : graph.keyframes) {
    if (IsFinite(node.T_map_keyframe)) continue;
    throw InputError("keyframe graph: the pose of keyframe " + std::to_string(node.id) +
                     " is not finite");
  }
}

int ClassCount(const LabelVocabulary& vocabulary) {
  return std::max(static_cast<int>(vocabulary.classes().size()) - 1, 1);
}

}  // namespace

SemanticMapper::SemanticMapper(const SemanticMapperOptions& options,
                               std::shared_ptr<const LabelVocabulary> vocabulary)
    : options_(options),
      vocabulary_(std::move(vocabulary)),
      transient_(MaskOf(options.map.transient_classes, *vocabulary_)),
      inserter_(options.insertion, LabelFusion(options.fusion, ClassCount(*vocabulary_))),
      clouds_({options.map.max_clouds_on_disk_mb * kMegabyte,
               options.map.max_clouds_in_memory_mb * kMegabyte, options.map.scratch_folder}) {
  Validate(options_.map);
  Validate(options_.occupancy);
  CheckRangeInVoxels(options_.insertion, options_.map.resolution_m);
  tree_ = EmptyTree();
  base_ = EmptyTree();
}

bool SemanticMapper::Insert(const SemanticCloud& cloud, const TrackedImage& image) {
  const CloudContents contents = CheckSemanticCloud(cloud, *vocabulary_);
  if (cloud.stamp != image.stamp) {
    throw InputError("semantic cloud is of the image at " + ToString(cloud.stamp) +
                     " s, expected " + ToString(image.stamp));
  }
  if (image.status != TrackingStatus::kTracking) {
    ++counts_.not_tracked;
    return false;
  }
  const auto T_map_keyframe = poses_.Find(image.keyframe_id);
  if (!T_map_keyframe || image.map_id != poses_.map_id()) {
    ++counts_.unknown_keyframe;
    return false;
  }
  const auto& observations = inserter_.Insert(cloud.points, contents, transient_,
                                              *T_map_keyframe * image.T_keyframe_camera, *tree_);
  Keep({image.stamp, image.keyframe_id, image.T_keyframe_camera}, observations);
  entered_poses_.emplace(image.keyframe_id, *T_map_keyframe);
  stamp_ = std::max(stamp_, image.stamp);
  ++counts_.inserted;
  ++version_;
  return true;
}

void SemanticMapper::Keep(const CloudAnchor& anchor,
                          const std::vector<VoxelObservation>& observations) {
  clouds_.Add(anchor, observations);
  const AnchoredClouds::Clouds& kept = clouds_.clouds();
  const bool is_kept = !kept.empty() && kept.back()->anchor().stamp == anchor.stamp;
  if (rebuild_ != nullptr && is_kept) came_meanwhile_.push_back(kept.back());
}

bool SemanticMapper::TakeOver(const KeyframeGraph& graph) {
  CheckPoses(graph);
  const bool is_new_map = graph.map_id != poses_.map_id();
  const bool is_forgotten = graph.revision < poses_.revision() || graph.map_id < poses_.map_id() ||
                            (is_new_map && ForgetsLostMaps(graph.reason));
  const bool had_content = tree_->getRoot() != nullptr;
  poses_ = KeyframePoses(graph);
  if (is_forgotten) Reset();
  return is_forgotten && had_content;
}

bool SemanticMapper::FollowGraph(const KeyframeGraph& graph) {
  if (TakeOver(graph)) return true;
  if (!NeedsRebuild()) return false;
  const std::unique_ptr<MapRebuild> rebuild = BeginRebuild();
  rebuild->Run();
  FinishRebuild(*rebuild);
  return true;
}

std::unique_ptr<MapRebuild> SemanticMapper::BeginRebuild() {
  MapRebuild::Parts parts{nullptr, clouds_.clouds(), cleared_};
  is_on_base_ = BelongsToBase();
  parts.base = is_on_base_ ? base_ : std::shared_ptr<const SemanticOcTree>(EmptyTree());
  auto rebuild = std::make_unique<MapRebuild>(inserter_, poses_, std::move(parts));
  rebuild_ = rebuild.get();
  came_meanwhile_.clear();
  cleared_meanwhile_.clear();
  return rebuild;
}

bool SemanticMapper::FinishRebuild(MapRebuild& rebuild) {
  if (rebuild_ != &rebuild) return true;
  if (!came_meanwhile_.empty() || !cleared_meanwhile_.empty()) {
    for (auto& cloud : came_meanwhile_) rebuild.Append(std::move(cloud));
    for (const ClearedBox& cleared : cleared_meanwhile_) rebuild.Append(cleared);
    came_meanwhile_.clear();
    cleared_meanwhile_.clear();
    return false;
  }
  rebuild_ = nullptr;
  tree_ = rebuild.TakeTree();
  entered_poses_ = rebuild.entered_poses();
  unlisted_ = rebuild.unlisted();
  const AnchoredClouds::Clouds& lost = rebuild.lost();
  counts_.lost_keyframe += clouds_.RemoveIf([&](const AnchoredCloud& cloud) {
    return std::any_of(lost.begin(), lost.end(),
                       [&](const auto& each) { return each.get() == &cloud; });
  });
  ++counts_.rebuilds;
  ++version_;
  return true;
}

// Whether the graph lists again what it did not list before.
bool SemanticMapper::ComesBack() const {
  return std::any_of(unlisted_.begin(), unlisted_.end(),
                     [this](KeyframeId id) { return poses_.Find(id).has_value(); });
}

void SemanticMapper::Load(std::unique_ptr<SemanticOcTree> tree) {
  if (tree->getResolution() != options_.map.resolution_m) {
    std::ostringstream what;
    what << "the map has voxels of " << tree->getResolution() << " m, expected "
         << options_.map.resolution_m << " m";
    throw InputError(what.str());
  }
  tree->SetOccupancy(options_.occupancy);
  Reset();
  base_ = std::move(tree);
  base_map_id_ = poses_.map_id();
  is_on_base_ = BelongsToBase();
  tree_ = base_->Copy();
}

std::size_t SemanticMapper::Clear(const Eigen::AlignedBox3d& box_m) {
  const std::size_t voxels = ClearBox(box_m, *tree_);
  const ClearedBox cleared{box_m, stamp_};
  cleared_.push_back(cleared);
  if (rebuild_ != nullptr) cleared_meanwhile_.push_back(cleared);
  ++version_;
  return voxels;
}

void SemanticMapper::Reset() {
  tree_ = EmptyTree();
  base_ = EmptyTree();
  is_on_base_ = false;
  cleared_.clear();
  cleared_meanwhile_.clear();
  clouds_.Clear();
  entered_poses_.clear();
  unlisted_.clear();
  came_meanwhile_.clear();
  rebuild_ = nullptr;
  stamp_ = Stamp{};
  ++version_;
}

std::vector<Eigen::Vector3d> SemanticMapper::CameraPath() const {
  std::vector<Eigen::Vector3d> path;
  for (const auto& cloud : clouds_.clouds()) {
    const CloudAnchor& anchor = cloud->anchor();
    const auto T_map_keyframe = poses_.Find(anchor.keyframe_id);
    if (T_map_keyframe) path.push_back(*T_map_keyframe * anchor.T_keyframe_camera.translation());
  }
  return path;
}

std::unique_ptr<SemanticOcTree> SemanticMapper::EmptyTree() const {
  auto tree = std::make_unique<SemanticOcTree>(options_.map.resolution_m);
  tree->SetOccupancy(options_.occupancy);
  return tree;
}

bool SemanticMapper::HasMoved() const {
  return std::any_of(entered_poses_.begin(), entered_poses_.end(), [this](const auto& entered) {
    const auto now = poses_.Find(entered.first);
    return !now || Displacement(entered.second, *now, options_.map.rebuild_reach_m) >
                       options_.map.rebuild_threshold_m;
  });
}

}  // namespace semantic_slam
