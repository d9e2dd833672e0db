#include "semantic_slam/octree/semantic_octree.h"

#include <algorithm>
#include <istream>
#include <limits>
#include <ostream>

#include "semantic_slam/semantic_fusion/top_labels.h"

namespace semantic_slam {
namespace {

// The mean of what up to eight children say.
class LabelMean {
 public:
  void Add(const CompactLabels& labels) {
    ++children_;
    for (int i = 0; i < kTopLabels; ++i) {
      if (labels.label(i) == kUnknownLabel) return;
      Entry* entry = entries_.data();
      while (entry != entries_.data() + count_ && entry->label != labels.label(i)) ++entry;
      if (entry == entries_.data() + count_) entries_[count_++] = {labels.label(i), 0};
      entry->weight += labels.scaled_probability(i);
    }
  }

  CompactLabels Take() const {
    if (children_ == 0) return {};
    TopLabels<int> top;
    for (int i = 0; i < count_; ++i) top.Offer(entries_[i].label, entries_[i].weight);
    std::array<int, kTopLabels> scaled{};
    for (int i = 0; i < kTopLabels; ++i) scaled[i] = (top.weights()[i] + children_ / 2) / children_;
    return {top.labels(), scaled, 0};
  }

 private:
  struct Entry {
    LabelId label;
    int weight;
  };

  std::array<Entry, 8 * kTopLabels> entries_;
  int count_ = 0;
  int children_ = 0;
};

}  // namespace

// OctoMap keeps the prototype for ever.
bool SemanticOcTree::Register() {
  auto* prototype = new SemanticOcTree(0.1);
  prototype->clearKeyRays();
  registerTreeType(prototype);
  return true;
}

const bool SemanticOcTree::kRegistered = SemanticOcTree::Register();

std::istream& SemanticNode::readData(std::istream& stream) {
  octomap::OcTreeNode::readData(stream);
  std::array<std::uint8_t, CompactLabels::kBytes> bytes{};
  stream.read(reinterpret_cast<char*>(rgb_.data()), rgb_.size());
  stream.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  labels_ = CompactLabels::FromBytes(bytes);
  return stream;
}

std::ostream& SemanticNode::writeData(std::ostream& stream) const {
  octomap::OcTreeNode::writeData(stream);
  stream.write(reinterpret_cast<const char*>(rgb_.data()), rgb_.size());
  stream.write(reinterpret_cast<const char*>(labels_.bytes().data()), CompactLabels::kBytes);
  return stream;
}

SemanticOcTree::SemanticOcTree(double resolution_m)
    : OccupancyOcTreeBase<SemanticNode>(resolution_m) {
  (void)kRegistered;
}

void SemanticOcTree::SetOccupancy(const OccupancyOptions& options) {
  setProbHit(options.hit);
  setProbMiss(options.miss);
  setClampingThresMin(options.clamp_min);
  setClampingThresMax(options.clamp_max);
  setOccupancyThres(options.occupied);
}

std::unique_ptr<SemanticOcTree> SemanticOcTree::Copy() const {
  auto copy = std::make_unique<SemanticOcTree>(resolution);
  copy->prob_hit_log = prob_hit_log;
  copy->prob_miss_log = prob_miss_log;
  copy->clamping_thres_min = clamping_thres_min;
  copy->clamping_thres_max = clamping_thres_max;
  copy->occ_prob_thres_log = occ_prob_thres_log;
  if (root == nullptr) return copy;
  bool created = false;
  copy->CopyBelow(*this, root, copy->EnsureRoot(&created));
  return copy;
}

void SemanticOcTree::CopyBelow(const SemanticOcTree& from, const SemanticNode* source,
                               SemanticNode* target) {
  target->copyData(*source);
  for (unsigned i = 0; i < 8; ++i) {
    if (from.nodeChildExists(source, i))
      CopyBelow(from, from.getNodeChild(source, i), createNodeChild(target, i));
  }
}

SemanticNode* SemanticOcTree::EnsureRoot(bool* created) {
  *created = root == nullptr;
  if (*created) {
    root = new SemanticNode();
    ++tree_size;
  }
  return root;
}

void SemanticOcTree::SummariseChildren(SemanticNode* node) {
  float log_odds = -std::numeric_limits<float>::max();
  std::array<const SemanticNode*, 8> occupied;
  int count = 0;
  for (unsigned i = 0; i < 8; ++i) {
    if (!nodeChildExists(node, i)) continue;
    const SemanticNode* child = getNodeChild(node, i);
    log_odds = std::max(log_odds, child->getLogOdds());
    if (isNodeOccupied(child)) occupied[count++] = child;
  }
  node->setLogOdds(log_odds);
  std::array<int, 3> rgb{0, 0, 0};
  LabelMean labels;
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < 3; ++c) rgb[c] += occupied[i]->rgb()[c];
    labels.Add(occupied[i]->labels());
  }
  SemanticNode::Rgb mean{0, 0, 0};
  for (int c = 0; c < 3 && count > 0; ++c)
    mean[c] = static_cast<std::uint8_t>((rgb[c] + count / 2) / count);
  node->SetRgb(mean);
  node->SetLabels(labels.Take());
}

octomap::OcTreeKey SemanticOcTree::LowestKey(const octomap::OcTreeKey& key, unsigned depth) const {
  const unsigned shift = tree_depth - depth;
  const auto lowest = [shift](octomap::key_type k) {
    return static_cast<octomap::key_type>((k >> shift) << shift);
  };
  return {lowest(key[0]), lowest(key[1]), lowest(key[2])};
}

bool SemanticOcTree::SameForPruning(const SemanticNode& a, const SemanticNode& b) const {
  return a.getLogOdds() == b.getLogOdds() && (!isNodeOccupied(a) || a.labels() == b.labels());
}

bool SemanticOcTree::isNodeCollapsible(const SemanticNode* node) const {
  if (!nodeChildExists(node, 0)) return false;
  const SemanticNode* first = getNodeChild(node, 0);
  for (unsigned i = 0; i < 8; ++i) {
    if (!nodeChildExists(node, i)) return false;
    const SemanticNode* child = getNodeChild(node, i);
    if (nodeHasChildren(child) || !SameForPruning(*first, *child)) return false;
  }
  return true;
}

bool SemanticOcTree::pruneNode(SemanticNode* node) {
  if (!isNodeCollapsible(node)) return false;
  SummariseChildren(node);
  const SemanticNode::Rgb rgb = node->rgb();
  const CompactLabels labels =
      isNodeOccupied(node) ? getNodeChild(node, 0)->labels() : CompactLabels();
  OccupancyOcTreeBase<SemanticNode>::pruneNode(node);
  node->SetRgb(rgb);
  node->SetLabels(labels);
  return true;
}

}  // namespace semantic_slam
