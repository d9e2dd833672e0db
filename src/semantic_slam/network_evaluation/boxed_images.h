#pragma once

#include <memory>
#include <string>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model_card.h"

namespace semantic_slam {

// A colour image and the file of the true boxes in it.
struct BoxedImage {
  std::string image_path;
  std::string boxes_path;  // in YOLO's format; may be missing: an image without objects
  std::shared_ptr<const std::vector<LabelId>> label_of_class;  // by the file's class numbers
};

// The images with true boxes of each set in turn. A set is
// - a rendered sequence (a folder with rgb.txt and boxes/STAMP.txt, class numbers are label ids) or
// a
//   folder with some below it; images without such a file are left out,
// - a data.yaml of YOLO's tools (names, train, val, test, path), or a folder with one; of that the
//   split `train`, `val` or `test`. Names map to labels as LabelOfName() says.
// Throws ConfigError naming a set that is neither or has no image, or what is wrong in its
// data.yaml; InputError naming a list that is not understood.
std::vector<BoxedImage> FindBoxedImages(const std::vector<std::string>& sets,
                                        const std::string& split, const ModelCard& card,
                                        const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
