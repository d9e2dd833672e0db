#include "semantic_slam/octree/map_export.h"

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <octomap/OcTree.h>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/occupied_voxels.h"

namespace semantic_slam {
namespace {

constexpr char kFirstLine[] = "# Octomap OcTree file";
constexpr char kHashComment[] = "# label_set ";
constexpr unsigned kDepth = 16;

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
  stream << kFirstLine
         << "\n# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
         << comments << "id " << id << "\nsize " << tree.size() << "\nres " << tree.getResolution()
         << "\ndata\n";
  if (tree.getRoot() == nullptr) return;
  WriteNodes(tree, *tree.getRoot(), 0.0, tree.getNodeSize(0), stream, write_data);
}

void WriteLogOdds(const SemanticNode& node, std::ostream& stream) {
  const float log_odds = node.getLogOdds();
  stream.write(reinterpret_cast<const char*>(&log_odds), sizeof(log_odds));
}

std::string LegendComments(const LabelVocabulary& vocabulary) {
  std::ostringstream comments;
  comments << kHashComment << vocabulary.hash() << '\n';
  for (const LabelClass& label : vocabulary.classes()) {
    comments << "# label " << int{label.id} << ' ' << label.name;
    for (const std::uint8_t channel : label.rgb) comments << ' ' << int{channel};
    comments << '\n';
  }
  return comments.str();
}

struct Header {
  std::string id;
  std::string label_set;
  std::size_t size = 0;
  double resolution_m = 0.0;
};

// Leaves the stream at the first node.
Header ReadHeader(std::istream& stream) {
  std::string line;
  if (!std::getline(stream, line) || line != kFirstLine)
    throw InputError("it is no OctoMap .ot file");
  Header header;
  while (std::getline(stream, line) && line != "data") {
    if (line.rfind(kHashComment, 0) == 0) header.label_set = line.substr(sizeof(kHashComment) - 1);
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "id") words >> header.id;
    if (key == "size") words >> header.size;
    if (key == "res") words >> header.resolution_m;
  }
  if (!stream) throw InputError("its header ends too soon");
  return header;
}

void CheckHeader(const Header& header, const LabelVocabulary& vocabulary) {
  if (header.id != SemanticOcTree::kTreeType) {
    throw InputError("it holds a tree of type '" + header.id + "', expected " +
                     SemanticOcTree::kTreeType);
  }
  if (header.label_set != std::to_string(vocabulary.hash())) {
    throw InputError("it was made with another label set, hash " + header.label_set +
                     ", expected " + std::to_string(vocabulary.hash()));
  }
  if (!(header.resolution_m >= 1e-4 && header.resolution_m <= 1e3)) {
    throw InputError("its resolution is " + std::to_string(header.resolution_m) + " m");
  }
}

void CheckNode(const SemanticNode& node, const LabelVocabulary& vocabulary) {
  bool sound = std::isfinite(node.getLogOdds()) && node.labels().IsValid();
  for (int i = 0; i < kTopLabels; ++i) sound = sound && vocabulary.Contains(node.labels().label(i));
  if (!sound) throw InputError("it is damaged: a voxel has labels or an occupancy that cannot be");
}

// Never deeper than a tree can be, whatever the file says.
void ReadNodes(std::istream& stream, const LabelVocabulary& vocabulary, unsigned depth,
               SemanticOcTree& tree, SemanticNode& node) {
  node.readData(stream);
  const int children = stream.get();
  if (!stream) throw InputError("it ends too soon");
  CheckNode(node, vocabulary);
  if (children != 0 && depth == kDepth) throw InputError("it is damaged: its voxels are too deep");
  for (unsigned i = 0; i < 8; ++i) {
    if (children >> i & 1)
      ReadNodes(stream, vocabulary, depth + 1, tree, *tree.createNodeChild(&node, i));
  }
}

std::unique_ptr<SemanticOcTree> ReadTree(std::istream& stream, const LabelVocabulary& vocabulary) {
  const Header header = ReadHeader(stream);
  CheckHeader(header, vocabulary);
  auto tree = std::make_unique<SemanticOcTree>(header.resolution_m);
  if (header.size > 0) {
    bool created = false;
    ReadNodes(stream, vocabulary, 0, *tree, *tree->EnsureRoot(&created));
  }
  if (tree->size() != header.size || stream.peek() != std::istream::traits_type::eof()) {
    throw InputError("it is damaged: it does not hold the " + std::to_string(header.size) +
                     " nodes that it says");
  }
  return tree;
}

template <typename Value>
void Append(const Value& value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

}  // namespace

void WriteSemanticTree(const std::string& path, const SemanticOcTree& tree,
                       const LabelVocabulary& vocabulary) {
  WriteFileAtomically(path, [&](std::ostream& stream) {
    WriteTree(tree, SemanticOcTree::kTreeType, LegendComments(vocabulary), stream,
              [&](const SemanticNode& node, double) { node.writeData(stream); });
  });
}

std::unique_ptr<SemanticOcTree> ReadSemanticTree(const std::string& path,
                                                 const LabelVocabulary& vocabulary) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError("cannot open " + path);
  try {
    return ReadTree(stream, vocabulary);
  } catch (const InputError& e) {
    throw InputError("cannot read " + path + ": " + e.what());
  }
}

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
  std::string points;
  std::size_t count = 0;
  ForEachOccupiedVoxel(tree, [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
    const octomap::point3d centre = tree.keyToCoord(key);
    for (unsigned i = 0; i < 3; ++i) Append(centre(i), points);
    Append(colours(node, centre.z()), points);
    const LabelDistribution labels = node.labels().Unpacked();
    Append(labels.top(), points);
    Append(labels.probabilities[0], points);
    ++count;
  });
  WriteFileAtomically(path, [&](std::ostream& stream) {
    stream << "ply\nformat binary_little_endian 1.0\ncomment occupied voxels of "
           << tree.getResolution() << " m\nelement vertex " << count
           << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
              "red\nproperty uchar green\n"
              "property uchar blue\nproperty uchar label\nproperty float probability\nend_header\n"
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
