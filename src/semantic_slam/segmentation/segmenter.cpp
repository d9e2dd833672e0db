#include "semantic_slam/segmentation/segmenter.h"

#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dnn/label_mapping.h"

namespace semantic_slam {
namespace {

const Model& CheckedModel(const Model& model) {
  if (model.card.head.type == HeadType::kSegmentation) return model;
  throw ConfigError(model.card.path + ": head/type is not segmentation");
}

// The size of the score map. Throws ConfigError if that is not what the network gives.
cv::Size CheckedCells(const Network& network, const Model& model) {
  const std::vector<Shape>& shapes = network.output_shapes();
  const int classes = static_cast<int>(model.classes.size());
  if (shapes.size() == 1 && shapes[0].size() == 4 && shapes[0][0] == 1 && shapes[0][1] == classes) {
    return {shapes[0][3], shapes[0][2]};
  }
  throw ConfigError(model.card.path + ": the network gives " + ToString(shapes) +
                    ", expected 1 x " + std::to_string(classes) + " x h x w scores of the " +
                    std::to_string(classes) + " classes in " + model.card.labels_file);
}

}  // namespace

Segmenter::Segmenter(const Model& model, const LabelVocabulary& vocabulary,
                     const NetworkOptions& options)
    : network_(CheckedModel(model), options),
      scores_(MapClassesToLabels(model, vocabulary), vocabulary, model.card.head.activation),
      input_(model.card.input.size()),
      cells_(CheckedCells(network_, model)),
      vocabulary_hash_(vocabulary.hash()) {}

Segmentation Segmenter::Segment(const cv::Mat& colour, ColourOrder order, Stamp stamp) {
  const std::vector<cv::Mat>& outputs = network_.Forward(colour, order);
  FollowSize(colour.size());
  Segmentation segmentation;
  segmentation.stamp = stamp;
  segmentation.vocabulary_hash = vocabulary_hash_;
  upsampler_->Upsample(scores_.ToProbabilities(outputs[0]), segmentation);
  return segmentation;
}

void Segmenter::FollowSize(cv::Size image) {
  if (upsampler_ && image_ == image) return;
  image_ = image;
  upsampler_.emplace(network_.FitOf(image), image, input_, cells_);
}

}  // namespace semantic_slam
