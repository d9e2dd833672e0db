#pragma once

#include <array>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/image_fit.h"
#include "semantic_slam/segmentation/label_probabilities.h"
#include "semantic_slam/segmentation/segmentation.h"

namespace semantic_slam {

// Interpolates label probabilities bilinearly at every pixel of an image and keeps the highest
// three. Softmax comes first and interpolation second, because that costs a sixteenth of the
// exponentials at an output stride of 4, and the interpolated values remain probabilities.
//
// Exact, yet it looks at few labels: within the square between four neighbouring cells a label lies
// between the least and the greatest of its four values, so only those whose greatest reaches the
// third highest least value can be among the three.
class LabelUpsampler {
 public:
  // `fit` says where the image lies in the network's input, of size `input`; cells whose centre
  // lies in the padding have no say. Precondition: `cells` is positive.
  LabelUpsampler(const ImageFit& fit, cv::Size image, cv::Size input, cv::Size cells);

  // Fills the label and confidence planes of `segmentation`, at the image's size. Of equally
  // probable labels the lower id comes first. Precondition: `probabilities` is of the size `cells`
  // and has at least kTopLabels labels.
  void Upsample(const LabelProbabilities& probabilities, Segmentation& segmentation) const;

 private:
  // Neighbouring pixels, along one axis, that are interpolated between the same two cells.
  struct Span {
    int begin, end;     // pixels
    int first, second;  // cells
  };
  struct Axis {
    std::vector<Span> spans;
    std::vector<float> weights;  // per pixel: of its second cell
  };
  static Axis MakeAxis(int pixels, int content_begin, int content_size, int input, int cells);

  const cv::Size image_;
  Axis x_;
  Axis y_;
};

}  // namespace semantic_slam
