#include "semantic_slam/octree/semantic_tree_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/tree_stream.h"

namespace semantic_slam {
namespace {

constexpr char kHashComment[] = "# label_set ";
constexpr char kLabelComment[] = "# label ";
constexpr unsigned kDepth = 16;

std::string LegendComments(const LabelVocabulary& vocabulary) {
  std::ostringstream comments;
  comments << kHashComment << vocabulary.hash() << '\n';
  for (const LabelClass& label : vocabulary.classes()) {
    comments << kLabelComment << int{label.id} << ' ' << label.name;
    for (const std::uint8_t channel : label.rgb) comments << ' ' << int{channel};
    comments << '\n';
  }
  return comments.str();
}

struct Header {
  std::string id;
  std::string label_set;           // hash
  std::vector<LabelClass> labels;  // ids, names and colours
  std::size_t size = 0;
  double resolution_m = 0.0;
};

// "5 chair 214 39 40"
LabelClass ParseLabel(const std::string& text) {
  std::istringstream words(text);
  int id = -1, red = -1, green = -1, blue = -1;
  LabelClass label;
  if (!(words >> id >> label.name >> red >> green >> blue) ||
      std::min({id, red, green, blue}) < 0 || std::max({id, red, green, blue}) > 255) {
    throw InputError("its legend has the line '" + text +
                     "', expected id, name, red, green and blue");
  }
  label.id = static_cast<LabelId>(id);
  label.rgb = {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
               static_cast<std::uint8_t>(blue)};
  return label;
}

// What follows `start` in `line`; nullopt if it begins otherwise.
std::optional<std::string> TextAfter(const std::string& start, const std::string& line) {
  if (line.rfind(start, 0) != 0) return std::nullopt;
  return line.substr(start.size());
}

// Leaves the stream at the first node.
Header ReadHeader(std::istream& stream) {
  std::string line;
  if (!std::getline(stream, line) || line != kTreeFileFirstLine)
    throw InputError("it is no OctoMap .ot file");
  Header header;
  while (std::getline(stream, line) && line != "data") {
    if (const auto hash = TextAfter(kHashComment, line)) header.label_set = *hash;
    if (const auto label = TextAfter(kLabelComment, line))
      header.labels.push_back(ParseLabel(*label));
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

void CheckHeader(const Header& header) {
  if (header.id != SemanticOcTree::kTreeType) {
    throw InputError("it holds a tree of type '" + header.id + "', expected " +
                     SemanticOcTree::kTreeType);
  }
  if (!(header.resolution_m >= 1e-4 && header.resolution_m <= 1e3)) {
    throw InputError("its resolution is " + std::to_string(header.resolution_m) + " m");
  }
}

void CheckLabelSet(const Header& header, const LabelVocabulary& vocabulary) {
  if (header.label_set != std::to_string(vocabulary.hash())) {
    throw InputError("it was made with another label set, hash " + header.label_set +
                     ", expected " + std::to_string(vocabulary.hash()));
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

std::unique_ptr<SemanticOcTree> ReadTree(std::istream& stream, const Header& header,
                                         const LabelVocabulary& vocabulary) {
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

LabelVocabulary VocabularyOf(const Header& header) {
  try {
    return LabelVocabulary(header.labels);
  } catch (const ConfigError& e) {
    throw InputError("its legend is damaged: " + std::string(e.what()));
  }
}

// Runs read(stream, header) on the file at `path`, and puts the path before what goes wrong.
template <typename Read>
auto ReadFile(const std::string& path, Read&& read) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError("cannot open " + path);
  try {
    const Header header = ReadHeader(stream);
    CheckHeader(header);
    return read(stream, header);
  } catch (const InputError& e) {
    throw InputError("cannot read " + path + ": " + e.what());
  }
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
  return ReadFile(path, [&](std::istream& stream, const Header& header) {
    CheckLabelSet(header, vocabulary);
    return ReadTree(stream, header, vocabulary);
  });
}

LabelledTree ReadLabelledTree(const std::string& path) {
  return ReadFile(path, [](std::istream& stream, const Header& header) {
    LabelVocabulary vocabulary = VocabularyOf(header);
    CheckLabelSet(header, vocabulary);
    auto tree = ReadTree(stream, header, vocabulary);
    return LabelledTree{std::move(tree), std::move(vocabulary)};
  });
}

}  // namespace semantic_slam
