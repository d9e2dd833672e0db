#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// The folders with an rgb.txt at or below `root`, sorted.
std::vector<std::string> SequenceFolders(const std::string& root);

// The JPEG and PNG files right in a folder, by name; none if there is no such folder.
std::vector<std::string> ImagesIn(const std::string& folder);

// BGR, CV_8UC3, turned as its EXIF says: that is how people drew boxes and labels on it. Throws
// InputError naming a file that is missing or no image.
cv::Mat ReadColourImage(const std::string& path);

// Label ids, CV_8UC1, of a grey image of 8 or 16 bits; ids from 255 on become 255, which is no
// label. Throws InputError naming a file that is missing, no such image or not of `size`.
cv::Mat ReadLabelImage(const std::string& path, cv::Size size);

// At most `most` of the items, evenly spread, in their order; all if `most` is 0.
template <typename Item>
std::vector<Item> Spread(const std::vector<Item>& items, std::size_t most) {
  if (most == 0 || items.size() <= most) return items;
  std::vector<Item> chosen;
  for (std::size_t i = 0; i < most; ++i) chosen.push_back(items[i * items.size() / most]);
  return chosen;
}

}  // namespace semantic_slam
