#pragma once

#include <ostream>
#include <string>

#include "semantic_slam/octree/semantic_octree.h"

// How OctoMap lays out its .ot files. For the writers of this room.

namespace semantic_slam {

constexpr char kTreeFileFirstLine[] = "# Octomap OcTree file";

// Writes the nodes as OctoMap does: each node's data, which of its children exist, and those.
template <typename WriteData>
void WriteNodes(const SemanticOcTree& tree, const SemanticNode& node, double z_m, double size_m,
                std::ostream& stream, WriteData&& write_data) {
  write_data(node, z_m);
  unsigned children = 0;
  for (unsigned i = 0; i < 8; ++i)
    children |= static_cast<unsigned>(tree.nodeChildExists(&node, i)) << i;
  stream.put(static_cast<char>(children));
  for (unsigned i = 0; i < 8; ++i) {
    if (!(children >> i & 1)) continue;
    const double child_z_m = z_m + (i & 4 ? 0.25 : -0.25) * size_m;
    WriteNodes(tree, *tree.getNodeChild(&node, i), child_z_m, 0.5 * size_m, stream, write_data);
  }
}

// `write_data(node, z)` writes what the tree type `id` has per node.
template <typename WriteData>
void WriteTree(const SemanticOcTree& tree, const char* id, const std::string& comments,
               std::ostream& stream, WriteData&& write_data) {
  stream << kTreeFileFirstLine
         << "\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
         << comments << "id " << id << "\nsize " << tree.size() << "\nres " << tree.getResolution()
         << "\ndata\n";
  if (tree.getRoot() == nullptr) return;
  WriteNodes(tree, *tree.getRoot(), 0.0, tree.getNodeSize(0), stream, write_data);
}

}  // namespace semantic_slam
