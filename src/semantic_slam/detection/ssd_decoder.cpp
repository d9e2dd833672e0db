#include "semantic_slam/detection/ssd_decoder.h"

#include <algorithm>

#include "semantic_slam/common/error.h"
#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {
namespace {

constexpr int kColumns = 7;
constexpr int kBackground = 0;

}  // namespace

SsdDecoder::SsdDecoder(const Model& model, const std::vector<Shape>& shapes)
    : classes_(static_cast<int>(model.classes.size())), unit_(UnitOf(model.card)) {
  if (shapes.size() == 1 && shapes[0].size() == 4 && shapes[0][3] == kColumns) return;
  throw ConfigError(model.card.path + ": the network gives " + ToString(shapes) +
                    ", expected one output of 1 x 1 x N x 7");
}

std::vector<NetworkBox> SsdDecoder::Decode(const std::vector<cv::Mat>& outputs,
                                           float min_confidence) const {
  std::vector<NetworkBox> boxes;
  const float* row = outputs[0].ptr<float>();
  const float* end = row + outputs[0].total() / kColumns * kColumns;
  for (; row != end; row += kColumns) {
    // NaN is not at least anything, and no class.
    const float class_index = row[1], score = row[2];
    if (!(score >= min_confidence && class_index > kBackground && class_index < classes_)) continue;
    const cv::Rect2f box = BoxOfCorners(row + 3, unit_);
    if (IsUsable(box)) boxes.push_back({static_cast<int>(class_index), std::min(score, 1.0f), box});
  }
  return boxes;
}

}  // namespace semantic_slam
