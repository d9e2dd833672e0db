#include "semantic_slam/segmentation/label_upsampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace semantic_slam {
namespace {

// A label that can be among the most probable ones somewhere between four cells.
struct Candidate {
  LabelId label;
  std::array<float, 4> corners;  // top left, top right, bottom left, bottom right
};

using Corners = std::array<const float*, 4>;  // the four cells' probabilities

// Descending, the earlier of equals first; so it keeps the lower id if labels come in ascending
// order.
class Top {
 public:
  void Add(LabelId label, float value) {
    if (!(value > values_[kTopLabels - 1])) return;
    int place = kTopLabels - 1;
    for (; place > 0 && value > values_[place - 1]; --place) {
      values_[place] = values_[place - 1];
      labels_[place] = labels_[place - 1];
    }
    values_[place] = value;
    labels_[place] = label;
  }
  float value(int place) const { return values_[place]; }
  LabelId label(int place) const { return labels_[place]; }

 private:
  std::array<float, kTopLabels> values_{-1.0f, -1.0f, -1.0f};
  std::array<LabelId, kTopLabels> labels_{};
};

// The candidates between four cells, by ascending id. Keeps its buffers from one square to the
// next.
class CandidateFinder {
 public:
  explicit CandidateFinder(const std::vector<LabelId>& labels)
      : labels_(labels), least_(labels.size()), greatest_(labels.size()) {}

  const std::vector<Candidate>& Find(const Corners& corners) {
    const auto [a, b, c, d] = corners;
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      least_[i] = std::min(std::min(a[i], b[i]), std::min(c[i], d[i]));
      greatest_[i] = std::max(std::max(a[i], b[i]), std::max(c[i], d[i]));
    }
    Top surest;
    for (std::size_t i = 0; i < labels_.size(); ++i) surest.Add(labels_[i], least_[i]);
    const float needed = surest.value(kTopLabels - 1);
    candidates_.clear();
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      if (greatest_[i] >= needed) candidates_.push_back({labels_[i], {a[i], b[i], c[i], d[i]}});
    }
    return candidates_;
  }

 private:
  const std::vector<LabelId>& labels_;
  std::vector<float> least_;
  std::vector<float> greatest_;
  std::vector<Candidate> candidates_;
};

float Interpolate(float a, float b, float weight) {
  return a + weight * (b - a);
}

// The candidates along one row of pixels between the four cells, ready to be interpolated along it.
struct RowEnds {
  LabelId label;
  float left, right;
};

void InterpolateRow(const std::vector<RowEnds>& ends, const float* weights, int begin, int end,
                    const std::array<std::uint8_t*, kTopLabels>& labels,
                    const std::array<std::uint8_t*, kTopLabels>& confidences) {
  for (int u = begin; u < end; ++u) {
    Top top;
    for (const RowEnds& candidate : ends) {
      top.Add(candidate.label, Interpolate(candidate.left, candidate.right, weights[u]));
    }
    for (int place = 0; place < kTopLabels; ++place) {
      labels[place][u] = top.label(place);
      confidences[place][u] = ToByte(std::clamp(top.value(place), 0.0f, 1.0f));
    }
  }
}

std::array<std::uint8_t*, kTopLabels> RowsOf(std::array<cv::Mat, kTopLabels>& planes, int v) {
  return {planes[0].ptr(v), planes[1].ptr(v), planes[2].ptr(v)};
}

}  // namespace

LabelUpsampler::LabelUpsampler(const ImageFit& fit, cv::Size image, cv::Size input, cv::Size cells)
    : image_(image),
      x_(MakeAxis(image.width, fit.content().x, fit.content().width, input.width, cells.width)),
      y_(MakeAxis(image.height, fit.content().y, fit.content().height, input.height,
                  cells.height)) {}

LabelUpsampler::Axis LabelUpsampler::MakeAxis(int pixels, int content_begin, int content_size,
                                              int input, int cells) {
  assert(pixels > 0 && content_size > 0 && input > 0 && cells > 0);
  const double cells_per_input = static_cast<double>(cells) / input;
  // Coordinates of cells are those of their centres, as everywhere.
  const double begin = content_begin * cells_per_input - 0.5;
  const double step = content_size * cells_per_input / pixels;
  const double lowest = std::clamp(std::ceil(begin), 0.0, cells - 1.0);
  const double highest =
      std::clamp(std::floor(begin + content_size * cells_per_input), lowest, cells - 1.0);
  Axis axis;
  for (int pixel = 0; pixel < pixels; ++pixel) {
    const double at = std::clamp(begin + (pixel + 0.5) * step, lowest, highest);
    const int first = static_cast<int>(at);
    const int second = std::min(first + 1, static_cast<int>(highest));
    if (axis.spans.empty() || axis.spans.back().first != first) {
      axis.spans.push_back({pixel, pixel, first, second});
    }
    ++axis.spans.back().end;
    axis.weights.push_back(static_cast<float>(at - first));
  }
  return axis;
}

void LabelUpsampler::Upsample(const LabelProbabilities& probabilities,
                              Segmentation& segmentation) const {
  assert(probabilities.labels.size() >= static_cast<std::size_t>(kTopLabels));
  for (cv::Mat& plane : segmentation.labels) plane.create(image_, CV_8UC1);
  for (cv::Mat& plane : segmentation.confidences) plane.create(image_, CV_8UC1);
  CandidateFinder finder(probabilities.labels);
  std::vector<RowEnds> ends;
  for (const Span& y : y_.spans) {
    for (const Span& x : x_.spans) {
      const std::vector<Candidate>& candidates = finder.Find(
          {probabilities.Cell(x.first, y.first), probabilities.Cell(x.second, y.first),
           probabilities.Cell(x.first, y.second), probabilities.Cell(x.second, y.second)});
      for (int v = y.begin; v < y.end; ++v) {
        ends.clear();
        for (const auto& [label, corners] : candidates) {
          ends.push_back({label, Interpolate(corners[0], corners[2], y_.weights[v]),
                          Interpolate(corners[1], corners[3], y_.weights[v])});
        }
        InterpolateRow(ends, x_.weights.data(), x.begin, x.end, RowsOf(segmentation.labels, v),
                       RowsOf(segmentation.confidences, v));
      }
    }
  }
}

}  // namespace semantic_slam
