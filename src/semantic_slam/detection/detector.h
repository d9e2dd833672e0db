#pragma once

#include <memory>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/detection/box_decoder.h"
#include "semantic_slam/detection/detections.h"
#include "semantic_slam/dnn/model.h"
#include "semantic_slam/dnn/network.h"

namespace semantic_slam {

struct DetectorOptions {
  double min_confidence = 0.25;  // of a box; the object tracker likes them low, down to 0.1
  double max_overlap = 0.5;  // intersection over union; of two that overlap more the surer stays
  int max_detections = 100;  // per image; the surest stay

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("min_confidence", self.min_confidence, 0.001, 1.0);
    visit("max_overlap", self.max_overlap, 0.0, 1.0);
    visit("max_detections", self.max_detections, 1, 10000);
  }
};

// Finds objects in colour images with a detection network (thesis section 3.4.1): any whose output
// a model card can describe. Not thread-safe: one thread at a time.
class Detector {
 public:
  // Throws ConfigError if an option is out of range, the card is not one of detection, the network
  // cannot be run or does not give what the card says, or its classes do not map to the vocabulary.
  Detector(const Model& model, const LabelVocabulary& vocabulary,
           const NetworkOptions& network_options, const DetectorOptions& options);

  // The objects in `colour` (CV_8UC3, raw pixels), by descending confidence. Boxes are in its
  // pixels, (0, 0) the centre of the top left one, and cut at its edges, which lie at -0.5 and at
  // width - 0.5, height - 0.5. Objects of classes without a label are called unknown. Throws
  // InputError if the image is empty or of another type.
  Detections Detect(const cv::Mat& colour, ColourOrder order, Stamp stamp);

 private:
  // Boxes of one class that overlap are one object, and so are those of two classes of one label.
  std::vector<NetworkBox> SuppressWithinClasses(const std::vector<NetworkBox>& boxes) const;
  std::vector<DetectedBox> SuppressWithinLabels(const std::vector<DetectedBox>& boxes) const;
  std::vector<DetectedBox> ToImage(const std::vector<NetworkBox>& boxes, cv::Size image) const;

  const DetectorOptions options_;
  Network network_;
  const std::unique_ptr<const BoxDecoder> decoder_;
  const std::vector<LabelId> class_labels_;
  const std::uint64_t vocabulary_hash_;
};

}  // namespace semantic_slam
