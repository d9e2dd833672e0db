#pragma once

#include <memory>
#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/octree/semantic_octree.h"

// The file that keeps everything of a semantic map: OctoMap's .ot with the id "SemanticOcTree" and,
// as comments in its header, the labels. octomap::AbstractOcTree::read() reads it where this
// library is linked.

namespace semantic_slam {

// Written whole or not at all, with the same bytes for the same map. Throws InputError naming the
// path if it cannot be written.
void WriteSemanticTree(const std::string& path, const SemanticOcTree& tree,
                       const LabelVocabulary& vocabulary);

// Throws InputError naming the path and what is wrong: another kind of file, another label set than
// `vocabulary`, cut short, or damaged.
std::unique_ptr<SemanticOcTree> ReadSemanticTree(const std::string& path,
                                                 const LabelVocabulary& vocabulary);

struct LabelledTree {
  std::unique_ptr<SemanticOcTree> tree;
  LabelVocabulary vocabulary;  // ids, names and colours; the file has no more
};

// The same with the labels that the file itself tells of.
LabelledTree ReadLabelledTree(const std::string& path);

}  // namespace semantic_slam
