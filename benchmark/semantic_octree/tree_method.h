#pragma once

#include <limits>
#include <sstream>

#include "semantic_octree/mapping_method.h"

namespace semantic_slam {

// What all mappers whose map is an octree of OctoMap's templates have in common.
template <typename Tree>
class TreeMethod : public MappingMethod {
 public:
  std::size_t Leaves() const override { return tree().getNumLeafNodes(); }
  std::size_t Nodes() const override { return tree().size(); }
  std::size_t MapBytes() const override { return tree().memoryUsage(); }

  std::size_t Serialise() const override {
    std::ostringstream stream;
    tree().writeData(stream);
    return stream.str().size();
  }

  void ForEachOccupied(const VisitVoxel& visit) const override {
    ForEachLeafVoxel([&](const octomap::OcTreeKey& key, const auto& node) {
      if (tree().isNodeOccupied(node)) visit(key, LabelOf(node));
    });
  }

  float LogOdds(const octomap::OcTreeKey& key) const override {
    const auto* node = tree().search(key);
    return node == nullptr ? std::numeric_limits<float>::quiet_NaN() : node->getLogOdds();
  }

  void ForEachKnown(const VisitVoxel& visit) const override {
    ForEachLeafVoxel(
        [&](const octomap::OcTreeKey& key, const auto&) { visit(key, kUnknownLabel); });
  }

 protected:
  virtual const Tree& tree() const = 0;
  virtual LabelId LabelOf(const typename Tree::NodeType&) const { return kUnknownLabel; }

 private:
  // Leaves above the lowest level as all the voxels that they stand for.
  template <typename Visit>
  void ForEachLeafVoxel(Visit&& visit) const {
    for (auto leaf = tree().begin_leafs(), end = tree().end_leafs(); leaf != end; ++leaf) {
      const int side = 1 << (tree().getTreeDepth() - leaf.getDepth());
      const octomap::OcTreeKey lowest = leaf.getIndexKey();
      for (int i = 0; i < side * side * side; ++i) {
        const octomap::OcTreeKey key(static_cast<octomap::key_type>(lowest[0] + i % side),
                                     static_cast<octomap::key_type>(lowest[1] + i / side % side),
                                     static_cast<octomap::key_type>(lowest[2] + i / side / side));
        visit(key, *leaf);
      }
    }
  }
};

}  // namespace semantic_slam
