#include "semantic_slam/octree/semantic_map.h"

#include <algorithm>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
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
      clouds_(options.map.max_clouds_mb * kMegabyte) {
  Validate(options_.map);
  Validate(options_.occupancy);
  CheckRangeInVoxels(options_.insertion, options_.map.resolution_m);
  tree_ = EmptyTree();
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
  AnchoredCloud anchored{image.stamp, image.keyframe_id, image.T_keyframe_camera, {}};
  anchored.observations = inserter_.Insert(cloud.points, contents, transient_,
                                           *T_map_keyframe * image.T_keyframe_camera, *tree_);
  clouds_.Add(std::move(anchored));
  entered_poses_.emplace(image.keyframe_id, *T_map_keyframe);
  stamp_ = std::max(stamp_, image.stamp);
  ++counts_.inserted;
  ++version_;
  return true;
}

bool SemanticMapper::FollowGraph(const KeyframeGraph& graph) {
  CheckPoses(graph);
  const bool is_new_map = graph.map_id != poses_.map_id();
  const bool is_forgotten = graph.revision < poses_.revision() || graph.map_id < poses_.map_id() ||
                            (is_new_map && ForgetsLostMaps(graph.reason));
  const bool had_content = tree_->getRoot() != nullptr;
  poses_ = KeyframePoses(graph);
  if (is_forgotten) {
    Reset();
    return had_content;
  }
  if (!HasMoved() && !ComesBack()) return false;
  Rebuild();
  return true;
}

// Whether the graph lists again what it did not list before.
bool SemanticMapper::ComesBack() const {
  return std::any_of(unlisted_.begin(), unlisted_.end(),
                     [this](KeyframeId id) { return poses_.Find(id).has_value(); });
}

void SemanticMapper::Reset() {
  tree_ = EmptyTree();
  clouds_.Clear();
  entered_poses_.clear();
  unlisted_.clear();
  stamp_ = Stamp{};
  ++version_;
}

std::vector<Eigen::Vector3d> SemanticMapper::CameraPath() const {
  std::vector<Eigen::Vector3d> path;
  for (const AnchoredCloud& cloud : clouds_.clouds()) {
    const auto T_map_keyframe = poses_.Find(cloud.keyframe_id);
    if (T_map_keyframe) path.push_back(*T_map_keyframe * cloud.T_keyframe_camera.translation());
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

void SemanticMapper::Rebuild() {
  entered_poses_.clear();
  unlisted_.clear();
  std::unique_ptr<SemanticOcTree> tree = EmptyTree();
  counts_.lost_keyframe += clouds_.RemoveIf([&](const AnchoredCloud& cloud) {
    const auto T_map_keyframe = poses_.Find(cloud.keyframe_id);
    if (!T_map_keyframe) {
      unlisted_.insert(cloud.keyframe_id);
      return false;
    }
    try {
      inserter_.Insert(cloud.observations, *T_map_keyframe * cloud.T_keyframe_camera, *tree);
    } catch (const InputError&) {
      return true;  // it has moved out of the octree
    }
    entered_poses_.emplace(cloud.keyframe_id, *T_map_keyframe);
    return false;
  });
  tree_ = std::move(tree);
  ++counts_.rebuilds;
  ++version_;
}

}  // namespace semantic_slam
