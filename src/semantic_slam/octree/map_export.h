#pragma once

#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/octree/voxel_colours.h"

// Files of a semantic map for other programs. All are written whole or not at all, with the same
// bytes for the same map; all writers throw InputError naming the path if that fails.

namespace semantic_slam {

// A ColorOcTree .ot, for octovis and every other program of OctoMap's: occupancy and one colour.
void WriteColourTree(const std::string& path, const SemanticOcTree& tree,
                     const VoxelColours& colours);

// OctoMap's .bt, for planners: occupied or free, nothing else.
void WriteBinaryTree(const std::string& path, const SemanticOcTree& tree);

// A point per occupied voxel as a binary .ply: x y z (float) [m], red green blue, label (uchar),
// probability (float) of the label.
void WritePointCloud(const std::string& path, const SemanticOcTree& tree,
                     const VoxelColours& colours);

// The same as a binary .pcd of PCL's: x y z, rgb (PCL's packing), label, probability.
void WritePcd(const std::string& path, const SemanticOcTree& tree, const VoxelColours& colours);

// Everything: `prefix`.ot as WriteSemanticTree() writes it, `prefix`_colour.ot, `prefix`.bt and
// `prefix`.ply, in the colours of the classes.
void WriteMapFiles(const std::string& prefix, const SemanticOcTree& tree,
                   const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
