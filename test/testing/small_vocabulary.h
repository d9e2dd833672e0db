#pragma once

#include "semantic_slam/common/label_vocabulary.h"

namespace semantic_slam {

// Six classes that no test needs to look up: 0 unknown, 1 wall, 2 floor (costs nothing), 3 chair
// (cost 100, movable), 4 table (hollow), 9 lamp (cost 50).
inline LabelVocabulary SmallVocabulary() {
  return LabelVocabulary({{0, "unknown", {0, 0, 0}},
                          {1, "wall", {200, 200, 200}},
                          {2, "floor", {100, 50, 0}, false, false, 0},
                          {3, "chair", {255, 0, 0}, true, false, 100},
                          {4, "table", {0, 255, 0}, false, true},
                          {9, "lamp", {0, 0, 255}, false, false, 50}});
}

}  // namespace semantic_slam
