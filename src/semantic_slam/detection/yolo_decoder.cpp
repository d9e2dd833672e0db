#include "semantic_slam/detection/yolo_decoder.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {
namespace {

constexpr int kBoxColumns = 4;
constexpr int kObjectnessColumn = 4;

int FirstScoreColumn(const NetworkHead& head) {
  return head.objectness == Objectness::kNone ? kBoxColumns : kBoxColumns + 1;
}

float Activated(float score, Activation activation) {
  return activation == Activation::kSigmoid ? 1.0f / (1.0f + std::exp(-score)) : score;
}

// The number of columns of an output [..., N, columns] or, transposed, [..., columns, N]; -1 if the
// leading sizes are not 1.
int ColumnsOf(const Shape& shape, bool transposed) {
  if (shape.size() < 2) return -1;
  const bool is_matrix = std::all_of(shape.begin(), shape.end() - 2, [](int n) { return n == 1; });
  return is_matrix ? *(shape.end() - (transposed ? 2 : 1)) : -1;
}

}  // namespace

YoloDecoder::YoloDecoder(const Model& model, const std::vector<Shape>& shapes)
    : head_(model.card.head),
      classes_(static_cast<int>(model.classes.size())),
      columns_(FirstScoreColumn(head_) + classes_),
      unit_(UnitOf(model.card)) {
  for (std::size_t i = 0; i < head_.strides.size(); ++i) {
    grids_.emplace_back(head_.strides[i], head_.anchors[i], columns_);
  }
  CheckShapes(model, shapes);
}

void YoloDecoder::CheckShapes(const Model& model, const std::vector<Shape>& shapes) {
  const auto columns = [&](std::size_t i) { return ColumnsOf(shapes[i], head_.transposed); };
  side_by_side_ = grids_.empty() && shapes.size() == 2 && columns(0) == kBoxColumns &&
                  columns(1) == columns_ - kBoxColumns;
  bool fits = side_by_side_ || grids_.empty() || grids_.size() == shapes.size();
  for (std::size_t i = 0; fits && !side_by_side_ && i < shapes.size(); ++i) {
    fits = grids_.empty() ? columns(i) == columns_ : grids_[i].Fits(shapes[i]);
  }
  if (fits && !shapes.empty()) return;
  throw ConfigError(model.card.path + ": the network gives " + ToString(shapes) +
                    ", but the card's head with the " + std::to_string(classes_) + " classes in " +
                    model.card.labels_file + " makes " + std::to_string(columns_) +
                    " columns per box" + (head_.transposed ? ", transposed" : ""));
}

std::vector<NetworkBox> YoloDecoder::Decode(const std::vector<cv::Mat>& outputs,
                                            float min_confidence) const {
  std::vector<NetworkBox> boxes;
  if (side_by_side_) {
    cv::Mat rows;
    cv::hconcat(Rows(outputs[0]), Rows(outputs[1]), rows);
    DecodeRows(rows, min_confidence, boxes);
    return boxes;
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    DecodeRows(grids_.empty() ? Rows(outputs[i]) : grids_[i].Decode(outputs[i]), min_confidence,
               boxes);
  }
  return boxes;
}

cv::Mat YoloDecoder::Rows(const cv::Mat& output) const {
  const int dims = output.dims;
  const cv::Mat matrix(output.size[dims - 2], output.size[dims - 1], CV_32F,
                       const_cast<float*>(output.ptr<float>()));
  return head_.transposed ? cv::Mat(matrix.t()) : matrix;
}

void YoloDecoder::DecodeRows(const cv::Mat& rows, float min_confidence,
                             std::vector<NetworkBox>& boxes) const {
  const int first_score = FirstScoreColumn(head_);
  for (int i = 0; i < rows.rows; ++i) {
    const float* row = rows.ptr<float>(i);
    float objectness = 1.0f;
    if (head_.objectness == Objectness::kSeparate) {
      objectness = Activated(row[kObjectnessColumn], head_.activation);
      if (!(objectness >= min_confidence)) continue;  // NaN is not at least anything
    }
    int best = -1;
    for (int k = 0; k < classes_; ++k) {
      const float score = row[first_score + k];
      if (best < 0 ? !std::isnan(score) : score > row[first_score + best]) best = k;
    }
    if (best < 0) continue;
    const float confidence = objectness * Activated(row[first_score + best], head_.activation);
    const cv::Rect2f box =
        head_.box == BoxFormat::kXyxy ? BoxOfCorners(row, unit_) : BoxOfCentre(row, unit_);
    if (!(confidence >= min_confidence) || !IsUsable(box)) continue;
    boxes.push_back({best, std::min(confidence, 1.0f), box});
  }
}

}  // namespace semantic_slam
