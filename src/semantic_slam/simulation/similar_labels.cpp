#include "semantic_slam/simulation/similar_labels.h"

#include <algorithm>
#include <set>
#include <string>

namespace semantic_slam {
namespace {

const std::vector<std::vector<std::string>>& GroupsOfNames() {
  static const std::vector<std::vector<std::string>> groups{
      {"bed", "sofa", "chair", "bench"},
      {"table", "desk", "coffee_table", "conference_table", "counter", "bench"},
      {"cabinet", "dresser", "night_stand", "bookshelf", "shelves"},
      {"cabinet", "fridge", "oven", "microwave", "counter"},
      {"wall", "door", "curtain"},
      {"wall", "ceiling"},
      {"window", "picture", "mirror", "whiteboard", "tv"},
      {"curtain", "shower_curtain", "blinds", "window"},
      {"floor", "floor_mat"},
      {"pillow", "clothes", "towel", "bag", "toy"},
      {"books", "paper", "box", "laptop"},
      {"laptop", "tv", "keyboard"},
      {"keyboard", "mouse", "remote", "telephone"},
      {"bottle", "cup", "bowl", "vase", "utensil", "food"},
      {"lamp", "vase", "plant"},
      {"clock", "picture"},
      {"person", "clothes", "animal"},
      {"toilet", "sink", "bathtub"},
      {"plant", "vegetation"},
      {"ground", "floor"},
      {"building", "wall"}};
  return groups;
}

std::vector<LabelId> IdsOf(const std::vector<std::string>& names,
                           const LabelVocabulary& vocabulary) {
  std::vector<LabelId> ids;
  for (const std::string& name : names) {
    if (const auto id = vocabulary.Find(name)) ids.push_back(*id);
  }
  return ids;
}

}  // namespace

SimilarLabels::SimilarLabels(const LabelVocabulary& vocabulary) {
  std::array<std::set<LabelId>, 256> similar;
  for (const std::vector<std::string>& names : GroupsOfNames()) {
    const std::vector<LabelId> ids = IdsOf(names, vocabulary);
    for (const LabelId id : ids) similar[id].insert(ids.begin(), ids.end());
  }
  for (std::size_t id = 0; id < similar.size(); ++id) {
    similar[id].erase(static_cast<LabelId>(id));
    similar_[id].assign(similar[id].begin(), similar[id].end());
  }
}

}  // namespace semantic_slam
