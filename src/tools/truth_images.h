#pragma once

#include <map>
#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/detection/detections.h"
#include "semantic_slam/segmentation/segmentation.h"

// What render_sequence has written beside a sequence's images, in place of networks.

namespace semantic_slam {

// The true labels of a sequence's images. For one thread.
class TrueLabels {
 public:
  // Throws InputError if the folder has no labels.txt, or it is not understood.
  TrueLabels(const std::string& folder, const LabelVocabulary& vocabulary);

  // As a network that is sure. Throws InputError if there are none for that image, or they are
  // damaged, of another size or not of the vocabulary.
  Segmentation Find(const cv::Mat& colour, Stamp stamp) const;

 private:
  const LabelVocabulary vocabulary_;
  std::map<Stamp, std::string> files_;
};

// The true boxes of a sequence's images. For one thread.
class TrueBoxes {
 public:
  // Throws InputError if the folder has no boxes.
  TrueBoxes(const std::string& folder, const LabelVocabulary& vocabulary);

  // As a network that is sure. Throws InputError if there are none for that image, or they are
  // damaged or not of the vocabulary.
  Detections Find(const cv::Mat& colour, Stamp stamp) const;

 private:
  const std::string folder_;
  const LabelVocabulary vocabulary_;
};

}  // namespace semantic_slam
