#include "semantic_slam/octree/map_export.h"

#include <array>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <utility>

#include <octomap/OcTree.h>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/octree/occupied_voxels.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "semantic_slam/octree/tree_stream.h"

namespace semantic_slam {
namespace {

void WriteLogOdds(const SemanticNode& node, std::ostream& stream) {
  const float log_odds = node.getLogOdds();
  stream.write(reinterpret_cast<const char*>(&log_odds), sizeof(log_odds));
}

template <typename Value>
void Append(const Value& value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

// What point clouds tell of an occupied voxel.
struct Voxel {
  octomap::point3d centre;
  const SemanticNode* node;
  LabelDistribution labels;
};

// Each occupied voxel's centre as three floats, and what append_rest(voxel, bytes) adds; and how
// many there are.
template <typename AppendRest>
std::pair<std::string, std::size_t> Serialised(const SemanticOcTree& tree,
                                               AppendRest&& append_rest) {
  std::string bytes;
  std::size_t count = 0;
  ForEachOccupiedVoxel(tree, [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
    const Voxel voxel{tree.keyToCoord(key), &node, node.labels().Unpacked()};
    for (unsigned i = 0; i < 3; ++i) Append(voxel.centre(i), bytes);
    append_rest(voxel, bytes);
    ++count;
  });
  return {std::move(bytes), count};
}

}  // namespace

void WriteColourTree(const std::string& path, const SemanticOcTree& tree,
                     const VoxelColours& colours) {
  WriteFileAtomically(path, [&](std::ostream& stream) {
    WriteTree(tree, "ColorOcTree", "", stream, [&](const SemanticNode& node, double z_m) {
      WriteLogOdds(node, stream);
      const auto rgb = colours(node, z_m);
      stream.write(reinterpret_cast<const char*>(rgb.data()), rgb.size());
    });
  });
}

void WriteBinaryTree(const std::string& path, const SemanticOcTree& tree) {
  std::stringstream nodes;
  if (tree.getRoot() != nullptr) {
    WriteNodes(tree, *tree.getRoot(), 0.0, 0.0, nodes,
               [&](const SemanticNode& node, double) { WriteLogOdds(node, nodes); });
  }
  octomap::OcTree occupancy(tree.getResolution());
  occupancy.setOccupancyThres(tree.getOccupancyThres());
  if (tree.getRoot() != nullptr) occupancy.readData(nodes);
  // Makes every voxel certain, joins what is the same, and writes.
  WriteFileAtomically(path, [&](std::ostream& stream) { occupancy.writeBinary(stream); });
}

void WritePointCloud(const std::string& path, const SemanticOcTree& tree,
                     const VoxelColours& colours) {
  const auto [points, count] = Serialised(tree, [&](const Voxel& voxel, std::string& bytes) {
    Append(colours(*voxel.node, voxel.centre.z()), bytes);
    Append(voxel.labels.top(), bytes);
    Append(voxel.labels.probabilities[0], bytes);
  });
  WriteFileAtomically(path, [&, &points = points, &count = count](std::ostream& stream) {
    stream << "ply\nformat binary_little_endian 1.0\ncomment occupied voxels of "
           << tree.getResolution() << " m\nelement vertex " << count
           << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
              "red\nproperty uchar green\n"
              "property uchar blue\nproperty uchar label\nproperty float probability\nend_header\n"
           << points;
  });
}

void WritePcd(const std::string& path, const SemanticOcTree& tree, const VoxelColours& colours) {
  const auto [points, count] = Serialised(tree, [&](const Voxel& voxel, std::string& bytes) {
    const auto [red, green, blue] = colours(*voxel.node, voxel.centre.z());
    Append(static_cast<std::uint32_t>(red << 16 | green << 8 | blue), bytes);
    Append(voxel.labels.top(), bytes);
    Append(voxel.labels.probabilities[0], bytes);
  });
  WriteFileAtomically(path, [&points = points, &count = count](std::ostream& stream) {
    stream << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb label "
              "probability\n"
              "SIZE 4 4 4 4 1 4\nTYPE F F F U U F\nCOUNT 1 1 1 1 1 1\nWIDTH "
           << count << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << count << "\nDATA binary\n"
           << points;
  });
}

void WriteMapFiles(const std::string& prefix, const SemanticOcTree& tree,
                   const LabelVocabulary& vocabulary) {
  const VoxelColours colours(ColourMode::kClass, vocabulary);
  WriteSemanticTree(prefix + ".ot", tree, vocabulary);
  WriteColourTree(prefix + "_colour.ot", tree, colours);
  WriteBinaryTree(prefix + ".bt", tree);
  WritePointCloud(prefix + ".ply", tree, colours);
}

}  // namespace semantic_slam
