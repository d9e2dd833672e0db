#pragma once

#include <string>
#include <vector>

namespace semantic_slam {

// What a data.yaml of YOLO's tools or Roboflow says of one split.
struct YoloData {
  std::vector<std::string> names;   // of the classes, by their number
  std::vector<std::string> images;  // paths
};

// Reads `names` (a list, or a mapping of numbers) and the split: a folder of images, or a .txt file
// that lists them, looked for in the folder that `path:` names if it does, beside the file, and there
// without a leading "../", as Roboflow writes it. Keys that only training needs are passed over.
// Throws ConfigError naming the file if either is missing or not understood.
YoloData ReadYoloData(const std::string& path, const std::string& split);

}  // namespace semantic_slam
