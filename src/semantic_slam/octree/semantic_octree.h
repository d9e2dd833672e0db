#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>

#include <octomap/OcTreeNode.h>
#include <octomap/OccupancyOcTreeBase.h>

#include "semantic_slam/semantic_fusion/label_distribution.h"

namespace semantic_slam {

// A voxel: occupancy as log-odds (OctoMap's), colour, and the three most probable labels. An inner
// node summarises the occupied voxels below it.
class SemanticNode : public octomap::OcTreeNode {
 public:
  using Rgb = std::array<std::uint8_t, 3>;

  SemanticNode() = default;
  // OctoMap's copy would slice the children.
  SemanticNode(const SemanticNode&) = delete;
  SemanticNode& operator=(const SemanticNode&) = delete;

  const Rgb& rgb() const { return rgb_; }
  const CompactLabels& labels() const { return labels_; }
  void SetRgb(const Rgb& rgb) { rgb_ = rgb; }
  void SetLabels(const CompactLabels& labels) { labels_ = labels; }

  // What OctoMap's templates ask of a node, hence their spelling.
  void copyData(const SemanticNode& from) {
    octomap::OcTreeNode::copyData(from);
    rgb_ = from.rgb_;
    labels_ = from.labels_;
  }
  bool operator==(const SemanticNode& other) const {
    return value == other.value && rgb_ == other.rgb_ && labels_ == other.labels_;
  }
  std::istream& readData(std::istream& stream);
  std::ostream& writeData(std::ostream& stream) const;

 private:
  Rgb rgb_{0, 0, 0};
  CompactLabels labels_;
};

static_assert(sizeof(SemanticNode) <= 24, "the node must stay small: there are millions");

// Occupancy of a voxel, thesis eq. (3.17) and (3.18): log-odds that grow by each hit and fall by
// each ray that passes, within bounds (ERRATA), so that a voxel can change its mind. All are
// probabilities.
struct OccupancyOptions {
  double hit = 0.7;
  double miss = 0.4;
  double clamp_min = 0.12;
  double clamp_max = 0.97;
  double occupied = 0.5;  // from here on a voxel counts as occupied

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("hit", self.hit, 0.5, 0.99);
    visit("miss", self.miss, 0.01, 0.5);
    visit("clamp_min", self.clamp_min, 0.001, 0.5);
    visit("clamp_max", self.clamp_max, 0.5, 0.999);
    visit("occupied", self.occupied, 0.1, 0.9);
  }
};

// The semantic octree of thesis section 3.3.4, on OctoMap's templates. Files carry the id
// "SemanticOcTree", which octomap::AbstractOcTree::read() knows in every program that links this.
//
// Eight children become one leaf where that loses nothing: they have the same occupancy, and are
// free or have the same labels. Free space keeps neither colour nor labels when it is joined.
//
// Not thread-safe; several threads may read.
class SemanticOcTree : public octomap::OccupancyOcTreeBase<SemanticNode> {
 public:
  explicit SemanticOcTree(double resolution_m);
  SemanticOcTree(const SemanticOcTree&) = delete;

  void SetOccupancy(const OccupancyOptions& options);

  // A tree of the same voxels and the same options.
  std::unique_ptr<SemanticOcTree> Copy() const;

  // Log-odds one hit adds and one miss takes.
  float hit_log_odds() const { return prob_hit_log; }
  float miss_log_odds() const { return prob_miss_log; }

  // The root, made if there is none. `*created` tells.
  SemanticNode* EnsureRoot(bool* created);

  // Occupancy of an inner node as OctoMap has it, the children's maximum; colour and labels as the
  // mean of the occupied children. Precondition: node has children.
  void SummariseChildren(SemanticNode* node);

  // The voxel's key range: the lowest key that the node at `key` and `depth` covers.
  octomap::OcTreeKey LowestKey(const octomap::OcTreeKey& key, unsigned depth) const;

  // Whether the node is a leaf that no further ray can make freer.
  bool CanGetNoFreer(const SemanticNode* node) const {
    return !nodeHasChildren(node) && node->getLogOdds() <= clamping_thres_min;
  }

  // The key of the voxel in which the coordinate lies, or of the outermost one on its side.
  octomap::key_type ClampedKey(double coordinate_m) const {
    const double cell = std::floor(coordinate_m / resolution) + tree_max_val;
    return static_cast<octomap::key_type>(std::clamp(cell, 0.0, 2.0 * tree_max_val - 1.0));
  }

  // What OctoMap asks of a tree, hence the spelling.
  SemanticOcTree* create() const override { return new SemanticOcTree(resolution); }
  std::string getTreeType() const override { return kTreeType; }
  bool isNodeCollapsible(const SemanticNode* node) const override;
  bool pruneNode(SemanticNode* node) override;

  static constexpr char kTreeType[] = "SemanticOcTree";

 private:
  // Makes AbstractOcTree::read() know kTreeType.
  static bool Register();
  static const bool kRegistered;

  void CopyBelow(const SemanticOcTree& from, const SemanticNode* source, SemanticNode* target);
  bool SameForPruning(const SemanticNode& a, const SemanticNode& b) const;
};

}  // namespace semantic_slam
