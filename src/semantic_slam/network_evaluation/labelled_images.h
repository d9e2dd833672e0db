#pragma once

#include <string>
#include <vector>

namespace semantic_slam {

// A colour image and the image of its true label ids.
struct LabelledImage {
  std::string image_path;
  std::string labels_path;
};

// The images with true labels of each set in turn; those without are left out. A set is
// - a rendered sequence (a folder with rgb.txt and labels.txt) or a folder with some below it,
// - a folder with images/NAME.jpg or .png and labels/NAME.png,
// - SUN RGB-D in one of the two layouts that training/README.md names; of that the split `train` or
//   `test`.
// Throws ConfigError naming a set that is none of these or has no image, InputError naming a list
// that is not understood.
std::vector<LabelledImage> FindLabelledImages(const std::vector<std::string>& sets,
                                              const std::string& split);

}  // namespace semantic_slam
