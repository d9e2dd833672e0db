#include "semantic_slam/detection/detector.h"

#include <algorithm>

#include "semantic_slam/detection/box_geometry.h"
#include "semantic_slam/detection/non_maximum_suppression.h"
#include "semantic_slam/dnn/label_mapping.h"

namespace semantic_slam {
namespace {

// More candidates than this are no objects but a threshold that is too low; suppression takes time
// with the square of their number.
constexpr std::size_t kMaxCandidates = 1000;

void KeepSurest(std::vector<NetworkBox>& boxes, std::size_t count) {
  if (boxes.size() <= count) return;
  std::stable_sort(boxes.begin(), boxes.end(), [](const NetworkBox& a, const NetworkBox& b) {
    return a.confidence > b.confidence;
  });
  boxes.resize(count);
}

template <typename Box>
std::vector<Box> Selected(const std::vector<Box>& boxes, const std::vector<int>& indices) {
  std::vector<Box> selected;
  selected.reserve(indices.size());
  for (const int i : indices) selected.push_back(boxes[i]);
  return selected;
}

}  // namespace

Detector::Detector(const Model& model, const LabelVocabulary& vocabulary,
                   const NetworkOptions& network_options, const DetectorOptions& options)
    : options_(Validated(options)),
      network_(model, network_options),
      decoder_(MakeBoxDecoder(model, network_.output_shapes())),
      class_labels_(MapClassesToLabels(model, vocabulary)),
      vocabulary_hash_(vocabulary.hash()) {}

Detections Detector::Detect(const cv::Mat& colour, ColourOrder order, Stamp stamp) {
  std::vector<NetworkBox> candidates = decoder_->Decode(
      network_.Forward(colour, order), static_cast<float>(options_.min_confidence));
  KeepSurest(candidates, kMaxCandidates);
  Detections detections;
  detections.stamp = stamp;
  detections.vocabulary_hash = vocabulary_hash_;
  detections.image_size = colour.size();
  detections.boxes =
      SuppressWithinLabels(ToImage(SuppressWithinClasses(candidates), colour.size()));
  const auto limit = static_cast<std::size_t>(options_.max_detections);
  if (detections.boxes.size() > limit) detections.boxes.resize(limit);
  return detections;
}

std::vector<NetworkBox> Detector::SuppressWithinClasses(
    const std::vector<NetworkBox>& boxes) const {
  std::vector<ScoredBox> scored;
  scored.reserve(boxes.size());
  for (const NetworkBox& box : boxes) scored.push_back({box.box, box.confidence, box.class_index});
  return Selected(boxes, SuppressNonMaxima(scored, options_.max_overlap));
}

std::vector<DetectedBox> Detector::SuppressWithinLabels(
    const std::vector<DetectedBox>& boxes) const {
  std::vector<ScoredBox> scored;
  scored.reserve(boxes.size());
  for (const DetectedBox& box : boxes) scored.push_back({box.box, box.confidence, box.label});
  return Selected(boxes, SuppressNonMaxima(scored, options_.max_overlap));
}

std::vector<DetectedBox> Detector::ToImage(const std::vector<NetworkBox>& boxes,
                                           cv::Size image) const {
  const ImageFit fit = network_.FitOf(image);
  std::vector<DetectedBox> in_image;
  for (const NetworkBox& found : boxes) {
    if (const auto box = PartInImage(found.box, fit, image)) {
      in_image.push_back({class_labels_[found.class_index], found.confidence, *box});
    }
  }
  return in_image;
}

}  // namespace semantic_slam
